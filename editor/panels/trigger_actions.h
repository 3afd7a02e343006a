// The list of what a trigger does: what kind of thing, with what, for how long, and in which order.
#pragma once

#include "io/scene/template.h"

#include <string>
#include <vector>

namespace editor {

class Document;

// Whether it was changed; `what` then tells one widget from another.
bool triggerActions(const Document& document, std::vector<io::TriggerAction>& actions, std::string& what);

} // namespace editor
