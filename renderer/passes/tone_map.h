// From radiance to the picture: bloom, exposure, lens and film, the curve, sRGB, dithering.
#pragma once

#include "renderer/passes/picture.h"
#include "renderer/shaders/shared/film.h"

namespace renderer {

class ToneMapPass {
public:
    explicit ToneMapPass(ShaderLibrary& shaders);

    struct Input {
        const gl::Texture& radiance;
        const gl::Texture* bloom = nullptr; // null: none is mixed in
        const GBuffer& surfaces;
        const glsl::Film& film;
        bool chosenExposure = false; // by the GPU, in the block bound for that
    };
    void render(GpuFrame& gpu, PictureTarget& canvas, const Input& in, const Settings& settings);

private:
    ShaderLibrary& m_shaders;
};

} // namespace renderer
