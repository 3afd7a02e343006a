#include "tests/gl/support/cloud_canvas.h"

#include "renderer/light.h"
#include "renderer/shaders/shared/bindings.h"

namespace test {

CloudCanvas::CloudCanvas(glm::ivec2 size)
    : m_shaders{WOLD_SOURCE_DIR "/renderer/shaders"}, m_empty{"empty"},
      m_values{{.label = "values", .size = size, .format = GL_RGBA32F, .filter = GL_NEAREST, .target = true}},
      m_target{{.label = "values", .colours = {&m_values}}}, m_clouds{m_shaders}, m_sky{m_shaders}
{
}

std::vector<glm::vec4> CloudCanvas::draw(const std::string& probe, const io::Environment& environment, double time,
                                         renderer::CloudKind kind, const glm::dvec3& place)
{
    const renderer::Eye eye = renderer::eyeOf({.eye = place}, m_values.size());
    const renderer::Settings settings;
    const renderer::Bodies bodies = renderer::bodiesOf(environment);
    const glsl::Heavens heavens = renderer::heavensOf(environment, bodies);
    const glsl::Light light = renderer::lightOf({.environment = environment, .settings = settings, .eye = eye, .bodies = bodies, .time = time});
    const glsl::Clouds clouds = renderer::cloudsOf(environment, light, eye, time);
    {
        renderer::GpuFrame gpu{m_stream, m_timers, m_stats, m_empty};
        gpu.constants(VIEW_BINDING, renderer::viewBlock(eye, eye.clipFromRelative, time, 1));
        gpu.constants(LIGHT_BINDING, light);
        gpu.constants(HEAVENS_BINDING, heavens);
        m_clouds.update(gpu, clouds, kind);
        m_sky.update(gpu, light, heavens, clouds);
        m_target.bind();
        gpu.fullScreen(m_shaders.program({.label = probe, .stages = {"full_screen.vert.glsl", "../../tests/gl/support/" + probe + ".frag.glsl"}}),
                       {}, {});
    }
    std::vector<glm::vec4> values(std::size_t(m_values.size().x) * m_values.size().y);
    glGetTextureImage(m_values.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(values.size() * sizeof(values[0])), values.data());
    return values;
}

} // namespace test
