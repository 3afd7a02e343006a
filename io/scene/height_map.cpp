#include "io/scene/height_map.h"

#include "io/base/contract.h"
#include "io/scene/height_queries.h"

#include <algorithm>

namespace io {
namespace {

constexpr int kSide = HeightTile::kSide;

} // namespace

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

TexelRect texelsOf(glm::ivec2 tile)
{
    return {Texel{tile} * Texel{kSide}, (Texel{tile} + Texel{1}) * Texel{kSide}};
}

TexelRect tilesUnder(const TexelRect& texels)
{
    if (texels.empty()) return {};
    return {texels.low / Texel{kSide}, (texels.high + Texel{kSide - 1}) / Texel{kSide}};
}

HeightMap::HeightMap(const HeightGrid& grid)
    : size{grid.size}, metresPerTexel{grid.metresPerTexel}, origin{grid.origin}, m_count{(grid.size + kSide - 1) / kSide},
      m_tiles(std::size_t(m_count.x) * m_count.y)
{
    for (int z = 0; z < m_count.y; ++z)
        for (int x = 0; x < m_count.x; ++x) {
            const glm::ivec2 low = glm::ivec2{x, z} * kSide, high = glm::min(low + kSide, size);
            std::vector<float> metres(std::size_t(kSide) * kSide);
            for (int row = low.y; row < high.y; ++row) {
                const float* from = &grid.metres[std::size_t(row) * size.x];
                std::copy(from + low.x, from + high.x, &metres[std::size_t(row - low.y) * kSide]);
            }
            set({x, z}, std::move(metres));
        }
    findRange();
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
    EXPECTS(common(rect, texels()) == rect);
    HeightGrid grid{.size = rect.high - rect.low,
                    .metresPerTexel = metresPerTexel,
                    .origin = origin + glm::dvec2{rect.low} * metresPerTexel};
    grid.metres.resize(std::size_t(grid.size.x) * grid.size.y);
    const TexelRect under = tilesUnder(rect);
    for (auto z = under.low.y; z < under.high.y; ++z)
        for (auto x = under.low.x; x < under.high.x; ++x) {
            const TexelRect whole = texelsOf({x, z}), part = common(rect, whole);
            const HeightTile& tile = *this->tile({x, z});
            for (auto row = part.low.y; row < part.high.y; ++row) {
                const float* from = &tile.metres[std::size_t((row - whole.low.y) * kSide + part.low.x - whole.low.x)];
                std::copy(from, from + (part.high.x - part.low.x),
                          &grid.metres[std::size_t((row - rect.low.y) * grid.size.x + part.low.x - rect.low.x)]);
            }
        }
    return grid;
}

HeightMap HeightMap::with(const HeightGrid& part, glm::ivec2 at) const
{
    HeightMap map = *this;
    const TexelRect given{at, at + part.size}, rect = common(given, texels());
    const TexelRect under = tilesUnder(rect);
    for (auto z = under.low.y; z < under.high.y; ++z)
        for (auto x = under.low.x; x < under.high.x; ++x) {
            const TexelRect whole = texelsOf({x, z}), piece = common(rect, whole);
            std::vector<float> metres = tile({x, z})->metres;
            for (auto row = piece.low.y; row < piece.high.y; ++row) {
                const float* from = &part.metres[std::size_t((row - given.low.y) * part.size.x + piece.low.x - given.low.x)];
                std::copy(from, from + (piece.high.x - piece.low.x),
                          &metres[std::size_t((row - whole.low.y) * kSide + piece.low.x - whole.low.x)]);
            }
            map.set({x, z}, std::move(metres));
        }
    map.findRange();
    return map;
}

HeightMap HeightMap::withTiles(std::vector<std::pair<glm::ivec2, std::vector<float>>> tiles) const
{
    HeightMap map = *this;
    for (auto& [tile, metres] : tiles)
        map.set(tile, std::move(metres));
    map.findRange();
    return map;
}

HeightMap HeightMap::placed(double newMetresPerTexel, glm::dvec2 newOrigin) const
{
    HeightMap map = *this;
    map.metresPerTexel = newMetresPerTexel;
    map.origin = newOrigin;
    return map;
}

bool HeightMap::sameHeights(const HeightMap& other) const
{
    return size == other.size && std::ranges::equal(m_tiles, other.m_tiles, [](const auto& a, const auto& b) {
               return a == b || a->metres == b->metres;
           });
}

bool HeightMap::operator==(const HeightMap& other) const
{
    return metresPerTexel == other.metresPerTexel && origin == other.origin && sameHeights(other);
}

void HeightMap::set(glm::ivec2 tile, std::vector<float> metres)
{
    EXPECTS(metres.size() == std::size_t(kSide) * kSide);
    auto made = std::make_shared<HeightTile>();
    const glm::ivec2 extent = glm::min(size - tile * kSide, glm::ivec2{kSide});
    made->min = made->max = metres.front();
    for (int row = 0; row < extent.y; ++row) {
        const float* first = &metres[std::size_t(row) * kSide];
        for (int x = 0; x < extent.x; ++x) { // std::minmax_element() looks at one after another
            made->min = std::min(made->min, first[x]);
            made->max = std::max(made->max, first[x]);
        }
    }
    made->metres = std::move(metres);
    m_tiles[indexOf(tile)] = std::move(made);
}

void HeightMap::findRange()
{
    if (m_tiles.empty()) return;
    min = m_tiles.front()->min;
    max = m_tiles.front()->max;
    for (const auto& tile : m_tiles) {
        min = std::min(min, tile->min);
        max = std::max(max, tile->max);
    }
}

} // namespace io
