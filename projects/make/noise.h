// The noise that the worlds are made of, by the short names used here.
#pragma once

#include "io/base/noise.h"

namespace make {

using io::Cells;
using io::cells;
using io::fbm;
using io::noise;
using io::Octaves;
using io::ridged;

} // namespace make
