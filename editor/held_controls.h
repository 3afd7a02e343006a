// What is held down now, by the names that a project's controls use: "W", "Shift", "mouse 1", "pad A", "pad left -y".
#pragma once

#include <functional>
#include <map>
#include <string>

namespace editor {

using Held = std::map<std::string, double, std::less<>>; // how far: 1 for a key, up to 1 for a stick

Held heldKeys(); // and buttons of the mouse, as ImGuiIO has them

} // namespace editor
