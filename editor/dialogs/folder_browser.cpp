#include "editor/dialogs/folder_browser.h"

#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <cstdlib>

namespace editor {
namespace fs = std::filesystem;

bool isProject(const fs::path& folder)
{
    std::error_code none;
    return fs::is_regular_file(folder / "project.json", none);
}

void FolderBrowser::start(const fs::path& folder, Wanted files)
{
    m_files = std::move(files);
    std::error_code none;
    fs::path at = fs::absolute(folder, none);
    while (!fs::is_directory(at, none) && at.has_relative_path())
        at = at.parent_path();
    enter(at);
    m_confirmed = false;
}

bool FolderBrowser::confirmed()
{
    return std::exchange(m_confirmed, false);
}

void FolderBrowser::enter(const fs::path& folder)
{
    m_folder = folder.lexically_normal();
    m_text = m_folder.string();
    read();
}

void FolderBrowser::read()
{
    m_entries.clear();
    std::error_code fault;
    for (fs::directory_iterator at{m_folder, fs::directory_options::skip_permission_denied, fault}, end;
         !fault && at != end; at.increment(fault)) {
        std::error_code none;
        const std::string name = at->path().filename().string();
        if (name.starts_with('.')) continue;
        if (at->is_directory(none)) m_entries.push_back({name, isProject(at->path())});
        else if (m_files && at->is_regular_file(none) && m_files(at->path())) m_entries.push_back({name, false, true});
    }
    std::sort(m_entries.begin(), m_entries.end(),
              [](const Entry& a, const Entry& b) { return std::pair{a.file, lowerCase(a.name)} < std::pair{b.file, lowerCase(b.name)}; });
}

void FolderBrowser::draw(float height)
{
    const float size = ImGui::GetFrameHeight() + 2;
    if (ui::iconButton({.id = "up", .icon = Icon::Up, .label = tr("browser.up"), .size = size}) &&
        m_folder.has_parent_path())
        enter(m_folder.parent_path());
    ImGui::SameLine(0, 2);
    if (ui::iconButton({.id = "home", .icon = Icon::Home, .label = tr("browser.home"), .size = size}))
        if (const char* home = std::getenv("HOME")) enter(home);
    ImGui::SameLine(0, 8);
    ImGui::SetNextItemWidth(-1);
    if (ui::textField("##path", tr("browser.path"), m_text)) {
        std::error_code none;
        if (fs::is_directory(m_text, none)) {
            m_folder = fs::path{m_text}.lexically_normal();
            read();
        }
    }
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kField);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{6, 6});
    ImGui::BeginChild("##folders", {0, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{0, 0});
    const std::vector<Entry> entries = m_entries; // entering a folder changes the list
    for (const Entry& entry : entries)
        row(entry);
    if (entries.empty()) ui::softText(m_files ? tr("browser.no_files") : tr("browser.empty"));
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void FolderBrowser::row(const Entry& entry)
{
    constexpr float kRow = 26;
    const fs::path path = m_folder / entry.name;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max{min.x + ImGui::GetContentRegionAvail().x, min.y + kRow};
    const bool clicked = ImGui::InvisibleButton(entry.name.c_str(), {max.x - min.x, kRow});
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool on = m_text == path.string();
    if (on || hovered) draw.AddRectFilled(min, max, on ? IM_COL32(98, 68, 184, 140) : IM_COL32(255, 255, 255, 12), 3);
    drawIcon(draw, entry.project || entry.file ? Icon::Terrain : Icon::Folder, {min.x + 8, min.y + 6}, 14,
             entry.project ? palette::kAccent : palette::kSoftText);
    draw.AddText({min.x + 32, min.y + 5}, palette::kText, entry.name.c_str());
    if (entry.project) {
        const char* mark = tr("browser.project");
        draw.AddText({max.x - ImGui::CalcTextSize(mark).x - 10, min.y + 5}, palette::kFaintText, mark);
    }
    mapItem(entry.file ? "file" : "folder", entry.name, on);
    if (entry.file) {
        if (clicked) m_text = path.string();
    } else if (hovered && ImGui::IsMouseDoubleClicked(0)) {
        if (entry.project)
            m_text = path.string(), m_confirmed = true;
        else
            enter(path);
    } else if (clicked) {
        if (entry.project)
            m_text = path.string();
        else
            enter(path);
    }
}

} // namespace editor
