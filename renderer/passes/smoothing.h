// Edges of the finished picture, smoothed by what can be seen in it alone: FXAA, or SMAA 1x.
#pragma once

#include "renderer/passes/picture.h"

namespace renderer {

class SmoothingPass {
public:
    explicit SmoothingPass(ShaderLibrary& shaders);

    // Where the picture is to be drawn first: `canvas` itself when nothing is to be smoothed.
    PictureTarget& begin(PictureTarget& canvas, AntiAliasing kind);
    void finish(GpuFrame& gpu, PictureTarget& canvas, AntiAliasing kind); // what was drawn there, smoothed

private:
    void findEdges(GpuFrame& gpu);

    struct Target {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
        void resize(std::string_view label, glm::ivec2 size, GLenum format);
    };
    const gl::Program& m_fxaa;
    ShaderLibrary& m_shaders;
    PictureTarget m_rough;    // brightness in alpha
    Target m_edges, m_weights;
};

} // namespace renderer
