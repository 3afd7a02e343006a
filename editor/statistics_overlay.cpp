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

constexpr float kWidth = 312, kPadding = 10, kLine = 15, kTimeline = 36, kGap = 6; // points
constexpr ImU32 kGround = IM_COL32(18, 18, 21, 215);

using Row = std::pair<std::string, std::string>;
using Rows = std::vector<Row>;

std::string shortened(std::uint64_t number) // five digits at most
{
    return number < 10'000 ? grouped(number) : grouped((number + 500) / 1000) + "k";
}

std::string levelsText(const renderer::FrameStats& stats)
{
    std::string text;
    for (std::size_t level = 0; level < stats.trianglesOfLevel.size(); ++level)
        if (stats.trianglesOfLevel[level])
            text += fmt::format("{}{}: {}", text.empty() ? "" : "  ", level, shortened(stats.trianglesOfLevel[level]));
    return text;
}

Row passed(const char* key, std::uint64_t out, std::uint64_t in)
{
    return {tr(key), trf("statistics.of", grouped(out), grouped(in))};
}

// What each test of culling was given, and what it let through.
void addCulling(Rows& rows, const renderer::FrameStats& stats)
{
    if (stats.cullingFrozen) rows.emplace_back(tr("statistics.culling"), tr("statistics.frozen"));
    const std::uint64_t shown = stats.instancesLarge - std::min(stats.instancesHidden, stats.instancesLarge);
    rows.push_back(passed("statistics.inside", stats.instancesInside, stats.instances));
    rows.push_back(passed("statistics.large", stats.instancesLarge, stats.instancesInside));
    if (stats.occlusionTested) rows.push_back(passed("statistics.not_hidden", shown, stats.instancesLarge));
    else rows.emplace_back(tr("statistics.not_hidden"), tr("statistics.not_tested"));
    rows.emplace_back(tr("statistics.drawn"), grouped(stats.instancesDrawn));
}

Rows frameRows(const FrameHistory& frames, const renderer::FrameStats& stats)
{
    const double ms = frames.meanMs();
    Rows rows{{tr("statistics.frame"), trf("statistics.frame_text", ms > 0 ? 1000 / ms : 0, ms)}};
    addCulling(rows, stats);
    rows.emplace_back(tr("statistics.triangles"), grouped(stats.trianglesDrawn));
    if (std::string levels = levelsText(stats); !levels.empty()) { // as long as a line, so below its name
        rows.emplace_back(tr("statistics.levels"), "");
        rows.emplace_back("", std::move(levels));
    }
    rows.emplace_back(tr("statistics.grass"), grassText(stats, true));
    rows.emplace_back(tr("statistics.submitted"), grouped(stats.trianglesSubmitted));
    rows.emplace_back(tr("statistics.draws"), grouped(stats.drawCalls));
    rows.emplace_back(tr("statistics.uploaded"), byteText(stats.uploadedBytes));
    return rows;
}

Row pair(const char* key, std::uint64_t first, std::uint64_t second)
{
    return {tr(key), byteText(first) + ", " + byteText(second)};
}

Rows memoryRows(const renderer::FrameStats& stats, const WorldMemory& world)
{
    const renderer::GpuMemory& gpu = stats.gpuMemory;
    return {{tr("statistics.gpu_memory"), byteText(stats.gpuBytes)},
            pair("statistics.textures_buffers", gpu.textures, gpu.buffers),
            pair("statistics.shadow_maps_targets", gpu.shadowMaps, gpu.targets),
            pair("statistics.objects_geometry", world.objects, world.geometry),
            pair("statistics.pictures_heights", world.pictures, world.heights)};
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

// One column: draws from the top down, and knows how far it came.
class Column {
public:
    Column(ImDrawList& draw, ImVec2 top, float width) : m_draw{draw}, m_at{top}, m_width{width} {}

    void rows(const Rows& rows)
    {
        for (const Row& one : rows)
            row(m_draw, one, m_at, m_width), m_at.y += kLine;
    }
    void timelines(const FrameHistory& frames)
    {
        const float half = (m_width - kGap) / 2;
        float x = m_at.x;
        m_at.y += kGap;
        for (const Clock clock : {Clock::Cpu, Clock::Gpu}) {
            frameTimeline(m_draw, frames, clock, {x, m_at.y}, {x + half, m_at.y + kTimeline});
            x += half + kGap;
        }
        m_at.y += kTimeline + kGap;
    }
    void passes(const std::vector<renderer::PassTime>& passes)
    {
        if (passes.empty()) return;
        m_draw.AddText(m_at, palette::kFaintText, tr("statistics.pass"));
        rightText(m_draw, m_at.x + m_width - 70, m_at.y, palette::kFaintText, tr("statistics.cpu"));
        rightText(m_draw, m_at.x + m_width, m_at.y, palette::kFaintText, tr("statistics.gpu"));
        m_at.y += kLine;
        for (const renderer::PassTime& pass : passes)
            passRow(m_draw, pass, colourOfPass(passes, pass.name), m_at, m_width), m_at.y += kLine;
        m_at.y += kGap;
    }

private:
    ImDrawList& m_draw;
    ImVec2 m_at;
    float m_width;
};

} // namespace

std::string grassText(const renderer::FrameStats& stats, bool why)
{
    if (stats.grassLeftOut == 0) return grouped(stats.grassDrawn);
    return trf(why ? "statistics.grass_limited" : "statistics.of", grouped(stats.grassDrawn), grouped(stats.grassDrawn + stats.grassLeftOut));
}

void statisticsOverlay(const FrameHistory& frames, const renderer::FrameStats& stats, const WorldMemory& world, ImVec2 top,
                       ImVec2 room)
{
    const Rows figures = frameRows(frames, stats), memory = memoryRows(stats, world);
    const std::vector<renderer::PassTime> passes = frames.means();
    const float first = kLine * float(figures.size()) + kTimeline + 2 * kGap;
    const float second = kLine * float(memory.size() + passes.size() + 1) + kGap;
    const bool beside = first + second + 2 * kPadding > room.y && room.x >= 2 * kWidth; // where one below the other is too long
    const float width = std::min(beside ? 2 * kWidth : kWidth, room.x);
    if (width < 160) return;
    const float height = 2 * kPadding + (beside ? std::max(first, second) : first + second);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 max{top.x + width, top.y + std::min(height, room.y)};
    draw.PushClipRect(top, max, true);
    draw.AddRectFilled(top, max, kGround, 5);
    const float inner = (beside ? kWidth : width) - 2 * kPadding;
    Column left{draw, {top.x + kPadding, top.y + kPadding}, inner};
    left.rows(figures);
    left.timelines(frames);
    Column below = beside ? Column{draw, {top.x + kWidth + kPadding, top.y + kPadding}, inner} : left;
    below.passes(passes);
    below.rows(memory);
    draw.PopClipRect();
}

} // namespace editor
