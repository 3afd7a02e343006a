// The curve by which a sound gets softer with distance, as a picture whose points are dragged: a double click adds one, the right
// button takes one away.
#pragma once

#include "io/scene/template.h"

#include <vector>

namespace editor {

bool falloffCurve(std::vector<io::FalloffKey>& keys, float radius); // as wide as the panel; whether it was changed

} // namespace editor
