// What a world says of playing it, that nobody could do: what `wold check` says of it.
#pragma once

#include "io/base/complaint.h"
#include "io/files/kept_looks.h"
#include "io/files/project.h"

namespace app {

// Controls of actions and of keys that there are none of; triggers that name a look, a camera, an object or a group that is not
// there; a start beside the map. Where: the file, as a path below the project, that says it.
io::Complaints checkPlay(const io::World& world, const io::KeptLooks& kept);

} // namespace app
