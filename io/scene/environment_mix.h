// Weather and light between two environments: how presets turn into each other over time.
#pragma once

#include "io/scene/environment.h"

namespace io {

// Every field at `share` of the way, 0..1, from one environment to the other; 0 and 1 give the fields of the ends exactly. Numbers
// are mixed, directions and hours by the shorter way round, quantities with a logarithmic scale by their logarithms; switches,
// choices and numbers that only name something (a seed, a resolution) change at half of the way. Unknown keys are those of `from`,
// whose file they belong to.
Environment mixed(const Environment& from, const Environment& to, double share);

} // namespace io
