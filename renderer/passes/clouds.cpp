#include "renderer/passes/clouds.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace renderer {
namespace {

constexpr int kSteps = 88;      // of a ray through the volumes at most, most of them in clouds
constexpr int kLeastPixels = 2; // of the picture along a side of one of the clouds'

} // namespace

CloudPass::CloudPass(ShaderLibrary& shaders)
    : m_shaders{shaders}, m_noise{shaders},
      m_map{{.label = "cloud shadows", .size = glm::ivec2{CLOUD_MAP_SIZE}, .format = GL_R8, .target = true}},
      m_mapTarget{{.label = "cloud shadows", .colours = {&m_map}}}
{
    shaders.fullScreen("cloud_map");
}

void CloudPass::update(GpuFrame& gpu, const glsl::Clouds& clouds, CloudKind kind, bool exact)
{
    m_clouds = clouds;
    m_kind = kind;
    gpu.constants(CLOUDS_BINDING, clouds);
    if (clouds.on > 0) {
        const auto scope = gpu.scope("cloud shadows");
        m_noise.makeOnce(gpu);
        m_noise.bind();
        if (exact) m_drawn.reset();
        drawMap(gpu);
    }
    gpu.bind({{CLOUD_MAP_UNIT, &m_map}});
}

// The map lies in the field, so drifting changes nothing of it until it has gone a texel. What changes slowly may be a little late:
// shapes by half a second, the sun by a seventh of a degree.
bool CloudPass::sameShadows(const Drawn& a, const Drawn& b)
{
    if (a.middle != b.middle || a.kind != b.kind) return false;
    if (glm::distance(a.clouds.phase, b.clouds.phase) > 0.0012f || glm::distance(a.clouds.sunward, b.clouds.sunward) > 0.0025f) return false;
    glsl::Clouds same = a.clouds;
    same.origin = b.clouds.origin, same.map = b.clouds.map, same.phase = b.clouds.phase, same.sunward = b.clouds.sunward;
    same.base = b.clouds.base, same.planet = b.clouds.planet, same.sun = b.clouds.sun;
    return std::memcmp(&same, &b.clouds, sizeof same) == 0;
}

void CloudPass::drawMap(GpuFrame& gpu)
{
    constexpr double kTexel = double(CLOUD_MAP_METRES) / CLOUD_MAP_SIZE;
    const glm::dvec2 middle = glm::dvec2{m_clouds.origin} / double(m_clouds.perMetre) + glm::dvec2{m_clouds.map};
    const Drawn now{m_clouds, glm::ivec2{glm::round(middle / kTexel)}, m_kind};
    if (m_drawn && sameShadows(*m_drawn, now)) return;
    m_drawn = now;
    std::vector<std::string> defines;
    if (m_kind == CloudKind::Volume) defines.emplace_back("VOLUME");
    m_mapTarget.bind();
    gpu.fullScreen(m_shaders.fullScreen("cloud_map", std::move(defines)), {}, {});
}

void CloudPass::resize(glm::ivec2 size)
{
    if (m_image.size() == size) return;
    m_image = gl::Texture{{.label = "clouds", .size = size, .format = GL_RGBA16F, .target = true}};
    m_distances = gl::Texture{{.label = "clouds' distances", .size = size, .format = GL_RGBA16F, .filter = GL_NEAREST, .target = true}};
    m_imageTarget = gl::Framebuffer{{.label = "clouds", .colours = {&m_image, &m_distances}}};
}

void CloudPass::render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const Settings& settings)
{
    if (m_clouds.on <= 0 || areInSky()) return;
    const auto scope = gpu.scope("clouds");
    const int span = std::max(settings.skyPixels, kLeastPixels);
    resize((radiance.texture.size() + span - 1) / span);
    std::vector<std::string> defines{fmt::format("SPAN {}", span), fmt::format("STEPS {}", kSteps)};
    if (m_kind == CloudKind::Layer) defines.emplace_back("LAYER");
    surfaces.bind(gpu);
    m_imageTarget.bind();
    gpu.fullScreen(m_shaders.fullScreen("clouds", std::move(defines)), {}, {});
    radiance.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("clouds_over", {fmt::format("SPAN {}", span)}), {.blend = gl::Blend::Over},
                   {{CLOUD_IMAGE_UNIT, &m_image}, {IMAGE_UNIT, &m_distances}});
}

} // namespace renderer
