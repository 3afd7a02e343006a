// Cards of leaves lose what is all transparent of them: a picture of a branch covers a quarter of its square, and every
// pixel of the rest would be looked at, and found empty, in each pass and by each ray.
#pragma once

#include "io/scene/model.h"

namespace io {

// Cuts the triangles of masked parts, at all levels, to polygons around what is opaque there. Surface and texture
// coordinates stay where they are, but that a quad may be split along its other diagonal; at coarser levels they stray by
// no more than half of the level's error. What cannot be told (a texture that repeats across a card, or has no alpha)
// stays as it is. Bounds stay, and triangles() still counts what the file holds.
// To be called after levels are made: those count cards.
void trimCards(Model& model);

} // namespace io
