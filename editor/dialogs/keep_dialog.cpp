// What of a play a person wants to keep: a list of what stands otherwise, of which nothing is ticked at first.
#include "editor/dialogs/dialogs.h"
#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>

namespace editor {
namespace {

constexpr const char* kProperties[] = {"keep.position", "keep.rotation", "keep.shown"};

std::string valueOf(const io::Object* object, PlayProperty property)
{
    if (property == PlayProperty::Shown) return tr(object ? "keep.yes" : "keep.no");
    if (!object) return {};
    if (property == PlayProperty::Position) {
        const glm::dvec3& at = object->transform.position;
        return fmt::format("{:.2f}  {:.2f}  {:.2f} m", at.x, at.y, at.z);
    }
    const glm::vec3& turn = object->transform.rotation;
    return fmt::format("{:.0f}\xc2\xb0  {:.0f}\xc2\xb0  {:.0f}\xc2\xb0", turn.x, turn.y, turn.z);
}

} // namespace

void Dialogs::showKeepPlay(Editor& editor)
{
    m_rows = playRows(*editor.document(), editor.playChanges());
    m_which = Which::KeepPlay;
}

void Dialogs::drawKeepPlay(Editor& editor)
{
    if (!editor.document() || !begin(tr("dialog.keep_play"), 760)) return;
    ui::softText(tr("dialog.keep_play_text"));
    ImGui::Dummy({0, 6});
    bool all = std::ranges::all_of(m_rows, &PlayRow::keep);
    if (ui::checkbox("##all", tr("keep.all"), all))
        for (PlayRow& row : m_rows)
            row.keep = all;
    ImGui::BeginChild("##rows", {0, 320});
    if (ImGui::BeginTable("##table", 4, ImGuiTableFlags_RowBg)) {
        ImGuiListClipper clipper;
        clipper.Begin(int(m_rows.size()));
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
                drawKeepRow(editor, m_rows[std::size_t(i)]);
        ImGui::EndTable();
    }
    ImGui::EndChild();
    if (buttons(tr("keep.accept"), std::ranges::any_of(m_rows, &PlayRow::keep))) {
        keepPlayChanges(*editor.document(), tr("undo.keep_play"), editor.playChanges(), m_rows);
        close();
    }
    end();
}

void Dialogs::drawKeepRow(Editor& editor, PlayRow& row)
{
    const io::Object* now = editor.document()->scene().find(row.id);
    const auto change = std::ranges::find(editor.playChanges(), row.id, [](const PlayChange& one) { return one.before.id; });
    if (!now || change == editor.playChanges().end()) return;
    const std::string name = displayName(editor.document()->scene(), *now), property = tr(kProperties[std::size_t(row.property)]);
    ImGui::PushID(int(number(row.id)) * 3 + int(row.property));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ui::checkbox("##keep", name.c_str(), row.keep, name + " " + property);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(property.c_str());
    ImGui::TableNextColumn();
    ui::softText(valueOf(now, row.property));
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(valueOf(change->after ? &*change->after : nullptr, row.property).c_str());
    ImGui::PopID();
}

} // namespace editor
