// Chance that is the same on every machine, by the short names used here.
#pragma once

#include "io/base/random.h"

namespace make {

using io::hash;
using io::Random;
using io::unitOf;

} // namespace make
