#include "editor/panels/console_panel.h"

#include "editor/numbers_text.h"
#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>

namespace editor {
namespace {

constexpr std::size_t kKept = 4000;

struct LevelLook {
    const char* text;
    Icon icon;
    ImU32 colour;
};
constexpr LevelLook kLevels[] = {{"console.debug", Icon::Console, palette::kSoftText},
                                 {"console.info", Icon::Info, palette::kBlue},
                                 {"console.warning", Icon::Warning, palette::kAmber},
                                 {"console.error", Icon::Error, palette::kRed}};

std::size_t indexOf(io::log::Level level)
{
    return std::min<std::size_t>(std::size_t(level), 3);
}

std::string timeText(double seconds)
{
    const auto s = std::uint64_t(seconds);
    return fmt::format("{:02}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

} // namespace

void ConsolePanel::draw(Editor&)
{
    takeNewLines();
    header();
    ImGui::BeginChild("##lines", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
    if (m_shown.empty()) ui::emptyState(Icon::Console, tr("console.empty"), tr("console.empty_text"));
    ImGui::PushFont(monoFont());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{8, 3});
    ImGuiListClipper clipper;
    clipper.Begin(int(m_shown.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            line(m_lines[m_shown[std::size_t(i)]]);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    if (std::exchange(m_toEnd, false)) ImGui::SetScrollHereY(1);
    ImGui::EndChild();
}

void ConsolePanel::takeNewLines()
{
    std::vector<io::log::Line> lines = io::log::linesAfter(m_last);
    if (lines.empty()) return;
    m_last = lines.back().number;
    for (io::log::Line& l : lines)
        ++m_counts[indexOf(l.level)], m_lines.push_back(std::move(l));
    if (m_lines.size() > kKept) m_lines.erase(m_lines.begin(), m_lines.end() - std::ptrdiff_t(kKept));
    filter();
    m_toEnd = true;
}

void ConsolePanel::filter()
{
    m_shown.clear();
    for (std::size_t i = 0; i < m_lines.size(); ++i)
        if (shown(m_lines[i])) m_shown.push_back(i);
}

bool ConsolePanel::shown(const io::log::Line& line) const
{
    return m_levels[indexOf(line.level)] && holds(line.text, lowerCase(m_search));
}

void ConsolePanel::header()
{
    for (std::size_t i = 4; i-- > 0;) {
        const std::string text = trf("console.level", tr(kLevels[i].text), grouped(m_counts[i]));
        if (ui::toggleChip(kLevels[i].text, text.c_str(), kLevels[i].icon, kLevels[i].colour, m_levels[i])) filter();
        ImGui::SameLine(0, 6);
    }
    ImGui::SetNextItemWidth(std::clamp(ImGui::GetContentRegionAvail().x - 84, 80.f, 260.f));
    if (ui::searchField("##search", tr("console.search"), m_search)) filter();
    ImGui::SameLine(0, 6);
    const float size = ImGui::GetFrameHeight() + 2;
    if (ui::iconButton({.id = "copy", .icon = Icon::Copy, .label = tr("console.copy"), .size = size})) {
        std::string all;
        for (const std::size_t i : m_shown)
            all += m_lines[i].text + "\n";
        ImGui::SetClipboardText(all.c_str());
    }
    ImGui::SameLine(0, 2);
    if (ui::iconButton({.id = "clear", .icon = Icon::Trash, .label = tr("console.clear"), .size = size})) {
        m_lines.clear();
        m_shown.clear();
        m_counts = {};
    }
}

void ConsolePanel::line(const io::log::Line& line) const
{
    const LevelLook& look = kLevels[indexOf(line.level)];
    ImGui::TextDisabled("%s", timeText(line.seconds).c_str());
    ImGui::SameLine();
    const bool loud = line.level >= io::log::Level::Warning;
    ui::iconText(look.icon, loud ? look.colour : palette::kText, line.text);
    mapItem("line", line.text);
}

} // namespace editor
