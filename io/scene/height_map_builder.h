// Makes a height map from rows as they arrive: no second copy of it exists, and what never arrives takes no memory.
#pragma once

#include "io/scene/height_map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace io {

class HeightMapBuilder {
public:
    explicit HeightMapBuilder(glm::ivec2 size); // texels

    void addRow(std::span<const float> metres); // size.x of them, the next from -Z to +Z; NaN is a void

    glm::ivec2 size() const { return m_size; }
    int rows() const { return m_rows; } // so far

    // Of the rows so far. Voids are to be set to some height before finish().
    std::size_t voids() const { return m_voids; }        // how many NaN came
    const TexelRect& voidRect() const { return m_void; } // around all of them
    float at(int x, int z) const { return m_tiles[tileOf(x, z)][inTile(x, z)]; }
    void set(int x, int z, float metres)
    {
        m_tiles[tileOf(x, z)][inTile(x, z)] = metres;
        m_changed[tileOf(x, z)] = 1;
    }

    HeightMap finish(double metresPerTexel, glm::dvec2 origin); // after the last row; leaves the builder empty

private:
    std::size_t tileOf(int x, int z) const { return std::size_t(z >> kTileShift) * std::size_t(m_count.x) + std::size_t(x >> kTileShift); }
    static std::size_t inTile(int x, int z)
    {
        return std::size_t(z & (kTileSide - 1)) << kTileShift | std::size_t(x & (kTileSide - 1));
    }
    void noteVoids(std::span<const float> metres, int x);

    glm::ivec2 m_size, m_count;
    int m_rows = 0;
    std::vector<TexelTiles<float>::Tile> m_tiles; // as long as the rows so far
    std::vector<glm::vec2> m_ranges;              // of each tile, m
    std::vector<std::uint8_t> m_changed;          // tiles whose range is not known any more
    std::size_t m_voids = 0;
    TexelRect m_void;
};

} // namespace io
