#include "editor/panels/falloff_curve.h"

#include "editor/text.h"
#include "editor/widgets.h"
#include "io/scene/falloff.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr float kHeight = 120, kMargin = 10, kReach = 9; // pixels

struct Graph {
    ImVec2 min, max; // of the field in which the curve lies

    ImVec2 at(float share, float level) const { return {min.x + share * (max.x - min.x), max.y - level * (max.y - min.y)}; }
    io::FalloffKey under(ImVec2 pixel) const
    {
        return {std::clamp((pixel.x - min.x) / (max.x - min.x), 0.0f, 1.0f), std::clamp((max.y - pixel.y) / (max.y - min.y), 0.0f, 1.0f)};
    }
};

int keyAt(const Graph& graph, const std::vector<io::FalloffKey>& keys, ImVec2 pixel)
{
    int best = -1;
    float nearest = kReach;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const ImVec2 at = graph.at(keys[i].at, keys[i].level);
        const float distance = std::hypot(at.x - pixel.x, at.y - pixel.y);
        if (distance < nearest) nearest = distance, best = int(i);
    }
    return best;
}

void drawGraph(const Graph& graph, const std::vector<io::FalloffKey>& keys, int hot)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({graph.min.x - kMargin, graph.min.y - kMargin}, {graph.max.x + kMargin, graph.max.y + kMargin}, palette::kField, 4);
    for (int i = 0; i <= 4; ++i) {
        const float share = float(i) / 4;
        draw.AddLine(graph.at(share, 0), graph.at(share, 1), palette::kSoftEdge);
        draw.AddLine(graph.at(0, share), graph.at(1, share), palette::kSoftEdge);
    }
    const int last = std::max(int(graph.max.x - graph.min.x) / 3, 2);
    for (int i = 0; i <= last; ++i) {
        const float share = float(i) / float(last);
        draw.PathLineTo(graph.at(share, io::falloffAt(keys, share)));
    }
    draw.PathStroke(keys.empty() ? palette::kSoftText : palette::kAccent, 0, 2);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const ImVec2 at = graph.at(keys[i].at, keys[i].level);
        draw.AddCircleFilled(at, int(i) == hot ? 6.f : 4.5f, int(i) == hot ? IM_COL32_WHITE : palette::kAccent);
        mapRect("falloff key", std::to_string(i + 1), {at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, double(keys[i].level));
    }
}

void scale(const Graph& graph, float radius)
{
    const std::string far = trf("falloff.metres", double(radius));
    ImGui::PushFont(smallFont());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText({graph.min.x - kMargin, graph.max.y + kMargin + 2}, palette::kFaintText, trf("falloff.metres", 0.0).c_str());
    draw.AddText({graph.max.x + kMargin - ImGui::CalcTextSize(far.c_str()).x, graph.max.y + kMargin + 2}, palette::kFaintText, far.c_str());
    ImGui::Dummy({0, ImGui::GetTextLineHeight() + 2});
    ImGui::PopFont();
}

} // namespace

bool falloffCurve(std::vector<io::FalloffKey>& keys, float radius)
{
    ImGui::PushID("falloff");
    ui::softText(tr("falloff.curve"));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 80.0f), kHeight};
    const Graph graph{{corner.x + kMargin, corner.y + kMargin}, {corner.x + size.x - kMargin, corner.y + size.y - kMargin}};
    ImGui::InvisibleButton("graph", size);
    mapItem("curve", tr("falloff.curve"));
    const bool hovered = ImGui::IsItemHovered();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID grabbed = ImGui::GetID("grabbed"); // the key in hand, and one more; 0: none
    int hot = hovered ? keyAt(graph, keys, mouse) : -1;
    bool changed = false;
    if (ImGui::IsItemActivated()) {
        if (hot < 0 && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            hot = int(io::addFalloffKey(keys, graph.under(mouse)));
            changed = true;
        }
        storage.SetInt(grabbed, hot + 1);
    }
    if (ImGui::IsItemActive() && storage.GetInt(grabbed) > 0) {
        hot = storage.GetInt(grabbed) - 1;
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
            io::moveFalloffKey(keys, std::size_t(hot), graph.under(mouse));
            changed = true;
        }
    } else if (hot >= 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        keys.erase(keys.begin() + hot);
        hot = -1;
        changed = true;
    }
    drawGraph(graph, keys, hot);
    if (hot >= 0 && hot < int(keys.size()))
        ui::tooltip(trf("falloff.key", double(keys[std::size_t(hot)].level) * 100, double(keys[std::size_t(hot)].at * radius)).c_str());
    else if (hovered) ui::tooltip(tr("falloff.tip"));
    scale(graph, radius);
    if (!keys.empty() && ui::button("usual", tr("falloff.usual"))) {
        keys.clear();
        changed = true;
    }
    ImGui::PopID();
    return changed;
}

} // namespace editor
