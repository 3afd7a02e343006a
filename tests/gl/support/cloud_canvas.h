// The clouds' own GLSL on a canvas, without a picture around it: what they hide, and what their map of shadows says.
#pragma once

#include "renderer/clouds.h"
#include "renderer/gl/framebuffer.h"
#include "renderer/passes/clouds.h"
#include "renderer/passes/sky_tables.h"

#include <vector>

namespace test {

class CloudCanvas {
public:
    explicit CloudCanvas(glm::ivec2 size);

    // What tests/gl/support/<probe>.frag.glsl writes, one vec4 a pixel.
    std::vector<glm::vec4> draw(const std::string& probe, const io::Environment& environment, double time,
                                renderer::CloudKind kind, const glm::dvec3& eye = {0, 2, 0});

private:
    renderer::ShaderLibrary m_shaders;
    renderer::GpuStream m_stream;
    renderer::PassTimers m_timers;
    renderer::FrameStats m_stats;
    renderer::gl::VertexArray m_empty;
    renderer::gl::Texture m_values;
    renderer::gl::Framebuffer m_target;
    renderer::CloudPass m_clouds;
    renderer::SkyTables m_sky;
};

} // namespace test
