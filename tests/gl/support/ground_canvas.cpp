#include "tests/gl/support/ground_canvas.h"

#include "io/scene/scene.h"
#include "renderer/cascades.h"
#include "renderer/eye.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>

namespace test {

GroundCanvas::GroundCanvas(glm::ivec2 size, renderer::TerrainLimits limits)
    : m_size{size}, m_shaders{WOLD_SOURCE_DIR "/renderer/shaders"}, m_empty{"empty"},
      m_colour{{.label = "places", .size = size, .format = GL_RGBA32F, .filter = GL_NEAREST, .target = true}},
      m_depth{{.label = "depth", .size = size, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST, .target = true}},
      m_target{{.label = "ground alone", .colours = {&m_colour}, .depth = &m_depth}}, m_terrain{limits}
{
}

void GroundCanvas::load(std::shared_ptr<const io::HeightMap> map)
{
    io::Scene scene;
    scene.exchange(std::move(map));
    m_terrain.update(scene, {}, {.everything = true});
}

template <class Draw>
int GroundCanvas::draw(const renderer::Eye& eye, const renderer::Eye& levelsFor, By by, Draw&& draws, std::vector<glm::vec4>& places)
{
    const bool sun = by == By::Sun;
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    m_stream.beginFrame();
    {
        renderer::GpuFrame gpu{m_stream, m_timers, m_stats, m_empty};
        gpu.constants(VIEW_BINDING, renderer::viewBlock(eye, eye.clipFromRelative, 0, 1));
        m_target.clearColour(0, kNothing);
        m_target.clearDepth(0);
        m_target.bind();
        m_terrain.aim(eye, levelsFor, errorPixels);
        triangles = 0;
        for (const renderer::Terrain::Draw& part : draws()) {
            triangles += part.triangles;
            if (!gpu.use(m_shaders.program(m_terrain.program("ground alone", part.stages, "../../tests/gl/support/place.frag.glsl")))) continue;
            renderer::gl::apply({.depthTest = GL_GREATER, .depthWrite = true, .cull = GLenum(sun ? GL_NONE : GL_BACK), .depthClamp = sun});
            sun ? m_terrain.bindForShadows(gpu) : m_terrain.bind(gpu);
            m_terrain.draw(gpu, part);
        }
    }
    m_stream.endFrame();
    places.resize(std::size_t(m_size.x) * m_size.y);
    glGetTextureImage(m_colour.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(places.size() * sizeof(places[0])), places.data());
    renderer::gl::restoreDefaults();
    return int(std::ranges::count(places, kNothing));
}

int GroundCanvas::holes(const renderer::Eye& eye, const renderer::Eye& levelsFor, renderer::GroundStages stages, std::vector<glm::vec4>* places)
{
    std::vector<glm::vec4> own;
    return draw(eye, levelsFor, By::Camera, [&] { return m_terrain.draws(m_stream, culled ? std::optional{renderer::volumeOf(eye)} : std::nullopt, stages); }, places ? *places : own);
}

int GroundCanvas::holesForSun(const glm::dvec3& towardSun, const glm::dvec3& middle, double width, double texel)
{
    constexpr double kDeep = 5000; // m
    const glm::dmat3 axes = renderer::lightAxes(towardSun);
    glm::dmat4 clip{1};
    for (int axis = 0; axis < 3; ++axis)
        clip[axis] = {axes[axis].x * 2 / width, axes[axis].y * 2 / width, axes[axis].z / kDeep, 0};
    clip[3] = {0, 0, 0.5, 1};
    const renderer::Eye eye{.position = middle, .clipFromRelative = clip, .size = m_size};
    std::vector<glm::vec4> places;
    return draw(eye, eye, By::Sun, [&] { return renderer::Terrain::Draws{m_terrain.shadowDraw(m_stream, std::nullopt, texel)}; }, places);
}

} // namespace test
