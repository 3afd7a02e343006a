// Where a thing came to be.
#pragma once

#include "io/scene/ids.h"
#include "io/scene/transform.h"

namespace io {

struct Moved {
    ObjectId id = ObjectId::None;
    Transform transform;
};

} // namespace io
