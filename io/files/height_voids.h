// Voids: the gaps of measured heights, and how they are closed.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace io {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN(); // in rows of heights whose gaps are not closed yet
constexpr float kHighest = 1e5f; // m; what is beyond is no height but a mark or an error

// -32768 and -9999 are the marks of SRTM and of Esri's grids, -32767 that of many GeoTIFFs.
inline bool marksVoid(float metres)
{
    return !std::isfinite(metres) || std::abs(metres) > kHighest || metres == -32768 || metres == -32767 || metres == -9999;
}

// Closes the voids (NaN) of rows of `size` from their neighbours and answers how many there were; nothing, and no change, where
// all of it is void.
std::optional<std::size_t> fillVoids(glm::ivec2 size, std::vector<float>& rows);

} // namespace io
