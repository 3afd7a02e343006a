// Where water gathers on the ground, from the shape of the land alone.
#pragma once

#include "io/scene/height_map.h"

namespace io {

// On a grid over the map, at most kFlowSide cells a side, row by row from -Z: 0 on ridges, where 100 m² drain through a cell or less,
// 1 in rivers that drain 10 km² or more; a fifth for each ten times as much. Water spreads over all lower neighbours by their slopes
// (Freeman, "Calculating catchment area with divergent flow", 1991) and stays in hollows.
struct GroundFlow {
    glm::ivec2 size{0};
    double cell = 1; // m; the cell (0, 0) lies around the map's first texel
    std::vector<float> values;
};
constexpr int kFlowSide = 512;

GroundFlow flowOf(const HeightMap& map);

} // namespace io
