#include "renderer/passes/lighting.h"

#include "renderer/passes/occlusion.h"
#include "renderer/shaders/shared/bindings.h"

namespace renderer {
namespace {

// The triangle lies at depth 0, the far end: nearer surfaces hold more, the bare sky holds 0.
constexpr GLenum kWhereSurfacesAre = GL_LESS;
constexpr GLenum kWhereSkyIs = GL_EQUAL;

} // namespace

std::vector<std::string> lightingDefines(const Viewpoint& viewpoint, const Settings& settings)
{
    std::vector<std::string> defines = shadowDefines(viewpoint.shadows);
    if (settings.shading == Shading::BlinnPhong) defines.emplace_back("BLINN_PHONG");
    if (viewpoint.light.cloudsOn > 0) defines.emplace_back("CLOUD_SHADOWS");
    if (!viewpoint.lamps.empty()) defines.emplace_back("LAMPS");
    if (viewpoint.heavens.aerial > 0) defines.emplace_back("AERIAL");
    return defines;
}

LightingPass::LightingPass(ShaderLibrary& shaders) : m_shaders{shaders}
{
    std::vector<std::string> usual = shadowDefines({.cascades = 1, .reach = 2});
    usual.insert(usual.end(), {"CLOUD_SHADOWS", "AERIAL", "FOG"});
    shaders.fullScreen("lighting", std::move(usual));
}

void LightingPass::resize(const GBuffer& surfaces)
{
    if (m_depth == surfaces.depth.id() && m_radiance.texture.size() == surfaces.depth.size()) return;
    m_depth = surfaces.depth.id();
    m_radiance.texture =
        gl::Texture{{.label = "radiance", .size = surfaces.depth.size(), .format = GL_RGBA16F, .target = true}};
    m_radiance.framebuffer =
        gl::Framebuffer{{.label = "radiance", .colours = {&m_radiance.texture}, .depth = &surfaces.depth}};
}

Radiance& LightingPass::render(GpuFrame& gpu, const GBuffer& surfaces, const Viewpoint& viewpoint, const Settings& settings)
{
    const auto scope = gpu.scope("lighting");
    resize(surfaces);
    m_radiance.framebuffer.bind();
    surfaces.bind(gpu);
    std::vector<std::string> defines = lightingDefines(viewpoint, settings);
    if (viewpoint.light.fogDensity > 0) defines.emplace_back("FOG");
    for (std::string& define : occlusionDefines(viewpoint.occlusion, settings))
        defines.push_back(std::move(define));
    gpu.fullScreen(m_shaders.fullScreen("lighting", std::move(defines)),
                   {.depthTest = kWhereSurfacesAre}, {});
    return m_radiance;
}

Radiance& LightingPass::unlit(const GBuffer& surfaces)
{
    resize(surfaces);
    return m_radiance;
}

SkyPass::SkyPass(ShaderLibrary& shaders) : m_shaders{shaders}
{
    shaders.fullScreen("sky", {"CLOUDS"});
}

void SkyPass::render(GpuFrame& gpu, Radiance& radiance, const Viewpoint& viewpoint, const Settings& settings, bool clouds)
{
    const auto scope = gpu.scope("sky");
    std::vector<std::string> defines;
    if (clouds) defines.emplace_back("CLOUDS");
    if (settings.sky == SkyFrom::Integral) defines.emplace_back("INTEGRAL");
    const bool coarse = settings.skyPixels > 1;
    if (coarse) {
        renderDome(gpu, (radiance.texture.size() + settings.skyPixels - 1) / settings.skyPixels, defines);
        defines = {"FROM_DOME"};
    }
    if (viewpoint.heavens.stars > 0) defines.emplace_back("STARS");
    if (viewpoint.heavens.towardMoon.y > -0.1f) defines.emplace_back("MOON");
    radiance.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("sky", std::move(defines)), {.depthTest = kWhereSkyIs},
                   {{IMAGE_UNIT, coarse ? &m_dome.texture : nullptr}});
}

void SkyPass::renderDome(GpuFrame& gpu, glm::ivec2 size, std::vector<std::string> defines)
{
    if (m_dome.texture.size() != size) {
        m_dome.texture = gl::Texture{{.label = "dome of the sky", .size = size, .format = GL_RGBA16F, .target = true}};
        m_dome.framebuffer = gl::Framebuffer{{.label = "dome of the sky", .colours = {&m_dome.texture}}};
    }
    defines.emplace_back("DOME");
    m_dome.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("sky", std::move(defines)), {}, {});
}

} // namespace renderer
