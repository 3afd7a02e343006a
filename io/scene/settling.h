// Loose ground that comes to rest.
#pragma once

#include "io/scene/height_grid.h"

namespace io {

// What is steeper than `degrees` slides to its lower neighbours, a little with each pass (Musgrave, Kolb and Mace 1989).
void settle(HeightGrid& heights, float degrees, int passes);

} // namespace io
