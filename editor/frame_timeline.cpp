#include "editor/frame_timeline.h"

#include "editor/text.h"
#include "editor/theme.h"
#include "editor/ui_map.h"

#include <algorithm>
#include <fmt/format.h>

namespace editor {
namespace {

constexpr ImU32 kColours[] = {IM_COL32(141, 104, 245, 255), IM_COL32(78, 142, 240, 255),  IM_COL32(66, 190, 196, 255),
                              IM_COL32(120, 196, 88, 255),  IM_COL32(226, 208, 84, 255),  IM_COL32(240, 150, 74, 255),
                              IM_COL32(232, 86, 92, 255),   IM_COL32(222, 110, 190, 255), IM_COL32(150, 150, 160, 255)};
constexpr double kMargin = 1.25; // of the bar that all but a few stay under
constexpr double kMost = 0.95;   // of the bars

double timeOf(const renderer::PassTime& pass, Clock clock)
{
    return clock == Clock::Cpu ? pass.cpuMs : pass.gpuMs;
}

double sumOf(const FrameHistory::Frame& frame, Clock clock)
{
    double sum = 0;
    for (const renderer::PassTime& pass : frame.passes)
        sum += timeOf(pass, clock);
    return sum;
}

// One frame that took long (a world was opened) does not press the others flat.
double heightOf(const FrameHistory& frames, Clock clock)
{
    std::vector<double> sums{1};
    for (std::size_t i = 0; i < frames.size(); ++i)
        sums.push_back(sumOf(frames.at(i), clock));
    const auto most = sums.begin() + std::ptrdiff_t(kMost * double(sums.size() - 1));
    std::ranges::nth_element(sums, most);
    return *most * kMargin;
}

} // namespace

ImU32 colourOfPass(const std::vector<renderer::PassTime>& passes, std::string_view name)
{
    const auto found = std::ranges::find(passes, name, &renderer::PassTime::name);
    return kColours[std::size_t(found - passes.begin()) % std::size(kColours)];
}

void frameTimeline(ImDrawList& draw, const FrameHistory& frames, Clock clock, ImVec2 min, ImVec2 max)
{
    const double full = heightOf(frames, clock);
    const std::vector<renderer::PassTime> passes = frames.means();
    const float width = (max.x - min.x) / float(FrameHistory::kFrames), height = max.y - min.y;
    draw.AddRectFilled(min, max, withAlpha(palette::kField, 0.8f), 3);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const float x = max.x - width * float(frames.size() - i);
        float y = max.y;
        for (const renderer::PassTime& pass : frames.at(i).passes) {
            const float part = std::min(height * float(timeOf(pass, clock) / full), y - min.y);
            draw.AddRectFilled({x, y - part}, {x + std::max(1.f, width - 0.5f), y}, colourOfPass(passes, pass.name));
            y -= part;
        }
    }
    const char* name = tr(clock == Clock::Cpu ? "statistics.cpu" : "statistics.gpu");
    const std::string text = fmt::format("{}  {:.1f}", name, full);
    draw.AddText({min.x + 6, min.y + 3}, palette::kText, text.c_str());
    mapRect("timeline", name, min, max, io::Value{double(frames.size())});
}

} // namespace editor
