// Anti-aliasing over time: each frame is drawn a part of a pixel aside, and what they saw is gathered.
#pragma once

#include "renderer/passes/lighting.h"

namespace renderer {

constexpr int kTemporalFrames = 16; // that are gathered; then they are drawn aside as before

// By which a frame is moved aside, of the picture's half size; the first not at all.
glm::dvec2 jitterOf(int frame, glm::ivec2 size);

class TemporalPass {
public:
    explicit TemporalPass(ShaderLibrary& shaders);

    // `last` is the eye of the frame that was gathered before this one, `frame` its number since there was one: 0 starts anew.
    const gl::Texture& render(GpuFrame& gpu, const Radiance& radiance, const GBuffer& surfaces, const Eye& eye, const Eye& last, int frame);
    void forget(); // gives its memory back

private:
    struct Target {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    ShaderLibrary& m_shaders;
    Target m_gathered, m_next;
};

} // namespace renderer
