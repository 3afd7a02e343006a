// One thing that stands in the world: an instance of a template, or a group that holds others.
#pragma once

#include "io/scene/extra.h"
#include "io/scene/ids.h"
#include "io/scene/transform.h"

#include <string>

namespace io {

struct Object {
    ObjectId id = ObjectId::None;
    TemplateId templateId = TemplateId::None; // None: a group
    Transform transform;                      // world space, also inside a group
    ObjectId parent = ObjectId::None;         // the group it belongs to
    std::string name;                         // empty: shown as its template's name and its id
    Extra extra;

    bool operator==(const Object&) const = default;
};

} // namespace io
