// The start page: shown while no project is open. Recent projects, the worlds that ship, New and Open.
#pragma once

#include <filesystem>
#include <imgui.h>
#include <vector>

namespace editor {

class Editor;

struct StartLists {
    std::vector<std::filesystem::path> recent, worlds; // projects; newest first
};

void startPage(Editor& editor, ImVec2 min, ImVec2 max);

} // namespace editor
