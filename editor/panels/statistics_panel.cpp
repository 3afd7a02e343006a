#include "editor/panels/statistics_panel.h"

#include "editor/editor.h"
#include "editor/numbers_text.h"
#include "editor/statistics_overlay.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr float kWidth = 112, kHeight = 50; // pixels, of a figure

void figure(const char* key, const std::string& value)
{
    const ImVec2 min = ImGui::GetCursorScreenPos();
    ImGui::Dummy({kWidth, kHeight});
    mapItem("figure", tr(key), value);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(min, {min.x + kWidth, min.y + kHeight}, palette::kRaised, 4);
    draw.AddText(figureFont(), sizeOf(figureFont()), {min.x + 10, min.y + 7}, palette::kText, value.c_str());
    ImGui::PushFont(smallFont());
    draw.AddText({min.x + 10, min.y + 29}, palette::kSoftText, ui::fitted(tr(key), kWidth - 12).c_str());
    ImGui::PopFont();
}

void nextFigure() // on the same line where it fits
{
    if (ImGui::GetItemRectMax().x + 8 + kWidth < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
        ImGui::SameLine(0, 8);
}

void timeCell(double ms, double longest, ImU32 colour)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float share = longest > 0 ? float(std::min(1.0, ms / longest)) : 0;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x + 58, at.y + 4},
                                              {at.x + 58 + std::max(0.f, width - 62) * share, at.y + 14}, colour, 2);
    ImGui::TextUnformatted(fmt::format("{:.2f}", ms).c_str());
}

} // namespace

void StatisticsPanel::draw(Editor& editor)
{
    const float room = ImGui::GetContentRegionAvail().x;
    const bool beside = room > 640; // the passes stand beside the figures where there is room
    if (beside) ImGui::BeginChild("##figures", {std::floor(room * 0.55f), 0});
    figures(editor);
    if (beside) {
        ImGui::EndChild();
        ImGui::SameLine(0, 16);
        ImGui::BeginChild("##passes", {0, 0});
    }
    if (editor.renderer()) passes(editor);
    if (beside) ImGui::EndChild();
}

void StatisticsPanel::figures(Editor& editor)
{
    graph(editor.viewport().frames);
    if (editor.renderer()) {
        const renderer::FrameStats& stats = editor.renderer()->stats();
        const std::pair<const char*, std::string> all[] = {
            {"statistics.draws", grouped(stats.drawCalls)},
            {"statistics.triangles", grouped(stats.trianglesDrawn)},
            {"statistics.submitted", grouped(stats.trianglesSubmitted)},
            {"statistics.instances", grouped(stats.instances)},
            {"statistics.inside", grouped(stats.instancesInside)},
            {"statistics.large", grouped(stats.instancesLarge)},
            {"statistics.hidden", stats.occlusionTested ? grouped(stats.instancesHidden) : tr("statistics.not_tested")},
            {"statistics.instances_drawn", grouped(stats.instancesDrawn)},
            {"statistics.grass", grassText(stats, false)},
            {"statistics.uploaded", byteText(stats.uploadedBytes)},
            {"statistics.gpu_memory", byteText(stats.gpuBytes)}};
        for (const auto& [key, value] : all)
            nextFigure(), figure(key, value);
    }
    if (!editor.document()) return;
    nextFigure();
    figure("statistics.undo_memory", byteText(editor.document()->history().bytes()));
}

// The times of the last frames as bars, as wide as two figures, with their mean over them.
void StatisticsPanel::graph(const FrameHistory& frames) const
{
    constexpr float kWide = 2 * kWidth + 8;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    ImGui::Dummy({kWide, kHeight});
    const double mean = frames.meanMs();
    const std::string text = trf("statistics.frame_text", mean > 0 ? 1000 / mean : 0, mean);
    mapItem("figure", tr("statistics.frame"), text);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(min, {min.x + kWide, min.y + kHeight}, palette::kRaised, 4);
    double highest = 20; // ms
    for (std::size_t i = 0; i < frames.size(); ++i)
        highest = std::max(highest, frames.at(i).ms * 1.1);
    const auto count = float(FrameHistory::kFrames);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const double ms = frames.at(i).ms;
        const float x = min.x + kWide * float(i) / count;
        draw.AddRectFilled({x, min.y + kHeight * float(1 - ms / highest)}, {x + kWide / count - 0.6f, min.y + kHeight},
                           withAlpha(ms > 33.4 ? palette::kAmber : palette::kAccent, 0.45f));
    }
    draw.AddText(figureFont(), sizeOf(figureFont()), {min.x + 10, min.y + 7}, palette::kText, text.c_str());
}

void StatisticsPanel::passes(Editor& editor) const
{
    const std::vector<renderer::PassTime>& passes = editor.renderer()->stats().passes;
    for (const renderer::ShaderFault& fault : editor.renderer()->shaderFaults())
        ui::iconText(Icon::Error, palette::kRed, fault.where + ": " + fault.what);
    if (passes.empty() || !ImGui::BeginTable("##passes", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
        return;
    double longest = 0;
    for (const renderer::PassTime& pass : passes)
        longest = std::max({longest, pass.cpuMs, pass.gpuMs});
    ImGui::TableSetupColumn(tr("statistics.pass"), 0, 1.2f);
    ImGui::TableSetupColumn(tr("statistics.cpu"), 0, 1);
    ImGui::TableSetupColumn(tr("statistics.gpu"), 0, 1);
    ImGui::TableHeadersRow();
    for (const renderer::PassTime& pass : passes) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(pass.name.c_str());
        mapItem("pass", pass.name, io::Value::Array{pass.cpuMs, pass.gpuMs});
        ImGui::TableNextColumn();
        timeCell(pass.cpuMs, longest, withAlpha(palette::kBlue, 0.7f));
        ImGui::TableNextColumn();
        timeCell(pass.gpuMs, longest, withAlpha(palette::kAccent, 0.7f));
    }
    ImGui::EndTable();
}

} // namespace editor
