#include "editor/dialogs/dialog_frame.h"

#include "editor/widgets.h"

namespace editor {

bool beginDialog(const char* id, const char* title, float width)
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y * 0.46f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, display.y - 40});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{20, 18});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    const bool open = ImGui::BeginPopupModal(id, nullptr, flags);
    ImGui::PopStyleVar(3);
    if (!open) return false;
    ui::heading(title);
    mapItem("title", title);
    ImGui::Dummy({0, 4});
    return true;
}

} // namespace editor
