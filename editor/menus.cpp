#include "editor/menus.h"

#include "editor/editor.h"
#include "editor/instance_edits.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <cmath>
#include <string>

namespace editor {
namespace {

void items(Editor& editor, std::initializer_list<const char*> ids)
{
    for (const char* id : ids) {
        if (*id)
            editor.actions().menuItem(id);
        else
            ImGui::Separator();
    }
}

void recentMenu(Editor& editor)
{
    const auto recent = editor.host().recentProjects();
    if (!ui::beginMenu(tr("menu.recent"), !recent.empty())) return;
    for (const std::filesystem::path& project : recent)
        if (ui::menuItem(project.c_str(), nullptr, false, true, Icon::Terrain))
            editor.dialogs().askToSave(editor, [&editor, project] { editor.openLater(project); });
    ImGui::EndMenu();
}

void scenesMenu(Editor& editor)
{
    const Document* document = editor.document();
    if (!document || document->project().scenes.size() < 2 || !ui::beginMenu(tr("menu.scenes"))) return;
    for (const io::SceneEntry& entry : document->project().scenes) {
        const bool open = entry.name == document->world().entry.name;
        if (!ui::menuItem(entry.name.c_str(), nullptr, open) || open) continue;
        editor.dialogs().askToSave(editor, [&editor, folder = document->project().folder, name = entry.name] {
            editor.openLater(folder, name);
        });
    }
    ImGui::EndMenu();
}

void fileMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.file"))) return;
    items(editor, {"new", "open"});
    recentMenu(editor);
    scenesMenu(editor);
    items(editor, {"", "save", "save_as", "revert", "", "import_heights", "export_heights", "", "close", "quit"});
    ImGui::EndMenu();
}

void editMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.edit"))) return;
    items(editor, {"undo", "redo", "", "cut", "copy", "paste", "duplicate", "delete", "", "select_all", "select_none",
                   "invert", "select_same", "", "group", "ungroup", "", "promote", "demote"});
    ImGui::EndMenu();
}

void panelsMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.panels"))) return;
    for (const Panel* panel : editor.workspace().panels())
        if (ui::menuItem(tr("panel." + std::string{panel->id()}), nullptr, editor.workspace().shows(panel->id()), true,
                         panel->icon()))
            editor.workspace().toggle(panel->id());
    ImGui::Separator();
    editor.actions().menuItem("reset_layout");
    ImGui::EndMenu();
}

void showMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.show"))) return;
    const auto names = enumNames(editor.show);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto show = renderer::Show(i);
        if (ui::menuItem(tr("show." + std::string{names[i]}), nullptr, editor.show == show)) editor.show = show;
    }
    ImGui::EndMenu();
}

void camerasMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.cameras"), editor.document() != nullptr)) return;
    for (const io::Camera& camera : editor.document()->scene().cameras())
        if (ui::menuItem(camera.name.c_str(), nullptr, false, true, Icon::Camera))
            editor.viewport().camera.setCamera(camera);
    if (!editor.document()->scene().cameras().empty()) ImGui::Separator();
    editor.actions().menuItem("store_camera");
    ImGui::EndMenu();
}

void languageMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.language"))) return;
    const std::string now = editor.host().language();
    for (const Language& language : editor.host().languages())
        if (ui::menuItem(language.name.c_str(), nullptr, language.code == now))
            editor.host().setLanguage(language.code);
    ImGui::EndMenu();
}

void sizeMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.size"))) return;
    const int now = int(std::lround(editor.host().uiScale() * 100));
    for (const int percent : {75, 100, 125, 150, 175, 200, 250})
        if (ui::menuItem((std::to_string(percent) + " %").c_str(), nullptr, percent == now))
            editor.host().setUiScale(float(percent) / 100);
    ImGui::EndMenu();
}

void rateMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.frame_rate"))) return;
    const int now = int(std::lround(editor.host().frameRate()));
    for (const int rate : {15, 20, 30, 45, 60})
        if (ui::menuItem(std::to_string(rate).c_str(), nullptr, rate == now)) editor.host().setFrameRate(rate);
    ImGui::EndMenu();
}

void viewMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.view"))) return;
    items(editor, {"frame", "look_played"});
    camerasMenu(editor);
    ImGui::Separator();
    showMenu(editor);
    items(editor, {"rendering", "overlays", "statistics", "freeze_culling", "tree_nodes", "animate", "hear"});
    ImGui::Separator();
    panelsMenu(editor);
    rateMenu(editor);
    languageMenu(editor);
    sizeMenu(editor);
    ImGui::EndMenu();
}

void toolsMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.tools"))) return;
    items(editor, {"play", "play_start", "keep_play", "controls", "", "tool_select", "tool_move", "tool_rotate", "tool_scale", "tool_sculpt", "tool_scatter", "", "brush_smaller", "brush_larger", "generate_ground", "reshape_ground", "", "space", "snap", "", "place",
                   "place_camera", "drop", "drop_align", "", "pick_boxes", "reload_shaders"});
    ImGui::EndMenu();
}

void helpMenu(Editor& editor)
{
    if (!ui::beginMenu(tr("menu.help"))) return;
    items(editor, {"keys"});
    ImGui::EndMenu();
}

void divider()
{
    ImGui::SameLine(0, 8);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 5}, {at.x, at.y + ui::kToolSize - 5}, palette::kSoftEdge);
    ImGui::Dummy({1, ui::kToolSize});
    ImGui::SameLine(0, 8);
}

void tools(Editor& editor, std::initializer_list<const char*> ids)
{
    bool first = true;
    for (const char* id : ids) {
        if (!std::exchange(first, false)) ImGui::SameLine(0, 2);
        editor.actions().toolButton(id);
    }
}

void showChoice(Editor& editor)
{
    std::vector<std::string> names;
    for (const std::string_view name : enumNames(editor.show))
        names.emplace_back(tr("show." + std::string{name}));
    int chosen = int(editor.show);
    constexpr float kWidth = 170;
    ImGui::SameLine(ImGui::GetWindowWidth() - kWidth - 8);
    ImGui::SetCursorPosY((ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) / 2);
    ImGui::SetNextItemWidth(kWidth);
    if (ui::combo("##show", tr("menu.show"), names, chosen)) editor.show = renderer::Show(chosen);
}

constexpr ImGuiWindowFlags kBar = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                  ImGuiWindowFlags_NoNav;

void beginBar(const char* id, float top, float height, ImVec2 padding)
{
    ImGui::SetNextWindowPos({0, top});
    ImGui::SetNextWindowSize({ImGui::GetIO().DisplaySize.x, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kStrip);
    ImGui::Begin(id, nullptr, kBar);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

std::string selectionText(Editor& editor)
{
    const Selection& selection = editor.selection();
    if (selection.empty()) return tr("status.none_selected");
    const io::Object* primary = editor.document()->scene().find(selection.primary());
    const auto instance = editor.document()->scene().findInstance(selection.primary());
    const std::string name = primary    ? displayName(editor.document()->scene(), *primary)
                             : instance ? instanceName(editor.document()->scene(), *instance)
                                        : std::string{};
    return selection.size() == 1 ? name : trf("status.selected", selection.size(), name);
}

} // namespace

void menuBar(Editor& editor)
{
    const MapPanel map{"menu"};
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{8, 7});
    const bool open = ImGui::BeginMainMenuBar();
    ImGui::PopStyleVar();
    if (!open) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{8, 8});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{12, 7});
    fileMenu(editor);
    editMenu(editor);
    viewMenu(editor);
    toolsMenu(editor);
    helpMenu(editor);
    ImGui::PopStyleVar(2);
    const std::string title = editor.title();
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({(ImGui::GetWindowWidth() - width) / 2, 7}, palette::kSoftText, title.c_str());
    ImGui::EndMainMenuBar();
}

float toolbar(Editor& editor, float top)
{
    constexpr float kHeight = 40;
    const MapPanel map{"toolbar"};
    beginBar("##toolbar", top, kHeight, {8, 5});
    tools(editor, {"open", "save"});
    divider();
    tools(editor, {"undo", "redo"});
    divider();
    tools(editor, {"tool_select", "tool_move", "tool_rotate", "tool_scale", "tool_sculpt", "tool_scatter"});
    divider();
    tools(editor, {"space", "snap"});
    divider();
    tools(editor, {"place", "place_camera", "drop"});
    divider();
    tools(editor, {"frame", "duplicate", "group", "delete"});
    showChoice(editor);
    ImGui::End();
    return top + kHeight;
}

float statusBar(Editor& editor)
{
    constexpr float kHeight = 26;
    const float top = ImGui::GetIO().DisplaySize.y - kHeight;
    const MapPanel map{"status"};
    beginBar("##status", top, kHeight, {12, 4});
    if (editor.document()) {
        ui::softText(selectionText(editor));
        mapItem("label", selectionText(editor));
        const History& history = editor.document()->history();
        const std::string last = history.canUndo() ? history.names()[history.position() - 1] : std::string{};
        const std::string right = trf(editor.modified() ? "status.unsaved" : "status.saved", last);
        const float width = ImGui::CalcTextSize(right.c_str()).x;
        ImGui::SameLine(ImGui::GetWindowWidth() - width - 12);
        ui::softText(right);
    }
    ImGui::End();
    return top;
}

} // namespace editor
