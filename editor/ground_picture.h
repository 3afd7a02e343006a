// A picture of ground from above, as maps show it: tinted by height, shaded by the slope (Imhof 1965, "Kartographische
// Geländedarstellung").
#pragma once

#include "io/scene/height_grid.h"

#include <cstdint>
#include <vector>

namespace editor {

// A colour for each texel, row by row: red in the lowest byte, opaque. `low` and `high`: m, of the darkest green and of snow.
std::vector<std::uint32_t> shadedRelief(const io::HeightGrid& heights, float low, float high);

} // namespace editor
