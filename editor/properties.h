// Properties: every value of a world by a dotted name, as `set`, `get` and --set use them:
// environment.sun.azimuth, camera.NAME.fov, template.NAME.sink, object.ID.position, terrain.metres_per_texel.
#pragma once

#include "editor/document.h"
#include "io/base/value.h"

#include <string>
#include <string_view>
#include <vector>

namespace editor {

// An error names the key and changes nothing. What it changes goes through undo. Text will do for any value, as typed
// on a command line: "on", "1.5", "1,0.9,0.8".
io::Result<io::Value> getProperty(const Document& document, std::string_view key);
io::Status setProperty(Document& document, std::string_view key, const io::Value& value);

struct Property {
    std::string key;
    io::Value value;
};
// Several of the environment, all or none, as one step: what must be in order, as ends of cascades, is looked at when all are set.
io::Status setProperties(Document& document, const std::vector<Property>& properties);

// A value as typed on a command line: a JSON array where it is one, otherwise the text as it is.
io::Value valueFromText(std::string_view text);

} // namespace editor
