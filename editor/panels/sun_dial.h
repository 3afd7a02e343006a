// The sky seen from below: the zenith in the middle, the horizon at the rim, north up. Shows where the sun stands and
// the way it takes through the day; dragging the sun turns it.
#pragma once

#include "io/scene/environment.h"

namespace editor {

// True when the person dragged the sun: then it is placed by hand. As wide as the panel.
bool sunDial(io::Environment& environment);

} // namespace editor
