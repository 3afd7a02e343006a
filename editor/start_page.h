// The start page: shown while no project is open. Recent projects, the worlds that ship, New and Open.
#pragma once

#include <imgui.h>

namespace editor {

class Editor;

void startPage(Editor& editor, ImVec2 min, ImVec2 max);

} // namespace editor
