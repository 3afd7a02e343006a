// The ground's heights.
#pragma once

#include "io/scene/height_grid.h"
#include "io/scene/texel_tiles.h"

#include <memory>
#include <vector>

namespace io {

// A value that does not change: with() makes another, which shares what is the same. A texel is a vertex; triangles as of
// HeightGrid. The renderer draws exactly this surface near the camera.
class HeightMap {
public:
    HeightMap() = default;
    explicit HeightMap(const HeightGrid& grid);
    // Of tiles whose lowest and highest heights are known, one pair a tile in the order of TexelTiles::indexOf().
    HeightMap(TexelTiles<float> field, std::vector<glm::vec2> ranges);

    glm::ivec2 size{0};
    double metresPerTexel = 1;
    glm::dvec2 origin{0};   // world x and z of texel (0, 0)
    float min = 0, max = 0; // m
    // Read as shares of the way from Terrain::minHeight to maxHeight, not as metres: other such heights scale it.
    bool shares = false;

    float at(int x, int z) const { return m_field.at(x, z); } // texel, in range
    bool contains(double x, double z) const;                    // world, m
    std::optional<double> height(double x, double z) const;     // of the triangle there
    std::optional<glm::dvec3> normal(double x, double z) const; // smooth, from the neighbours
    TexelRect texels() const { return m_field.rect(); }

    HeightGrid read(const TexelRect& rect) const; // on the map
    // With `part` in place of the heights from texel `at` on; what of it lies beyond the edge is left out.
    HeightMap with(const HeightGrid& part, glm::ivec2 at) const;
    HeightMap with(TexelTiles<float> field) const; // of the same size
    HeightMap placed(double newMetresPerTexel, glm::dvec2 newOrigin) const; // the same heights elsewhere

    const TexelTiles<float>& field() const { return m_field; }
    bool sameHeights(const HeightMap& other) const { return m_field == other.m_field; } // wherever they lie
    bool operator==(const HeightMap& other) const; // the same ground

private:
    void findRange(const HeightMap* before);
    void joinRanges();

    TexelTiles<float> m_field; // m
    std::vector<glm::vec2> m_ranges; // lowest and highest of each tile
};

} // namespace io
