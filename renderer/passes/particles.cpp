#include "renderer/passes/particles.h"

#include "renderer/passes/shafts.h"
#include "renderer/pixels.h"
#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cstddef>

namespace renderer {
namespace {

constexpr int kAtlasSide = 512; // texels, of four by four pictures
constexpr int kAtlasMips = 6;   // further ones would mix the pictures
constexpr std::size_t kMost = 12000, kMostWhereCheap = 3000; // particles

} // namespace

ParticlePass::ParticlePass(ShaderLibrary& shaders) : m_shaders{shaders} {}

void ParticlePass::makeAtlas(GpuFrame& gpu)
{
    m_quads = gl::VertexArray{"particles"};
    m_quads.integers(0, 0, 2, GL_UNSIGNED_INT, offsetof(glsl::Particle, source));
    m_quads.attribute(1, 0, 1, GL_FLOAT, offsetof(glsl::Particle, age));
    m_quads.perInstance(0);

    m_atlas = gl::Texture{{.label = "particles", .size = glm::ivec2{kAtlasSide}, .mips = kAtlasMips}};
    const gl::Framebuffer target{{.label = "particles", .colours = {&m_atlas}}};
    target.bind();
    gpu.fullScreen(m_shaders.fullScreen("particle_atlas"), {}, {});
    io::Image image{.size = glm::ivec2{kAtlasSide}};
    image.bytes.resize(image.rowBytes() * kAtlasSide);
    glGetTextureImage(m_atlas.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(image.bytes.size()), image.bytes.data());
    const std::vector<Pixels> mips = mipChain({&image, kAtlasSide});
    for (int mip = 1; mip < kAtlasMips; ++mip)
        m_atlas.upload(mips[std::size_t(mip)].data(), GL_RGBA, GL_UNSIGNED_BYTE, mip);
}

void ParticlePass::render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const Scenery& scenery,
                          const io::Wind& wind, const Viewpoint& viewpoint, const Settings& settings)
{
    if (!settings.particles || scenery.particles.placed().empty()) return;
    const auto scope = gpu.scope("particles");
    const std::optional<Volume> volume = settings.culling ? std::optional{volumeOf(viewpoint.culledFor)} : std::nullopt;
    const Particles particles = particlesOf(scenery.particles.placed(), {.eye = viewpoint.eye,
                                                                         .volume = volume,
                                                                         .wind = wind,
                                                                         .time = viewpoint.time,
                                                                         .most = settings.skyPixels > 1 ? kMostWhereCheap : kMost});
    if (particles.drawn.empty()) return;
    if (!m_atlas) makeAtlas(gpu);
    std::vector<std::string> defines = lightingDefines(viewpoint, settings);
    addHaze(defines, viewpoint);
    const gl::Program& program =
        m_shaders.program({.label = "particles", .stages = {"particles.vert.glsl", "particles.frag.glsl"}, .defines = std::move(defines)});
    radiance.framebuffer.bind();
    surfaces.bind(gpu);
    if (!gpu.use(program, {{PARTICLE_ATLAS_UNIT, &m_atlas}})) return;
    std::array<glsl::ParticleSource, MOST_PARTICLE_SOURCES> sources{};
    std::ranges::copy(particles.sources, sources.begin());
    gpu.constants(PARTICLES_BINDING, sources);
    const GpuStream::Piece piece = gpu.stream().put(std::span{particles.drawn});
    m_quads.source(0, piece.buffer, piece.offset, sizeof(glsl::Particle));
    gl::apply({.depthTest = GL_GREATER, .blend = gl::Blend::Over});
    glBindVertexArray(m_quads.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(particles.drawn.size()));
    gpu.count(1, particles.drawn.size() * 2);
}

} // namespace renderer
