#include "editor/panels/sun_dial.h"

#include "editor/text.h"
#include "editor/theme.h"
#include "editor/ui_map.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <numbers>

namespace editor {
namespace {

constexpr float kRadius = 72; // pixels
constexpr double kDegrees = 180 / std::numbers::pi;

struct Dial {
    ImVec2 middle;

    ImVec2 place(const glm::dvec3& toward) const // by elevation: 90 degrees in the middle, 0 at the rim
    {
        const double elevation = std::asin(std::clamp(toward.y, -1.0, 1.0)) * kDegrees;
        const double r = std::min(1.0, (90 - elevation) / 90) * kRadius;
        const double azimuth = std::atan2(toward.x, -toward.z);
        return {middle.x + float(std::sin(azimuth) * r), middle.y - float(std::cos(azimuth) * r)};
    }
};

void face(ImDrawList& draw, const Dial& dial)
{
    draw.AddCircleFilled(dial.middle, kRadius, IM_COL32(29, 33, 46, 255), 64);
    for (const float share : {1 / 3.f, 2 / 3.f})
        draw.AddCircle(dial.middle, kRadius * share, IM_COL32(255, 255, 255, 22), 48);
    draw.AddCircle(dial.middle, kRadius, palette::kSoftEdge, 64, 1.5f);
    constexpr const char* kPoints[] = {"compass.north", "compass.east", "compass.south", "compass.west"};
    for (int i = 0; i < 4; ++i) {
        const float a = float(i) * std::numbers::pi_v<float> / 2;
        const char* text = tr(kPoints[i]);
        const ImVec2 size = ImGui::CalcTextSize(text);
        draw.AddText({dial.middle.x + std::sin(a) * (kRadius + 12) - size.x / 2,
                      dial.middle.y - std::cos(a) * (kRadius + 12) - size.y / 2},
                     palette::kFaintText, text);
    }
}

void dayPath(ImDrawList& draw, const Dial& dial, io::Environment environment)
{
    environment.sun.mode = io::SunMode::Time;
    for (int i = 0; i <= 96; ++i) {
        environment.time = float(i) / 4;
        const glm::dvec3 toward = io::towardSun(environment);
        if (toward.y < 0) {
            draw.PathStroke(IM_COL32(255, 205, 110, 110), 0, 1.5f);
            continue;
        }
        draw.PathLineTo(dial.place(toward));
    }
    draw.PathStroke(IM_COL32(255, 205, 110, 110), 0, 1.5f);
}

void sunAt(ImDrawList& draw, ImVec2 at, bool up, bool hot)
{
    const ImU32 colour = up ? IM_COL32(255, 214, 110, 255) : IM_COL32(130, 120, 110, 255);
    if (up) draw.AddCircleFilled(at, 13, withAlpha(colour, 0.18f));
    draw.AddCircleFilled(at, hot ? 8.f : 7.f, colour);
    if (hot) draw.AddCircle(at, 11, IM_COL32_WHITE, 0, 1.5f);
}

} // namespace

bool sunDial(io::Environment& environment)
{
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const Dial dial{{min.x + std::floor(width / 2), min.y + kRadius + 24}};
    ImGui::SetCursorScreenPos({dial.middle.x - kRadius, dial.middle.y - kRadius});
    ImGui::InvisibleButton("##sun", {2 * kRadius, 2 * kRadius});
    mapItem("dial", tr("compass.dial"));
    const bool dragged = ImGui::IsItemActive() && (ImGui::IsItemActivated() || ImGui::IsMouseDragging(0, 0));
    if (dragged) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const double x = mouse.x - dial.middle.x, y = dial.middle.y - mouse.y;
        environment.sun.mode = io::SunMode::Manual;
        double azimuth = std::atan2(x, y) * kDegrees;
        if (azimuth < 0) azimuth += 360;
        environment.sun.azimuth = float(std::round(azimuth * 10) / 10);
        environment.sun.elevation =
            float(std::round(std::clamp(90 - std::hypot(x, y) / kRadius * 90, 0.0, 90.0) * 10) / 10);
    }
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const glm::dvec3 toward = io::towardSun(environment);
    face(draw, dial);
    dayPath(draw, dial, environment);
    sunAt(draw, dial.place(toward), toward.y > 0, ImGui::IsItemHovered() || ImGui::IsItemActive());
    ImGui::SetCursorScreenPos({min.x, dial.middle.y + kRadius + 26});
    return dragged;
}

} // namespace editor
