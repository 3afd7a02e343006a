#include "renderer/passes/bloom.h"

#include "renderer/shaders/shared/bindings.h"

namespace renderer {
namespace {

constexpr int kLevels = 6; // the last is 1/64 of the picture's size
constexpr int kSmallest = 2; // pixels along a level's shorter side

} // namespace

BloomPass::BloomPass(ShaderLibrary& shaders)
    : m_first{shaders.fullScreen("bloom_down", {"FIRST"})}, m_firstCoarse{shaders.fullScreen("bloom_down", {"FIRST", "QUARTER"})},
      m_down{shaders.fullScreen("bloom_down")}, m_up{shaders.fullScreen("bloom_up")}
{
}

void BloomPass::resize(glm::ivec2 size, bool coarse)
{
    if (m_size == size && m_coarse == coarse) return;
    m_size = size;
    m_coarse = coarse;
    m_levels.clear();
    for (int level = coarse ? 2 : 1; level <= kLevels; ++level) {
        const glm::ivec2 extent = (size + (1 << level) - 1) / (1 << level);
        if (!m_levels.empty() && std::min(extent.x, extent.y) < kSmallest) break;
        Level& made = m_levels.emplace_back();
        made.texture = gl::Texture{{.label = "bloom", .size = extent, .format = GL_RGBA16F, .target = true}};
        made.framebuffer = gl::Framebuffer{{.label = "bloom", .colours = {&made.texture}}};
    }
}

const gl::Texture& BloomPass::render(GpuFrame& gpu, const gl::Texture& radiance, bool coarse)
{
    const auto scope = gpu.scope("bloom");
    resize(radiance.size(), coarse);
    const gl::Texture* source = &radiance;
    for (const Level& level : m_levels) {
        level.framebuffer.bind();
        const gl::Program& first = coarse ? m_firstCoarse : m_first;
        gpu.fullScreen(source == &radiance ? first : m_down, {}, {{BLOOM_UNIT, source}});
        source = &level.texture;
    }
    // Each level is mixed with what comes from below so that in the end all weigh the same; but the first of a coarse
    // pyramid, whose texels would show around the sun, only takes what comes.
    for (std::size_t below = m_levels.size() - 1; below > 0; --below) {
        const auto levelsBelow = float(m_levels.size() - below);
        m_levels[below - 1].framebuffer.bind();
        const bool takes = coarse && below == 1;
        gpu.constants(PASS_BINDING, glm::vec4{takes ? 1.0f : levelsBelow / (levelsBelow + 1)});
        gpu.fullScreen(m_up, {.blend = gl::Blend::Alpha}, {{BLOOM_UNIT, &m_levels[below].texture}});
    }
    return m_levels.front().texture;
}

} // namespace renderer
