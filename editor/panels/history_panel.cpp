#include "editor/panels/history_panel.h"

#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"

namespace editor {

void HistoryPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    constexpr float kRow = 24;
    const std::vector<std::string> names = editor.document()->history().names();
    const std::size_t now = editor.document()->history().position();
    std::size_t target = now;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{0, 0});
    ImGuiListClipper clipper;
    clipper.Begin(int(names.size()) + 1, kRow);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::string text = i == 0 ? tr("history.opened") : names[std::size_t(i - 1)];
            ImGui::PushID(i);
            const ImVec2 min = ImGui::GetCursorScreenPos();
            const ImVec2 max{min.x + ImGui::GetContentRegionAvail().x, min.y + kRow};
            if (ImGui::InvisibleButton("step", {max.x - min.x, kRow})) target = std::size_t(i);
            ImDrawList& draw = *ImGui::GetWindowDrawList();
            const bool current = std::size_t(i) == now, undone = std::size_t(i) > now;
            if (current)
                draw.AddRectFilled(min, max, IM_COL32(98, 68, 184, 140), 3);
            else if (ImGui::IsItemHovered())
                draw.AddRectFilled(min, max, IM_COL32(255, 255, 255, 12), 3);
            drawIcon(draw, i == 0 ? Icon::Open : Icon::Check, {min.x + 8, min.y + 6}, 12,
                     undone ? palette::kFaintText : palette::kSoftText);
            draw.AddText({min.x + 30, min.y + 4}, undone ? palette::kFaintText : palette::kText, text.c_str());
            mapItem("step", text, current);
            ImGui::PopID();
        }
    }
    ImGui::PopStyleVar();
    if (std::exchange(m_seen, now) != now) ImGui::SetScrollY(float(now) * kRow - ImGui::GetWindowHeight() / 2);
    if (target != now) editor.document()->goTo(target);
}

} // namespace editor
