// Voids: the gaps of measured heights, and how they are closed.
#pragma once

#include "io/base/progress.h"
#include "io/scene/height_map_builder.h"

#include <cmath>
#include <limits>
#include <optional>

namespace io {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN(); // in rows of heights whose gaps are not closed yet
constexpr float kHighest = 1e5f; // m; what is beyond is no height but a mark or an error

// -32768 and -9999 are the marks of SRTM and of Esri's grids, -32767 that of many GeoTIFFs.
inline bool marksVoid(float metres)
{
    return !std::isfinite(metres) || std::abs(metres) > kHighest || metres == -32768 || metres == -32767 || metres == -9999;
}

// Grows the known ground into the voids (NaN) ring by ring, then lets what was filled settle like a membrane. Takes three
// bits for each texel of the rectangle around all voids. One height at least must be known. False when it was cancelled.
bool fillVoids(HeightMapBuilder& map, const Progress& progress, std::string_view step);

// The same of plain rows of `size`; answers how many voids there were, nothing and no change where all of it is void.
std::optional<std::size_t> fillVoids(glm::ivec2 size, std::vector<float>& rows);

} // namespace io
