#include "renderer/ground_tint.h"

#include "renderer/gl/framebuffer.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr int kWidest = 512; // texels along a side
constexpr int kBlock = 16;   // by which the window moves

// Texels along a side that reach so far from wherever the eye is in the middle block.
int sideFor(double reach)
{
    return (int(std::ceil(reach * 2)) / kBlock + 3) * kBlock;
}

// Those that texels of the ground show in: their neighbours' normals follow them, and four share what they ask for.
io::TexelRect shownIn(const io::TexelRect& ground, int step)
{
    if (ground.empty()) return {};
    const io::Texel low = ground.low / std::int64_t(step) - std::int64_t(1), high = (ground.high - std::int64_t(1)) / std::int64_t(step) + std::int64_t(2);
    return {low & ~std::int64_t(1), (high + std::int64_t(1)) & ~std::int64_t(1)};
}

} // namespace

void GroundTint::update(GpuFrame& gpu, ShaderLibrary& shaders, Terrain& terrain, const glm::dvec3& eye, double distance)
{
    const io::HeightMap& map = *terrain.heights();
    const double reach = distance / map.metresPerTexel; // texels of the ground
    int step = 1;
    while (sideFor(reach / step) > kWidest)
        step *= 2;
    const int side = sideFor(reach / step);
    if (step != m_step || side != m_texture.size().x) {
        m_texture = gl::Texture{{.label = "ground tint", .size = glm::ivec2{side}, .wrap = GL_REPEAT}};
        m_window = {};
    }
    m_step = step;
    const glm::dvec2 place = (glm::dvec2{eye.x, eye.z} - map.origin) / (map.metresPerTexel * step);
    const io::Texel low = io::Texel{glm::floor(place / double(kBlock))} * std::int64_t(kBlock) - io::Texel{side / 2 / kBlock * kBlock};
    const io::TexelRect window{low, low + io::Texel{side}};
    std::vector<io::TexelRect> parts = io::without(window, m_window);
    parts.push_back(common(common(window, m_window), shownIn(terrain.repainted(), step)));
    const io::TexelRect ofMap = shownIn(map.texels(), step);
    for (io::TexelRect& part : parts)
        part = common(part, ofMap);
    if (!draw(gpu, shaders, terrain, parts)) return;
    m_window = window;
    terrain.forgetRepainted();
}

bool GroundTint::draw(GpuFrame& gpu, ShaderLibrary& shaders, const Terrain& terrain, std::span<const io::TexelRect> parts)
{
    if (std::ranges::all_of(parts, &io::TexelRect::empty)) return true;
    std::vector<std::string> defines = terrain.coverDefines();
    std::erase(defines, "HOLES");
    defines.emplace_back("FROM_ABOVE");
    if (terrain.windowed()) defines.emplace_back("WINDOWS");
    const gl::Program& program = shaders.program({.label = "ground tint", .stages = {"ground_tint.vert.glsl", "terrain.frag.glsl"}, .defines = std::move(defines)});
    if (!gpu.use(program)) return false;
    const gl::Framebuffer target{{.label = "ground tint", .colours = {&m_texture}}};
    target.bind();
    gl::apply({});
    if (!m_bare.id()) m_bare = gl::VertexArray{"ground tint"};
    glBindVertexArray(m_bare.id());
    const int side = m_texture.size().x;
    if (terrain.windowed()) glProgramUniform1i(program.id(), 1, int(std::log2(m_step)));
    for (const io::TexelRect& part : parts)
        for (const io::TexelRect& piece : io::cutAtMultiples(part, side)) {
            const glm::ivec2 at{((piece.low % std::int64_t(side)) + std::int64_t(side)) % std::int64_t(side)}, size{piece.high - piece.low};
            glViewport(at.x, at.y, size.x, size.y);
            const glm::vec2 from{piece.low * std::int64_t(m_step)}, extent{size * m_step};
            glProgramUniform4f(program.id(), 0, from.x, from.y, extent.x, extent.y);
            glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
            gpu.count(1, 2);
        }
    return true;
}

} // namespace renderer
