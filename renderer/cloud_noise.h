// The noise that clouds are made of: two tiling textures in space, made once, when the first cloud is drawn.
#pragma once

#include "renderer/gl/volume_texture.h"
#include "renderer/gpu_frame.h"
#include "renderer/shader_library.h"

#include <cstdint>
#include <span>

namespace renderer {

// Replaces values by their ranks, so that they lie evenly between 0 and 255: a share of the world then tells the value that it
// exceeds. `channel` of `channels` interleaved ones.
void spreadEvenly(std::span<std::uint8_t> texels, int channels, int channel);

class CloudNoise {
public:
    explicit CloudNoise(ShaderLibrary& shaders);
    void makeOnce(GpuFrame& gpu);
    void bind() const;

private:
    const gl::Program &m_shapeProgram, &m_detailProgram;
    gl::VolumeTexture m_shape, m_detail;
};

} // namespace renderer
