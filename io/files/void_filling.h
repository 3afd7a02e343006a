// The gaps of measured heights closed from around them.
#pragma once

#include "io/base/progress.h"
#include "io/scene/height_map_builder.h"

namespace io {

// Grows the known ground into the voids (NaN) ring by ring, then lets what was filled settle like a membrane. Takes three
// bits for each texel of the rectangle around all voids. One height at least must be known. False when it was cancelled.
bool fillVoids(HeightMapBuilder& map, const Progress& progress, std::string_view step);

} // namespace io
