#include "renderer/ground_shadow.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace renderer {
namespace {

constexpr int kLargest = 1024; // cells along a side
constexpr int kRim = 1;        // cells without ground around it, where the ground's own edge throws its shadow out of the map
constexpr float kNoShadow = -1e5f;

gl::Texture makeTexture(glm::ivec2 size)
{
    return gl::Texture{{.label = "ground shadow", .size = size, .format = GL_R32F}};
}

} // namespace

// Swept from the side of the sun, line by line: what hides the sun from a cell is the last line's ground or the last
// line's shadow, lowered by what a ray climbs between the lines.
std::vector<float> shadowHeights(glm::ivec2 size, const std::vector<float>& heights, double cell, const glm::dvec3& towardSun)
{
    std::vector<float> shadow(heights.size(), kNoShadow);
    const glm::dvec2 flat{towardSun.x, towardSun.z};
    const double length = glm::length(flat);
    if (length < 1e-4) return shadow;

    const bool alongX = std::abs(flat.x) >= std::abs(flat.y);
    const double major = alongX ? flat.x : flat.y, minor = alongX ? flat.y : flat.x;
    const int lines = alongX ? size.x : size.y, cells = alongX ? size.y : size.x;
    const std::size_t lineStep = alongX ? 1 : std::size_t(size.x), cellStep = alongX ? std::size_t(size.x) : 1;
    const auto drop = float(cell * towardSun.y / std::abs(major));
    const auto drift = float(minor / std::abs(major)); // cells along the line, towards the sun

    for (int i = 1; i < lines; ++i) {
        const int line = major > 0 ? lines - 1 - i : i;
        const std::size_t own = std::size_t(line) * lineStep;
        const std::size_t before = std::size_t(major > 0 ? line + 1 : line - 1) * lineStep;
        for (int c = 0; c < cells; ++c) {
            const float at = float(c) + drift;
            if (at < 0 || at > float(cells - 1)) continue;
            const int low = std::min(int(at), cells - 2 < 0 ? 0 : cells - 2);
            const std::size_t a = before + std::size_t(low) * cellStep;
            const std::size_t b = before + std::size_t(std::min(low + 1, cells - 1)) * cellStep;
            const float f = at - float(low);
            const float over = std::max(shadow[a], heights[a]) * (1 - f) + std::max(shadow[b], heights[b]) * f;
            shadow[own + std::size_t(c) * cellStep] = over - drop;
        }
    }
    return shadow;
}

GroundShadow::GroundShadow() : m_texture{makeTexture({1, 1})}
{
    m_texture.upload(&kNoShadow, GL_RED, GL_FLOAT);
}

// Only those of tiles that the map before did not have.
void GroundShadow::coarsen(const io::HeightMap& map, const io::HeightMap* before)
{
    const int step = (std::max(map.size.x, map.size.y) + kLargest - 1) / kLargest;
    const glm::ivec2 size = (map.size - 1) / step + 1;
    m_size = size + 2 * kRim;
    m_cell = map.metresPerTexel * step;
    if (!before) m_heights.assign(std::size_t(m_size.x) * m_size.y, kNoShadow);
    for (int tz = 0; tz < map.field().tiles().y; ++tz)
        for (int tx = 0; tx < map.field().tiles().x; ++tx) {
            if (before && before->field().tile({tx, tz}) == map.field().tile({tx, tz})) continue;
            const io::TexelRect rect = io::texelsOf({tx, tz});
            const glm::ivec2 low = (glm::ivec2{rect.low} + step - 1) / step, high = glm::min((glm::ivec2{rect.high} + step - 1) / step, size);
            for (int z = low.y; z < high.y; ++z)
                for (int x = low.x; x < high.x; ++x)
                    m_heights[std::size_t(z + kRim) * m_size.x + x + kRim] = map.at(x * step, z * step);
        }
}

void GroundShadow::update(const std::shared_ptr<const io::HeightMap>& map, const glm::dvec3& towardSun)
{
    if (map == m_map && towardSun == m_towardSun) return;
    if (map != m_map) {
        const bool sameSize = map && m_map && map->size == m_map->size;
        const std::shared_ptr<const io::HeightMap> before = std::exchange(m_map, map);
        if (map) coarsen(*map, sameSize ? before.get() : nullptr);
        if (!map) m_size = {1, 1};
        if (m_texture.size() != m_size) m_texture = makeTexture(m_size);
        if (!map) m_texture.upload(&kNoShadow, GL_RED, GL_FLOAT);
    }
    m_towardSun = towardSun;
    if (!map) return;
    const std::vector<float> shadow = shadowHeights(m_size, m_heights, m_cell, towardSun);
    m_texture.upload(shadow.data(), GL_RED, GL_FLOAT);
}

glm::vec4 GroundShadow::placement(const glm::dvec3& eye) const
{
    if (!m_map) return {0, 0, 0.5f, 0.5f};
    const glm::dvec2 scale = 1.0 / (m_cell * glm::dvec2{m_size});
    const glm::dvec2 offset = (glm::dvec2{eye.x, eye.z} - m_map->origin + m_cell * (kRim + 0.5)) * scale;
    return {glm::vec2{scale}, glm::vec2{offset}};
}

} // namespace renderer
