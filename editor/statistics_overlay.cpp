#include "editor/statistics_overlay.h"

#include "editor/frame_timeline.h"
#include "editor/numbers_text.h"
#include "editor/text.h"
#include "editor/theme.h"
#include "editor/ui_map.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace editor {
namespace {

constexpr float kWidth = 330, kPadding = 10, kLine = 18, kTimeline = 52; // points
constexpr ImU32 kGround = IM_COL32(18, 18, 21, 215);

using Row = std::pair<std::string, std::string>;

std::string levelsText(const renderer::FrameStats& stats)
{
    std::string text;
    for (std::size_t level = 0; level < stats.trianglesOfLevel.size(); ++level)
        if (stats.trianglesOfLevel[level])
            text += fmt::format("{}{}: {}", text.empty() ? "" : "   ", level, grouped(stats.trianglesOfLevel[level]));
    return text;
}

std::string countText(std::uint64_t number, const renderer::FrameStats& stats)
{
    return stats.instancesInside == 0 && stats.instancesDrawn > 0 ? "–" : grouped(number); // not counted
}

std::vector<Row> rowsOf(const FrameHistory& frames, const renderer::FrameStats& stats)
{
    const double ms = frames.meanMs();
    std::vector<Row> rows{{tr("statistics.frame"), trf("statistics.frame_text", ms > 0 ? 1000 / ms : 0, ms)},
                          {tr("statistics.instances"), grouped(stats.instances)},
                          {tr("statistics.inside"), countText(stats.instancesInside, stats)},
                          {tr("statistics.hidden"), countText(stats.instancesHidden, stats)},
                          {tr("statistics.instances_drawn"), grouped(stats.instancesDrawn)},
                          {tr("statistics.triangles"), grouped(stats.trianglesDrawn)},
                          {tr("statistics.submitted"), grouped(stats.trianglesSubmitted)},
                          {tr("statistics.draws"), grouped(stats.drawCalls)},
                          {tr("statistics.gpu_memory"), byteText(stats.gpuBytes)}};
    if (std::string levels = levelsText(stats); !levels.empty()) // as long as a line, so below its name
        rows.insert(rows.begin() + 6, {{tr("statistics.levels"), ""}, {"", std::move(levels)}});
    if (stats.cullingFrozen) rows.insert(rows.begin() + 1, {tr("statistics.culling"), tr("statistics.frozen")});
    return rows;
}

void rightText(ImDrawList& draw, float right, float y, ImU32 colour, const std::string& text)
{
    draw.AddText({right - ImGui::CalcTextSize(text.c_str()).x, y}, colour, text.c_str());
}

void row(ImDrawList& draw, const Row& row, ImVec2 at, float width)
{
    const auto& [name, value] = row;
    draw.AddText(at, palette::kSoftText, name.c_str());
    rightText(draw, at.x + width, at.y, palette::kText, value);
    mapRect("statistic", name, at, {at.x + width, at.y + kLine}, value);
}

void passRow(ImDrawList& draw, const renderer::PassTime& pass, ImU32 colour, ImVec2 at, float width)
{
    draw.AddRectFilled({at.x, at.y + 4}, {at.x + 9, at.y + 13}, colour, 2);
    draw.AddText({at.x + 16, at.y}, palette::kSoftText, pass.name.c_str());
    rightText(draw, at.x + width - 70, at.y, palette::kText, fmt::format("{:.2f}", pass.cpuMs));
    rightText(draw, at.x + width, at.y, palette::kText, fmt::format("{:.2f}", pass.gpuMs));
}

} // namespace

void statisticsOverlay(const FrameHistory& frames, const renderer::FrameStats& stats, ImVec2 top, ImVec2 room)
{
    const std::vector<Row> rows = rowsOf(frames, stats);
    const std::vector<renderer::PassTime> passes = frames.means();
    const float width = std::min(kWidth, room.x);
    const float whole = 2 * kPadding + kLine * float(rows.size()) + 2 * (kTimeline + 6) + 6 +
                        (passes.empty() ? 0 : kLine * float(passes.size() + 1));
    if (width < 160) return;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 max{top.x + width, top.y + std::min(whole, room.y)};
    draw.PushClipRect(top, max, true);
    draw.AddRectFilled(top, max, kGround, 5);
    const float inner = width - 2 * kPadding;
    ImVec2 at{top.x + kPadding, top.y + kPadding};
    for (const Row& one : rows)
        row(draw, one, at, inner), at.y += kLine;
    at.y += 6;
    for (const Clock clock : {Clock::Cpu, Clock::Gpu}) {
        frameTimeline(draw, frames, clock, at, {at.x + inner, at.y + kTimeline});
        at.y += kTimeline + 6;
    }
    if (!passes.empty()) {
        draw.AddText(at, palette::kFaintText, tr("statistics.pass"));
        rightText(draw, at.x + inner - 70, at.y, palette::kFaintText, tr("statistics.cpu"));
        rightText(draw, at.x + inner, at.y, palette::kFaintText, tr("statistics.gpu"));
        at.y += kLine;
    }
    for (const renderer::PassTime& pass : passes)
        passRow(draw, pass, colourOfPass(passes, pass.name), at, inner), at.y += kLine;
    draw.PopClipRect();
}

} // namespace editor
