#include "renderer/passes/sky_tables.h"

#include "renderer/pixels.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/sky_mirror.h"

#include <cmath>
#include <cstring>

namespace renderer {
namespace {

constexpr int kNoiseSize = 512;
constexpr glm::ivec2 kMultiScatter{MULTI_SCATTER_WIDTH, MULTI_SCATTER_HEIGHT};

// The eye's height has no part in the tables of the air itself.
bool sameAir(glsl::Atmosphere a, glsl::Atmosphere b)
{
    a.eyeAltitude = b.eyeAltitude;
    a.horizon = b.horizon;
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool sameHeight(const glsl::Atmosphere& a, const glsl::Atmosphere& b)
{
    return std::abs(a.eyeAltitude - b.eyeAltitude) <= std::max(0.05f * b.eyeAltitude, 0.02f); // haze thins by 2 % over 0.02 km
}

} // namespace

SkyTables::Target SkyTables::makeTarget(std::string_view label, glm::ivec2 size)
{
    Target target;
    target.texture = gl::Texture{{.label = label, .size = size, .format = GL_RGBA32F, .target = true}};
    target.framebuffer = gl::Framebuffer{{.label = label, .colours = {&target.texture}}};
    return target;
}

SkyTables::SkyTables(ShaderLibrary& shaders)
    : m_transmittanceProgram{shaders.fullScreen("transmittance")}, m_scatterOnceProgram{shaders.fullScreen("multi_scatter")},
      m_multiScatterProgram{shaders.fullScreen("multi_scatter", {"FROM_TABLE"})}, m_skyViewProgram{shaders.fullScreen("sky_view")},
      m_skyMirrorProgram{shaders.fullScreen("sky_mirror")},
      m_aerialProgram{shaders.program({.label = "aerial", .stages = {"aerial.comp.glsl"}})},
      m_skyLightProgram{shaders.program({.label = "sky_light", .stages = {"sky_light.comp.glsl"}})},
      m_noiseProgram{shaders.fullScreen("noise")},
      m_transmittance{makeTarget("transmittance", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT})},
      m_scatteredOnce{makeTarget("light scattered once", kMultiScatter)}, m_multiScatter{makeTarget("multiple scattering", kMultiScatter)},
      m_skyView{makeTarget("sky view", {SKY_VIEW_WIDTH, SKY_VIEW_HEIGHT})},
      m_skyMirror{makeTarget("mirrored sky", {SKY_MIRROR_SIZE, SKY_MIRROR_SIZE * SKY_MIRROR_LEVELS})},
      m_aerial{{.label = "air before things", .size = glm::ivec2{AERIAL_SIZE}, .layers = AERIAL_SIZE, .format = GL_RGBA16F, .target = true}},
      m_skyLight{"sky light", sizeof(glsl::SkyLight)}
{
    m_noise.texture = gl::Texture{{.label = "noise",
                                   .size = glm::ivec2{kNoiseSize},
                                   .mips = gl::fullMipCount(glm::ivec2{kNoiseSize}),
                                   .wrap = GL_REPEAT}};
    m_noise.framebuffer = gl::Framebuffer{{.label = "noise", .colours = {&m_noise.texture}}};
}

void SkyTables::begin(GpuFrame& gpu)
{
    if (!m_noiseMade) makeNoise(gpu);
    bind(gpu);
}

void SkyTables::update(GpuFrame& gpu, const glsl::Light& light, const glsl::Heavens& heavens, const glsl::Clouds& clouds, bool exact)
{
    const auto scope = gpu.scope("sky tables");
    begin(gpu);
    const bool air = !sameAir(light.atmosphere, m_air) || light.sunRadius != m_sunRadius;
    if (air) drawAirTables(gpu);
    const bool moved = exact ? light.atmosphere.eyeAltitude != m_air.eyeAltitude : !sameHeight(light.atmosphere, m_air);
    const bool sky = air || moved || heavens.towardSun != m_towardSun;
    if (sky) {
        drawSky(gpu);
        m_air = light.atmosphere;
        m_towardSun = heavens.towardSun;
        m_sunRadius = light.sunRadius;
    }
    bind(gpu);
    const CloudLight cloudy{.sun = clouds.sun, .cover = clouds.cover, .through = clouds.through, .on = clouds.on};
    if (sky || cloudy != m_clouds) gatherSkyLight(gpu);
    m_clouds = cloudy;
}

// Its mips are averaged here: software GL would build programs for that, which takes a tenth of a second.
void SkyTables::makeNoise(GpuFrame& gpu)
{
    m_noise.framebuffer.bind();
    gpu.fullScreen(m_noiseProgram, {}, {});
    io::Image image{.size = glm::ivec2{kNoiseSize}};
    image.bytes.resize(image.rowBytes() * kNoiseSize);
    glGetTextureImage(m_noise.texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(image.bytes.size()), image.bytes.data());
    const std::vector<Pixels> mips = mipChain({&image, kNoiseSize});
    for (std::size_t mip = 1; mip < mips.size(); ++mip)
        m_noise.texture.upload(mips[mip].data(), GL_RGBA, GL_UNSIGNED_BYTE, int(mip));
    m_noiseMade = true;
}

void SkyTables::drawAirTables(GpuFrame& gpu)
{
    m_transmittance.framebuffer.bind();
    gpu.fullScreen(m_transmittanceProgram, {}, {});
    m_scatteredOnce.framebuffer.bind();
    gpu.fullScreen(m_scatterOnceProgram, {}, {{TRANSMITTANCE_UNIT, &m_transmittance.texture}});
    m_multiScatter.framebuffer.bind();
    gpu.fullScreen(m_multiScatterProgram, {},
                   {{TRANSMITTANCE_UNIT, &m_transmittance.texture}, {MULTI_SCATTER_UNIT, &m_scatteredOnce.texture}});
}

// What goes by the sun's place: the sky around the eye, what surfaces mirror of it, the air before things, the light on surfaces.
void SkyTables::drawSky(GpuFrame& gpu)
{
    m_skyView.framebuffer.bind();
    gpu.fullScreen(m_skyViewProgram, {},
                   {{TRANSMITTANCE_UNIT, &m_transmittance.texture}, {MULTI_SCATTER_UNIT, &m_multiScatter.texture}});
    m_skyMirror.framebuffer.bind();
    gpu.fullScreen(m_skyMirrorProgram, {}, {{SKY_VIEW_UNIT, &m_skyView.texture}});
    bind(gpu);
    if (!gpu.use(m_aerialProgram)) return;
    glBindImageTexture(0, m_aerial.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    glDispatchCompute(AERIAL_SIZE / 8, AERIAL_SIZE / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SkyTables::gatherSkyLight(GpuFrame& gpu)
{
    if (!gpu.use(m_skyLightProgram)) return;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SKY_LIGHT_STORAGE_BINDING, m_skyLight.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_UNIFORM_BARRIER_BIT);
}

void SkyTables::bind(GpuFrame& gpu) const
{
    gpu.bind({{SKY_VIEW_UNIT, &m_skyView.texture},
              {TRANSMITTANCE_UNIT, &m_transmittance.texture},
              {MULTI_SCATTER_UNIT, &m_multiScatter.texture},
              {SKY_MIRROR_UNIT, &m_skyMirror.texture},
              {AERIAL_UNIT, &m_aerial},
              {NOISE_UNIT, &m_noise.texture}});
    glBindBufferBase(GL_UNIFORM_BUFFER, SKY_LIGHT_BINDING, m_skyLight.id());
}

} // namespace renderer
