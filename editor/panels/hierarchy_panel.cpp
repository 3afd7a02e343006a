#include "editor/panels/hierarchy_panel.h"

#include "editor/arrange.h"
#include "editor/editor.h"
#include "editor/numbers_text.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <imgui_stdlib.h>

namespace editor {
namespace {

constexpr float kRow = 24; // pixels

Icon iconOf(const Document& document, const TreeRow& row)
{
    if (row.kind == TreeRow::Kind::Group) return Icon::Group;
    if (row.kind == TreeRow::Kind::Template) return Icon::Folder;
    const io::Template* what = document.scene().find(row.templateId);
    return what && what->model.empty() ? Icon::Marker : what ? Icon::Cube : Icon::Warning;
}

} // namespace

void HierarchyPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    header(editor);
    tree(editor);
}

void HierarchyPanel::header(Editor& editor)
{
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 36);
    if (ui::searchField("##search", tr("hierarchy.search"), m_search)) m_rows.setFilter(m_search);
    ImGui::SameLine(0, 6);
    if (ui::iconButton({.id = "by_template",
                        .icon = Icon::Folder,
                        .label = tr("hierarchy.by_template"),
                        .on = m_rows.byTemplate(),
                        .size = ImGui::GetFrameHeight() + 2}))
        m_rows.setByTemplate(!m_rows.byTemplate());
    const std::size_t chosen = editor.selection().size();
    const std::string all = grouped(editor.document()->scene().objects().size());
    ui::softText(chosen ? trf("hierarchy.count_selected", all, grouped(chosen)) : trf("hierarchy.count", all));
    ImGui::Dummy({0, 1});
}

// What was chosen elsewhere is shown.
void HierarchyPanel::revealSelection(Editor& editor)
{
    if (m_seenSelection == editor.selection().revision()) return;
    m_seenSelection = editor.selection().revision();
    const io::ObjectId primary = editor.selection().primary();
    if (primary == io::ObjectId::None || editor.selection().size() > 1000) return;
    m_rows.reveal(*editor.document(), primary);
    m_rows.update(*editor.document());
    m_scrollTo = m_rows.find(primary);
}

void HierarchyPanel::tree(Editor& editor)
{
    ImGui::BeginChild("##tree", {0, 0}, false, ImGuiWindowFlags_NoNav);
    revealSelection(editor);
    m_rows.update(*editor.document());
    const std::vector<TreeRow>& shown = m_rows.rows();
    if (shown.empty()) ui::emptyState(Icon::Layers, tr("hierarchy.empty"), tr("hierarchy.empty_text"));
    keys(editor);

    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{0, 0});
    ImGuiListClipper clipper;
    clipper.Begin(int(shown.size()), kRow);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            row(editor, shown[std::size_t(i)], std::size_t(i));
    const float wanted = float(m_scrollTo) * kRow;
    if (m_scrollTo != TreeRows::kNoRow &&
        (wanted < ImGui::GetScrollY() || wanted + kRow > ImGui::GetScrollY() + ImGui::GetWindowHeight()))
        ImGui::SetScrollY(std::max(0.f, wanted - ImGui::GetWindowHeight() / 2));
    m_scrollTo = TreeRows::kNoRow;

    const ImVec2 rest = ImGui::GetContentRegionAvail();
    if (rest.y > 4) { // the free room below: click to choose nothing, drop to leave all groups
        if (ImGui::InvisibleButton("##rest", {std::max(rest.x, 1.f), rest.y})) editor.selection().clear();
        dropOn(editor, io::ObjectId::None);
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

std::string HierarchyPanel::text(const Document& document, const TreeRow& row) const
{
    if (row.kind == TreeRow::Kind::Template) return std::string{document.scene().templateName(row.templateId)};
    const io::Object* object = document.scene().find(row.id);
    return object ? displayName(document.scene(), *object) : std::string{};
}

std::vector<io::ObjectId> HierarchyPanel::idsOf(const Document& document, const TreeRow& row) const
{
    if (row.kind != TreeRow::Kind::Template) return {row.id};
    std::vector<io::ObjectId> ids;
    for (const io::Object& object : document.scene().objects())
        if (object.templateId == row.templateId && object.parent == io::ObjectId::None) ids.push_back(object.id);
    std::sort(ids.begin(), ids.end());
    return ids;
}

bool HierarchyPanel::selected(Editor& editor, const TreeRow& row) const
{
    return row.kind != TreeRow::Kind::Template && editor.selection().contains(row.id);
}

void HierarchyPanel::row(Editor& editor, const TreeRow& row, std::size_t index)
{
    const Document& document = *editor.document();
    ImGui::PushID(row.kind == TreeRow::Kind::Template ? int(io::number(row.templateId)) : int(io::number(row.id)));
    ImGui::PushID(int(row.kind));
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max{min.x + ImGui::GetContentRegionAvail().x, min.y + kRow};
    const float indent = 4 + 16 * float(row.depth);
    if (m_renaming == row.id && row.kind != TreeRow::Kind::Template) {
        ImGui::SetCursorScreenPos({min.x + indent + 36, min.y});
        renameField(editor, row);
        ImGui::SetCursorScreenPos({min.x, max.y});
    } else {
        ImGui::InvisibleButton("row", {max.x - min.x, kRow});
        const bool hovered = ImGui::IsItemHovered();
        mapItem("row", text(document, row), selected(editor, row));
        dragRow(editor, row);
        const bool onArrow = ImGui::GetIO().MousePos.x < min.x + indent + 18;
        if (hovered && ImGui::IsMouseDoubleClicked(0) && !onArrow && row.kind != TreeRow::Kind::Template) {
            m_renaming = row.id;
            m_newName = document.scene().at(row.id).name;
            m_renameBegins = true;
        } else if (hovered && ImGui::IsMouseClicked(0) && onArrow && row.kind != TreeRow::Kind::Object) {
            m_rows.setOpen(row, !row.open);
        } else if (hovered && ImGui::IsMouseReleased(0) && !onArrow && ImGui::GetMouseDragDelta(0).x == 0 &&
                   ImGui::GetMouseDragDelta(0).y == 0) {
            clickRow(editor, row, index);
        }
        rowFace(editor, row, min, max, hovered);
    }
    ImGui::PopID();
    ImGui::PopID();
}

void HierarchyPanel::rowFace(Editor& editor, const TreeRow& row, ImVec2 min, ImVec2 max, bool hovered) const
{
    const Document& document = *editor.document();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool chosen = selected(editor, row);
    if (chosen)
        draw.AddRectFilled(min, max, IM_COL32(98, 68, 184, 140), 3);
    else if (hovered)
        draw.AddRectFilled(min, max, IM_COL32(255, 255, 255, 12), 3);
    float x = min.x + 4 + 16 * float(row.depth);
    if (row.kind != TreeRow::Kind::Object)
        drawIcon(draw, row.open ? Icon::ChevronDown : Icon::ChevronRight, {x, min.y + 7}, 10, palette::kSoftText);
    x += 16;
    const ImU32 iconColour = row.kind == TreeRow::Kind::Group ? palette::kAmber
                             : chosen                         ? IM_COL32_WHITE
                                                              : palette::kSoftText;
    drawIcon(draw, iconOf(document, row), {x, min.y + 5}, 14, iconColour);
    x += 21;
    const float top = min.y + (kRow - ImGui::GetFontSize()) / 2;
    const std::string label = text(document, row);
    const std::string count = row.kind == TreeRow::Kind::Object ? std::string{} : grouped(row.count);
    const float countWidth = ImGui::CalcTextSize(count.c_str()).x;
    draw.AddText({x, top}, chosen ? IM_COL32_WHITE : palette::kText,
                 ui::fitted(label, max.x - x - countWidth - 14).c_str());
    draw.AddText({max.x - countWidth - 8, top}, palette::kFaintText, count.c_str());
}

void HierarchyPanel::clickRow(Editor& editor, const TreeRow& row, std::size_t index)
{
    const Document& document = *editor.document();
    const std::vector<TreeRow>& rows = m_rows.rows();
    std::vector<io::ObjectId> ids;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift && m_anchor < rows.size()) {
        const auto [first, last] = std::minmax(m_anchor, index);
        for (std::size_t i = first; i <= last && i < rows.size(); ++i)
            if (rows[i].kind != TreeRow::Kind::Template) ids.push_back(rows[i].id);
        if (m_anchor > index) std::reverse(ids.begin(), ids.end());
    } else {
        ids = idsOf(document, row);
        m_anchor = index;
    }
    editor.inspectTemplate = false;
    editor.selection().apply(io.KeyCtrl ? (io.KeyShift ? SelectMode::Add : SelectMode::Toggle) : SelectMode::Set, ids);
    m_seenSelection = editor.selection().revision(); // it is in sight already
}

void HierarchyPanel::dragRow(Editor& editor, const TreeRow& row)
{
    if (row.kind != TreeRow::Kind::Template && ImGui::BeginDragDropSource()) {
        if (!editor.selection().contains(row.id)) editor.selection().set(row.id);
        m_seenSelection = editor.selection().revision();
        ImGui::SetDragDropPayload("objects", &row.id, sizeof row.id);
        const std::size_t count = editor.selection().size();
        ImGui::TextUnformatted(count == 1 ? text(*editor.document(), row).c_str()
                                          : trf("hierarchy.dragged", count).c_str());
        ImGui::EndDragDropSource();
    }
    if (row.kind == TreeRow::Kind::Group) dropOn(editor, row.id);
}

void HierarchyPanel::dropOn(Editor& editor, io::ObjectId group)
{
    if (!ImGui::BeginDragDropTarget()) return;
    if (ImGui::AcceptDragDropPayload("objects")) {
        const std::vector<io::ObjectId> ids = editor.document()->hierarchy().outermost(editor.selection().ids());
        bool moved = false;
        editor.step("undo.reparent", [&](Document& document) { moved = reparent(document, ids, group); });
        if (!moved) editor.toasts().add(io::log::Level::Warning, tr("hierarchy.cannot_reparent"));
    }
    ImGui::EndDragDropTarget();
}

void HierarchyPanel::renameField(Editor& editor, const TreeRow& row)
{
    ImGui::SetNextItemWidth(-4);
    if (std::exchange(m_renameBegins, false)) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{4, 3});
    ui::textField("##name", tr("hierarchy.name"), m_newName, ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopStyleVar();
    if (ImGui::IsItemDeactivatedAfterEdit() && !pressed(Key::Escape))
        editor.step("undo.rename", [&](Document& document) {
            edit(document, tr("undo.rename"), {{row.id}}, [&](io::Object& o) { o.name = m_newName; });
        });
    if (ImGui::IsItemDeactivated()) m_renaming = io::ObjectId::None;
}

void HierarchyPanel::keys(Editor& editor)
{
    if (ImGui::GetIO().WantTextInput || !ImGui::IsWindowHovered()) return;
    const Document& document = *editor.document();
    const io::ObjectId primary = editor.selection().primary();
    if (pressed(Key::F2) && document.scene().find(primary)) {
        m_renaming = primary;
        m_newName = document.scene().at(primary).name;
        m_renameBegins = true;
        return;
    }
    const int step = int(pressed(Key::Down, true)) - int(pressed(Key::Up, true));
    const std::vector<TreeRow>& rows = m_rows.rows();
    std::size_t at = step ? m_rows.find(primary) : TreeRows::kNoRow;
    if (at == TreeRows::kNoRow) return;
    do
        at += std::size_t(step);
    while (at < rows.size() && rows[at].kind == TreeRow::Kind::Template);
    if (at >= rows.size()) return;
    editor.selection().set(rows[at].id);
    m_anchor = at;
}

} // namespace editor
