#include "io/scene/height_map_builder.h"

#include "io/scene/height_range.h"

namespace io {

HeightMapBuilder::HeightMapBuilder(glm::ivec2 size) : m_size{size}, m_count{(size + kTileSide - 1) / kTileSide}
{
    EXPECTS(size.x > 0 && size.y > 0);
}

void HeightMapBuilder::addRow(std::span<const float> metres)
{
    EXPECTS(m_rows < m_size.y && metres.size() == std::size_t(m_size.x));
    const std::size_t first = tileOf(0, m_rows);
    if (m_rows % kTileSide == 0) {
        m_tiles.resize(first + std::size_t(m_count.x));
        m_ranges.resize(m_tiles.size(), kNoHeights);
        m_changed.resize(m_tiles.size());
        for (std::size_t i = first; i < m_tiles.size(); ++i)
            m_tiles[i].reserve(kTileTexels); // touched only as far as rows fill it
    }
    for (int tile = 0; tile < m_count.x; ++tile) {
        const int x = tile * kTileSide;
        const auto piece = metres.subspan(std::size_t(x), std::size_t(std::min(kTileSide, m_size.x - x)));
        auto& texels = m_tiles[first + std::size_t(tile)];
        texels.insert(texels.end(), piece.begin(), piece.end());
        texels.resize(texels.size() + std::size_t(kTileSide) - piece.size());
        m_ranges[first + std::size_t(tile)] = joined(m_ranges[first + std::size_t(tile)], rangeOf(piece));
        noteVoids(piece, x);
    }
    ++m_rows;
}

void HeightMapBuilder::noteVoids(std::span<const float> metres, int x)
{
    int count = 0;
    for (const float m : metres)
        count += int(m != m);
    if (count == 0) return;
    const auto isVoid = [](float m) { return m != m; };
    const auto low = std::ranges::find_if(metres, isVoid) - metres.begin();
    const auto high = metres.size() - std::size_t(std::find_if(metres.rbegin(), metres.rend(), isVoid) - metres.rbegin());
    const TexelRect run{Texel{x + int(low), m_rows}, Texel{x + int(high), m_rows + 1}};
    m_void = m_voids == 0 ? run : TexelRect{glm::min(m_void.low, run.low), glm::max(m_void.high, run.high)};
    m_voids += std::size_t(count);
}

HeightMap HeightMapBuilder::finish(double metresPerTexel, glm::dvec2 origin)
{
    EXPECTS(m_rows == m_size.y);
    std::vector<std::pair<glm::ivec2, TexelTiles<float>::Tile>> tiles;
    for (std::size_t i = 0; i < m_tiles.size(); ++i) {
        const glm::ivec2 tile{int(i) % m_count.x, int(i) / m_count.x};
        m_tiles[i].resize(kTileTexels);
        if (m_changed[i]) m_ranges[i] = rangeOfTile(m_tiles[i], glm::min(m_size - tile * kTileSide, glm::ivec2{kTileSide}));
        tiles.emplace_back(tile, std::move(m_tiles[i]));
    }
    m_tiles.clear();
    m_rows = 0;
    HeightMap map{TexelTiles<float>{m_size}.withTiles(std::move(tiles)), std::move(m_ranges)};
    map.metresPerTexel = metresPerTexel;
    map.origin = origin;
    return map;
}

} // namespace io
