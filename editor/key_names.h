// Names of keys as files have them: replays, and the controls of a project. Letters, digits and F1 to F12 are named by themselves.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace editor {

std::optional<int> keyNamed(std::string_view name); // "S" "7" "F5" "Delete" "Shift": its code, as editor::Key has them
std::string nameOfKey(int code);                    // empty: it has none
bool sameWord(std::string_view a, std::string_view b); // whatever their case

} // namespace editor
