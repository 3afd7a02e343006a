#include "editor/start_page.h"

#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

namespace fs = std::filesystem;
constexpr float kWidth = 860, kCard = 56;

// A project as a card: its name, and where it lies.
bool projectCard(const fs::path& project, Icon icon)
{
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max{min.x + ImGui::GetContentRegionAvail().x, min.y + kCard};
    const bool clicked = ImGui::InvisibleButton(project.c_str(), {max.x - min.x, kCard});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(min, max, ImGui::IsItemHovered() ? palette::kHover : palette::kRaised, 5);
    drawIcon(draw, icon, {min.x + 16, min.y + 16}, 24, palette::kAccent);
    draw.AddText(boldFont(), sizeOf(boldFont()), {min.x + 56, min.y + 10}, palette::kText,
                 project.filename().c_str());
    draw.AddText({min.x + 56, min.y + 30}, palette::kFaintText,
                 ui::fitted(project.string(), max.x - min.x - 70).c_str());
    mapItem("project", project.filename().string());
    return clicked;
}

void column(Editor& editor, const char* title, const char* empty, const std::vector<fs::path>& projects, Icon icon)
{
    ui::heading(title);
    ImGui::Dummy({0, 4});
    if (projects.empty()) ui::softText(empty);
    for (std::size_t i = 0; i < std::min<std::size_t>(projects.size(), 6); ++i)
        if (projectCard(projects[i], icon)) editor.openLater(projects[i]);
}

} // namespace

void startPage(Editor& editor, ImVec2 min, ImVec2 max)
{
    const MapPanel map{"start"};
    ImGui::SetNextWindowPos(min);
    ImGui::SetNextWindowSize({max.x - min.x, max.y - min.y});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kBack);
    ImGui::Begin("##start", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleColor();
    const float width = std::min(kWidth, max.x - min.x - 48);
    ImGui::SetCursorPos({std::floor((max.x - min.x - width) / 2), std::max(32.f, (max.y - min.y) * 0.14f)});
    ImGui::BeginChild("##content", {width, 0});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    drawIcon(*ImGui::GetWindowDrawList(), Icon::Terrain, {at.x, at.y}, 40, palette::kAccent);
    ImGui::SetCursorPosX(56);
    ImGui::PushFont(largeFont());
    ImGui::TextUnformatted("Wold");
    ImGui::PopFont();
    ImGui::SetCursorPosX(56);
    ui::softText(tr("start.subtitle"));
    ImGui::Dummy({0, 18});
    if (ui::button("new", tr("start.new"), ui::Emphasis::Accent, {180, 36})) editor.actions().run("new");
    ImGui::SameLine(0, 8);
    if (ui::button("open", tr("start.open"), ui::Emphasis::Normal, {180, 36})) editor.actions().run("open");
    ImGui::Dummy({0, 22});
    const float half = (width - 32) / 2;
    ImGui::BeginChild("##recent", {half, 0});
    column(editor, tr("start.recent"), tr("start.no_recent"), editor.startLists().recent, Icon::Clock);
    ImGui::EndChild();
    ImGui::SameLine(0, 32);
    ImGui::BeginChild("##worlds", {half, 0});
    column(editor, tr("start.worlds"), tr("start.no_worlds"), editor.startLists().worlds, Icon::Terrain);
    ImGui::EndChild();
    ImGui::EndChild();
    ImGui::End();
}

} // namespace editor
