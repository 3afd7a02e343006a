#include "renderer/passes/shafts.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr double kRange = 2;              // of froxels, in distances of the shadows: mountains throw theirs farther
constexpr double kLeastRange = 200, kMostRange = 4000; // m
constexpr double kFadeFrom = 0.05, kFadeTo = 0.7; // how far outside of the picture the sun may stand, of its size

struct SunOnScreen {
    glm::dvec2 place{0.5};
    double strength = 0; // 1 in the picture, 0 far from it
};

SunOnScreen sunOnScreen(const Eye& eye, const glm::dvec3& towardSun)
{
    const double ahead = glm::dot(towardSun, eye.forward);
    if (ahead <= 0.05) return {};
    const glm::dvec2 ndc = glm::dvec2{glm::dot(towardSun, eye.right) / eye.aspect, glm::dot(towardSun, eye.up)} / (ahead * eye.tanHalfFov);
    const glm::dvec2 place = ndc * 0.5 + 0.5;
    const glm::dvec2 outside = glm::max(glm::abs(place - 0.5) - 0.5, glm::dvec2{0});
    return {place, 1 - glm::smoothstep(kFadeFrom, kFadeTo, std::max(outside.x, outside.y))};
}

} // namespace

const char* shaftsDefine(Shafts kind)
{
    return kind == Shafts::Volume ? "SHAFTS_VOLUME" : kind == Shafts::Screen ? "SHAFTS_SCREEN" : nullptr;
}

void addHaze(std::vector<std::string>& defines, const Viewpoint& viewpoint)
{
    if (viewpoint.light.fogDensity > 0) defines.emplace_back("FOG");
    if (const char* shafts = shaftsDefine(viewpoint.shafts)) defines.emplace_back(shafts);
}

void addShafts(Viewpoint& viewpoint, const io::Fog& fog, const Settings& settings)
{
    viewpoint.shafts = Shafts::None;
    if (!settings.shafts || fog.shafts <= 0 || viewpoint.light.fogDensity <= 0 || viewpoint.light.sunIrradiance == glm::vec3{0}) return;
    const SunOnScreen sun = sunOnScreen(viewpoint.eye, viewpoint.towardSun);
    const bool volume = settings.froxels && !viewpoint.cascades.empty();
    const bool clouded = viewpoint.light.cloudsOn > 0;
    if (!volume && sun.strength <= 0 && !clouded) return;
    viewpoint.shafts = volume ? Shafts::Volume : Shafts::Screen;
    const double end = viewpoint.cascades.empty() ? 0 : viewpoint.cascades.back().end;
    viewpoint.shaftConstants = {.sun = glm::vec2{sun.place},
                                .strength = float(fog.shafts * (volume ? 1.0 : sun.strength)),
                                .range = float(std::clamp(end * kRange, kLeastRange, kMostRange)),
                                .clouds = clouded ? fog.shafts : 0};
}

ShaftsPass::ShaftsPass(ShaderLibrary& shaders) : m_shaders{shaders} {}

void ShaftsPass::render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const Viewpoint& viewpoint, const Settings& settings)
{
    if (viewpoint.shafts == Shafts::None) return;
    const auto scope = gpu.scope("shafts");
    gpu.constants(PICTURE_BINDING, viewpoint.shaftConstants);
    if (viewpoint.shafts == Shafts::Volume) fillVolume(gpu, viewpoint, settings);
    else lookAtScreen(gpu, surfaces, viewpoint.shaftConstants.clouds > 0);
    apply(gpu, radiance, surfaces, viewpoint.shafts);
}

void ShaftsPass::fillVolume(GpuFrame& gpu, const Viewpoint& viewpoint, const Settings& settings)
{
    if (!m_volume) {
        m_volume = gl::VolumeTexture{{.label = "shafts", .size = {SHAFTS_WIDTH, SHAFTS_HEIGHT, SHAFTS_SLICES}, .format = GL_RGBA16F}};
        for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
            glTextureParameteri(m_volume.id(), axis, GL_CLAMP_TO_EDGE);
    }
    const gl::Program& program =
        m_shaders.program({.label = "shafts", .stages = {"shafts.comp.glsl"}, .defines = lightingDefines(viewpoint, settings)});
    if (!gpu.use(program)) return;
    m_volume.bindImage(0);
    glDispatchCompute((SHAFTS_WIDTH + 7) / 8, (SHAFTS_HEIGHT + 7) / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    m_volume.bind(SHAFTS_UNIT);
}

void ShaftsPass::lookAtScreen(GpuFrame& gpu, const GBuffer& surfaces, bool clouded)
{
    const glm::ivec2 size = (surfaces.depth.size() + SHAFTS_PIXELS - 1) / SHAFTS_PIXELS;
    if (m_small.size() != size) {
        m_small = gl::Texture{{.label = "shafts", .size = size, .format = GL_RGBA16F, .target = true}};
        m_smallTarget = gl::Framebuffer{{.label = "shafts", .colours = {&m_small}}};
    }
    m_smallTarget.bind();
    std::vector<std::string> defines;
    if (clouded) defines.emplace_back("CLOUD_SHADOWS");
    gpu.fullScreen(m_shaders.fullScreen("shafts_screen", std::move(defines)), {}, {{GBUFFER_DEPTH_UNIT, &surfaces.depth}});
    gpu.bind({{SHAFTS_UNIT, &m_small}});
}

void ShaftsPass::apply(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, Shafts kind)
{
    if (m_radiance != radiance.texture.id()) {
        m_colourOnly = gl::Framebuffer{{.label = "radiance without depth", .colours = {&radiance.texture}}};
        m_radiance = radiance.texture.id();
    }
    m_colourOnly.bind();
    gpu.fullScreen(m_shaders.fullScreen("shafts_apply", {shaftsDefine(kind)}), {.blend = gl::Blend::Add},
                   {{GBUFFER_DEPTH_UNIT, &surfaces.depth}});
}

} // namespace renderer
