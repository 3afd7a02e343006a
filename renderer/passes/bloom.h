// Light that the lens scatters: the picture, blurred by a pyramid of ever smaller ones. No threshold, and it keeps the sum
// of light: tone mapping mixes a share of it in.
#pragma once

#include "renderer/gpu_frame.h"
#include "renderer/shader_library.h"

namespace renderer {

class BloomPass {
public:
    explicit BloomPass(ShaderLibrary& shaders);

    // `coarse`: begins at a quarter of the size, not at half. The answer stays valid until the next call.
    const gl::Texture& render(GpuFrame& gpu, const gl::Texture& radiance, bool coarse);

private:
    void resize(glm::ivec2 size, bool coarse);

    struct Level {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    const gl::Program &m_first, &m_firstCoarse, &m_down, &m_up;
    std::vector<Level> m_levels;
    glm::ivec2 m_size{0};
    bool m_coarse = false;
};

} // namespace renderer
