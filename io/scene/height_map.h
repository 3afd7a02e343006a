// The ground's heights in tiles that editing, undo, saving and mirrors share: a changed map holds what did not change in
// common with the one before, so keeping the one before costs only the tiles that were touched.
#pragma once

#include "io/scene/height_grid.h"
#include "io/scene/texel_rect.h"

#include <memory>
#include <vector>

namespace io {

// 512 x 512 heights; what lies beyond the map's edge is 0 and counts for nothing.
struct HeightTile {
    static constexpr int kShift = 9, kSide = 1 << kShift; // texels along a side
    std::vector<float> metres;                            // m, row by row
    float min = 0, max = 0;                               // m, of what lies on the map
};

// A value that does not change: with() makes another. A texel is a vertex; triangles as of HeightGrid. The renderer draws
// exactly this surface near the camera.
class HeightMap {
public:
    HeightMap() = default;
    explicit HeightMap(const HeightGrid& grid);

    glm::ivec2 size{0};
    double metresPerTexel = 1;
    glm::dvec2 origin{0}; // world x and z of texel (0, 0)
    float min = 0, max = 0; // m
    // Its file holds shares of the way from Terrain::minHeight to maxHeight, not metres.
    bool shares = false;

    float at(int x, int z) const // texel, in range
    {
        constexpr int kMask = HeightTile::kSide - 1;
        const HeightTile& tile = *m_tiles[std::size_t(z >> HeightTile::kShift) * m_count.x + (x >> HeightTile::kShift)];
        return tile.metres[std::size_t(z & kMask) << HeightTile::kShift | std::size_t(x & kMask)];
    }
    bool contains(double x, double z) const;                    // world, m
    std::optional<double> height(double x, double z) const;     // of the triangle there
    std::optional<glm::dvec3> normal(double x, double z) const; // smooth, from the neighbours
    TexelRect texels() const { return {{0, 0}, size}; }

    HeightGrid read(const TexelRect& rect) const; // on the map
    // With `part` in place of the heights from texel `at` on; what of it lies beyond the edge is left out.
    HeightMap with(const HeightGrid& part, glm::ivec2 at) const;

    HeightMap placed(double newMetresPerTexel, glm::dvec2 newOrigin) const; // the same heights elsewhere

    // Tiles along each side, and one of them.
    glm::ivec2 tiles() const { return m_count; }
    const std::shared_ptr<const HeightTile>& tile(glm::ivec2 tile) const { return m_tiles[indexOf(tile)]; }
    HeightMap withTiles(std::vector<std::pair<glm::ivec2, std::vector<float>>> tiles) const; // whole tiles' heights

    bool sameHeights(const HeightMap& other) const;  // the same size and heights, wherever they lie
    bool operator==(const HeightMap& other) const;   // the same ground
    std::size_t bytes() const { return m_tiles.size() * HeightTile::kSide * HeightTile::kSide * sizeof(float); }

private:
    std::size_t indexOf(glm::ivec2 tile) const { return std::size_t(tile.y) * m_count.x + tile.x; }
    void set(glm::ivec2 tile, std::vector<float> metres);
    void findRange();

    glm::ivec2 m_count{0};
    std::vector<std::shared_ptr<const HeightTile>> m_tiles;
};

// The texels of one tile of a map, and the tiles that a rectangle touches (both in TexelRect's sense).
TexelRect texelsOf(glm::ivec2 tile);
TexelRect tilesUnder(const TexelRect& texels);

} // namespace io
