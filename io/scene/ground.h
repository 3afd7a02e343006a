// Where one stands: the ground as heights and holes make it together.
#pragma once

#include "io/scene/scene.h"

namespace io {

// Whether the square of texels at a place of the map (world x and z, on it) is missing.
inline bool holeAt(const HeightMap& heights, const CoverMap* cover, double x, double z)
{
    if (!cover || cover->size() != heights.size || !heights.contains(x, z)) return false;
    const glm::ivec2 cell{(glm::dvec2{x, z} - heights.origin) / heights.metresPerTexel};
    return (cover->at(cell.x, cell.y) & kHoleBit) != 0;
}

// Of the ground at world x and z, m; none beside the map and in holes.
inline std::optional<double> groundHeight(const Scene& scene, double x, double z)
{
    const auto& heights = scene.heights();
    if (!heights || holeAt(*heights, scene.cover().get(), x, z)) return std::nullopt;
    return heights->height(x, z);
}

} // namespace io
