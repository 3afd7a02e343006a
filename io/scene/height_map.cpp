#include "io/scene/height_map.h"

#include "io/scene/height_queries.h"
#include "io/scene/height_range.h"

namespace io {

bool HeightGrid::contains(double x, double z) const
{
    return heightsContain(*this, x, z);
}

std::optional<double> HeightGrid::height(double x, double z) const
{
    return heightOn(*this, x, z);
}

std::optional<glm::dvec3> HeightGrid::normal(double x, double z) const
{
    return normalOn(*this, x, z);
}

HeightMap::HeightMap(const HeightGrid& grid)
    : size{grid.size}, metresPerTexel{grid.metresPerTexel}, origin{grid.origin}, m_field{grid.size, grid.metres}
{
    findRange(nullptr);
}

HeightMap::HeightMap(TexelTiles<float> field, std::vector<glm::vec2> ranges)
    : size{field.size()}, m_field{std::move(field)}, m_ranges{std::move(ranges)}
{
    EXPECTS(m_ranges.size() == std::size_t(m_field.tiles().x) * std::size_t(m_field.tiles().y));
    joinRanges();
}

bool HeightMap::contains(double x, double z) const
{
    return heightsContain(*this, x, z);
}

std::optional<double> HeightMap::height(double x, double z) const
{
    return heightOn(*this, x, z);
}

std::optional<glm::dvec3> HeightMap::normal(double x, double z) const
{
    return normalOn(*this, x, z);
}

HeightGrid HeightMap::read(const TexelRect& rect) const
{
    return {.size = rect.high - rect.low,
            .metres = m_field.read(rect),
            .metresPerTexel = metresPerTexel,
            .origin = origin + glm::dvec2{rect.low} * metresPerTexel};
}

HeightMap HeightMap::with(const HeightGrid& part, glm::ivec2 at) const
{
    return with(m_field.with(part.metres, part.size, at));
}

HeightMap HeightMap::with(TexelTiles<float> field) const
{
    EXPECTS(field.size() == size);
    HeightMap map = *this;
    map.m_field = std::move(field);
    map.findRange(this);
    return map;
}

HeightMap HeightMap::placed(double newMetresPerTexel, glm::dvec2 newOrigin) const
{
    HeightMap map = *this;
    map.metresPerTexel = newMetresPerTexel;
    map.origin = newOrigin;
    return map;
}

bool HeightMap::operator==(const HeightMap& other) const
{
    return metresPerTexel == other.metresPerTexel && origin == other.origin && sameHeights(other);
}

// Of the tiles that the map before did not have.
void HeightMap::findRange(const HeightMap* before)
{
    const glm::ivec2 count = m_field.tiles();
    m_ranges.resize(std::size_t(count.x) * count.y);
    for (int z = 0; z < count.y; ++z)
        for (int x = 0; x < count.x; ++x) {
            const auto& tile = m_field.tile({x, z});
            if (before && before->m_field.tile({x, z}) == tile) continue;
            m_ranges[m_field.indexOf({x, z})] = rangeOfTile(*tile, glm::min(size - glm::ivec2{x, z} * kTileSide, glm::ivec2{kTileSide}));
        }
    joinRanges();
}

void HeightMap::joinRanges()
{
    if (m_ranges.empty()) return;
    min = m_ranges.front().x;
    max = m_ranges.front().y;
    for (const glm::vec2& range : m_ranges) {
        min = std::min(min, range.x);
        max = std::max(max, range.y);
    }
}

} // namespace io
