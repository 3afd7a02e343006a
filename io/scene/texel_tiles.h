// A field of texels in tiles that editing, undo, saving and mirrors share: a changed field holds what did not change in common
// with the one before, so keeping the one before costs only the tiles that were touched.
#pragma once

#include "io/base/contract.h"
#include "io/scene/texel_rect.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace io {

constexpr int kTileShift = 9, kTileSide = 1 << kTileShift; // texels along a side
constexpr std::size_t kTileTexels = std::size_t(kTileSide) * kTileSide;

// The texels of one tile, and the tiles that a rectangle touches (both in TexelRect's sense).
inline TexelRect texelsOf(glm::ivec2 tile)
{
    return {Texel{tile} * Texel{kTileSide}, (Texel{tile} + Texel{1}) * Texel{kTileSide}};
}
inline TexelRect tilesUnder(const TexelRect& texels)
{
    if (texels.empty()) return {};
    return {texels.low / Texel{kTileSide}, (texels.high + Texel{kTileSide - 1}) / Texel{kTileSide}};
}

// A value that does not change: with() makes another. What of a tile lies beyond the field's edge is T{}.
template <class T> class TexelTiles {
public:
    using Tile = std::vector<T>; // kTileTexels, row by row

    TexelTiles() = default;
    TexelTiles(glm::ivec2 size, std::span<const T> rows) : TexelTiles{size}
    {
        EXPECTS(rows.size() == std::size_t(size.x) * size.y);
        *this = with(rows, size, {0, 0});
    }
    explicit TexelTiles(glm::ivec2 size) // all T{}
        : m_size{size}, m_count{(size + kTileSide - 1) / kTileSide},
          m_tiles(std::size_t(m_count.x) * m_count.y, std::make_shared<const Tile>(kTileTexels))
    {
    }

    glm::ivec2 size() const { return m_size; }
    TexelRect rect() const { return {{0, 0}, m_size}; }
    T at(int x, int z) const // in range
    {
        constexpr int kMask = kTileSide - 1;
        return (*m_tiles[std::size_t(z >> kTileShift) * m_count.x + (x >> kTileShift)])[std::size_t(z & kMask) << kTileShift | std::size_t(x & kMask)];
    }
    glm::ivec2 tiles() const { return m_count; } // along each side
    const std::shared_ptr<const Tile>& tile(glm::ivec2 tile) const { return m_tiles[indexOf(tile)]; }
    std::size_t indexOf(glm::ivec2 tile) const { return std::size_t(tile.y) * m_count.x + tile.x; }
    std::size_t bytes() const { return m_tiles.size() * kTileTexels * sizeof(T); }

    std::vector<T> read(const TexelRect& rect) const // row by row; inside the field
    {
        EXPECTS(common(rect, this->rect()) == rect);
        const glm::ivec2 size = rect.high - rect.low;
        std::vector<T> rows(std::size_t(size.x) * size.y);
        eachPiece(rect, [&](glm::ivec2 tile, std::size_t inTile, std::size_t inRows, std::size_t count) {
            std::copy_n(this->tile(tile)->begin() + std::ptrdiff_t(inTile), count, rows.begin() + std::ptrdiff_t(inRows));
        });
        return rows;
    }

    // visit(texels, how many) for each run of a row within one tile, tile by tile.
    template <class Visit> void eachRun(const TexelRect& rect, Visit&& visit) const
    {
        EXPECTS(common(rect, this->rect()) == rect);
        eachPiece(rect, [&](glm::ivec2 tile, std::size_t inTile, std::size_t, std::size_t count) {
            visit(this->tile(tile)->data() + inTile, count);
        });
    }

    // With rows of `extent` in place of the texels from `at` on; what of them lies beyond the edge is left out.
    TexelTiles with(std::span<const T> rows, glm::ivec2 extent, glm::ivec2 at) const
    {
        TexelTiles field = *this;
        const TexelRect given{at, at + extent}, rect = common(given, this->rect());
        const std::size_t skipped = std::size_t((rect.low.y - given.low.y) * extent.x + rect.low.x - given.low.x);
        std::shared_ptr<Tile> changed;
        glm::ivec2 last{-1};
        eachPiece(rect, [&](glm::ivec2 tile, std::size_t inTile, std::size_t inRows, std::size_t count) {
            if (tile != last) {
                changed = std::make_shared<Tile>(*this->tile(tile));
                field.m_tiles[indexOf(tile)] = changed;
                last = tile;
            }
            const std::size_t width = std::size_t(rect.high.x - rect.low.x), row = inRows / width, column = inRows % width;
            std::copy_n(rows.begin() + std::ptrdiff_t(skipped + row * std::size_t(extent.x) + column), count, changed->begin() + std::ptrdiff_t(inTile));
        });
        return field;
    }
    TexelTiles withTiles(std::vector<std::pair<glm::ivec2, Tile>> tiles) const
    {
        TexelTiles field = *this;
        for (auto& [tile, texels] : tiles) {
            EXPECTS(texels.size() == kTileTexels);
            field.m_tiles[indexOf(tile)] = std::make_shared<const Tile>(std::move(texels));
        }
        return field;
    }

    // visit(tile) for each that the two do not share; they are of one size.
    template <class Visit> void eachOther(const TexelTiles& other, Visit&& visit) const
    {
        EXPECTS(m_size == other.m_size);
        for (int z = 0; z < m_count.y; ++z)
            for (int x = 0; x < m_count.x; ++x)
                if (tile({x, z}) != other.tile({x, z})) visit(glm::ivec2{x, z});
    }
    bool operator==(const TexelTiles& other) const
    {
        return m_size == other.m_size &&
               std::ranges::equal(m_tiles, other.m_tiles, [](const auto& a, const auto& b) { return a == b || *a == *b; });
    }

private:
    // Tile by tile: visit(tile, first texel in it, first texel of the rectangle's rows, how many).
    template <class Visit> void eachPiece(const TexelRect& rect, Visit&& visit) const
    {
        const TexelRect under = tilesUnder(rect);
        for (auto z = under.low.y; z < under.high.y; ++z)
            for (auto x = under.low.x; x < under.high.x; ++x) {
                const TexelRect whole = texelsOf({x, z}), piece = common(rect, whole);
                for (auto row = piece.low.y; row < piece.high.y; ++row)
                    visit(glm::ivec2{x, z}, std::size_t((row - whole.low.y) * kTileSide + piece.low.x - whole.low.x),
                          std::size_t((row - rect.low.y) * (rect.high.x - rect.low.x) + piece.low.x - rect.low.x),
                          std::size_t(piece.high.x - piece.low.x));
            }
    }

    glm::ivec2 m_size{0}, m_count{0};
    std::vector<std::shared_ptr<const Tile>> m_tiles;
};

} // namespace io
