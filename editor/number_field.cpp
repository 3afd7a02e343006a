// Fields for numbers and colours: see widgets.h.
#include "editor/numbers_text.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui_internal.h>

namespace editor::ui {
namespace {

void axisEdge(int axis, ImVec2 min, ImVec2 max)
{
    if (axis < 0) return;
    constexpr ImU32 kColours[] = {palette::kRed, palette::kGreen, palette::kBlue};
    ImGui::GetWindowDrawList()->AddRectFilled(min, {min.x + 3, max.y}, kColours[axis % 3], 2,
                                              ImDrawFlags_RoundCornersLeft);
}

bool bounded(const NumberField& field)
{
    return field.max - field.min <= kOpenRange;
}

void fieldBar(const NumberField& field, double value, ImVec2 min, ImVec2 max)
{
    if (!bounded(field) || field.mixed || field.max <= field.min) return;
    double share = (value - field.min) / (field.max - field.min);
    if (field.logarithmic && field.min >= 0 && value > 0) {
        const double low = std::max(field.min, field.max * 1e-5);
        share = std::log(std::max(value, low) / low) / std::log(field.max / low);
    }
    share = std::clamp(share, 0.0, 1.0);
    const float end = min.x + (max.x - min.x) * float(share);
    if (end - min.x >= 2)
        ImGui::GetWindowDrawList()->AddRectFilled(min, {end, max.y}, IM_COL32(141, 104, 245, 70), 3,
                                                  share > 0.98 ? ImDrawFlags_RoundCornersAll
                                                               : ImDrawFlags_RoundCornersLeft);
}

double dragSpeed(const NumberField& field, float width)
{
    if (field.speed > 0) return field.speed;
    return bounded(field) ? (field.max - field.min) / std::max(width, 60.f) : 0.05;
}

std::string digits(const NumberField& field, double value)
{
    if (field.mixed) return "—";
    if (!field.shown.empty()) return field.shown;
    return numberShown(value, field.decimals, field.logarithmic);
}

void fieldText(const NumberField& field, double value, ImVec2 min, ImVec2 max)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const std::string text = digits(field, value);
    const std::string unit =
        field.unit.empty() || field.mixed || !field.shown.empty() ? std::string{} : " " + std::string{field.unit};
    const float textWidth = ImGui::CalcTextSize(text.c_str()).x, unitWidth = ImGui::CalcTextSize(unit.c_str()).x;
    const bool unitFits = textWidth + unitWidth < max.x - min.x - 6;
    const float x = std::max(min.x + 4, (min.x + max.x - textWidth - (unitFits ? unitWidth : 0)) / 2);
    const float y = min.y + ImGui::GetStyle().FramePadding.y;
    const float alpha = ImGui::GetStyle().Alpha;
    draw.PushClipRect(min, max, true);
    draw.AddText({std::floor(x), y}, withAlpha(palette::kText, alpha), text.c_str());
    if (unitFits) draw.AddText({std::floor(x + textWidth), y}, withAlpha(palette::kSoftText, alpha), unit.c_str());
    draw.PopClipRect();
}

float encoded(float linear) // towards sRGB, past 1 too
{
    return linear <= 0 ? 0 : linear < 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float decoded(float colour)
{
    return colour <= 0.04045f ? colour / 12.92f : std::pow((colour + 0.055f) / 1.055f, 2.4f);
}

// Those that are shown are typed over. While it is dragged, enough for a pixel to be a step, with Alt too, which is a hundred times finer.
int dragDecimals(const NumberField& field, double value, double speed)
{
    const std::string shown = numberShown(value, field.decimals, field.logarithmic);
    const std::size_t point = shown.find('.');
    const int typed = point == std::string::npos ? 0 : int(shown.size() - point) - 1;
    const bool whole = field.decimals == 0 && !field.logarithmic;
    if (whole || !ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1) || speed <= 0) return typed;
    const double step = ImGui::GetIO().KeyAlt ? speed / 100 : speed;
    return std::clamp(int(std::ceil(-std::log10(step))), typed, 9);
}

bool dragIn(const NumberField& field, float width, double& value)
{
    const double speed = dragSpeed(field, width);
    const std::string format = "%." + std::to_string(dragDecimals(field, value, speed)) + "f";
    double edited = value;
    ImGui::PushStyleColor(ImGuiCol_Text, 0); // the digits are drawn with their unit
    ImGui::SetNextItemWidth(width);
    const bool changed = ImGui::DragScalar(field.id, ImGuiDataType_Double, &edited, float(speed), &field.min, &field.max, format.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (!changed || !std::isfinite(edited)) return false;
    value = std::clamp(edited, field.min, field.max);
    return true;
}

// The text that DragScalar opened, from its second frame on: ours, for ImGui's own takes no "+=" and reads numbers as
// the locale has them.
bool typeInto(const NumberField& field, const ImRect& box, double& value, TypedNumber* typed)
{
    static char text[64]; // one text at a time has the keyboard
    if (!ImGui::ItemAdd(box, ImGui::GetID(field.id), nullptr, ImGuiItemFlags_Inputable)) return false;
    ImGui::TempInputText(box, ImGui::GetID(field.id), field.id, text, sizeof text, ImGuiInputTextFlags_AutoSelectAll);
    if (!ImGui::IsItemDeactivatedAfterEdit() || ImGui::IsKeyPressedMap(ImGuiKey_Escape)) return false;
    const auto number = typedNumber(text);
    if (!number) return false;
    if (typed) *typed = *number;
    value = std::clamp(number->of(value), field.min, field.max);
    return true;
}

} // namespace

bool number(const NumberField& field, double& value, TypedNumber* typed)
{
    const float width = field.width > 0 ? field.width : ImGui::GetContentRegionAvail().x;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max{min.x + width, min.y + ImGui::GetFrameHeight()};
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID(field.id));
    const bool hovered = ImGui::IsMouseHoveringRect(min, max) && ImGui::IsWindowHovered();
    ImGui::GetWindowDrawList()->AddRectFilled(
        min, max, withAlpha(hovered ? palette::kFieldHover : palette::kField, ImGui::GetStyle().Alpha), 3);
    if (!typing) fieldBar(field, value, min, max);
    for (const ImGuiCol slot : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
        ImGui::PushStyleColor(slot, 0);
    const bool changed = typing ? typeInto(field, {min, max}, value, typed) : dragIn(field, width, value);
    ImGui::PopStyleColor(3);
    mapItem("number", field.label, value);
    if (!ImGui::TempInputIsActive(ImGui::GetItemID())) fieldText(field, value, min, max);
    axisEdge(field.axis, min, max);
    return changed;
}

bool colourField(const char* id, std::string_view label, float* linearRgb, float max, bool mixed, float width)
{
    float shown[3] = {encoded(linearRgb[0]), encoded(linearRgb[1]), encoded(linearRgb[2])};
    const ImVec4 swatch{shown[0], shown[1], shown[2], 1};
    ImGui::PushID(id);
    if (ImGui::ColorButton("swatch", swatch,
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoDragDrop,
                           {width > 0 ? width : ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()}))
        ImGui::OpenPopup("picker");
    if (mixed) {
        const ImVec2 at = ImGui::GetItemRectMin();
        ImGui::GetWindowDrawList()->AddText({at.x + 8, at.y + 4}, palette::kText, tr("common.mixed"));
    }
    mapItem("colour", label, io::Value::Array{linearRgb[0], linearRgb[1], linearRgb[2]});
    bool changed = false;
    if (ImGui::BeginPopup("picker")) {
        const MapPanel popup{"popup"};
        ImGui::SetNextItemWidth(240);
        changed = ImGui::ColorPicker3("##picker", shown,
                                      ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR |
                                          ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayRGB |
                                          ImGuiColorEditFlags_DisplayHSV);
        mapItem("colour picker", label);
        ImGui::EndPopup();
    }
    ImGui::PopID();
    if (changed)
        for (int i = 0; i < 3; ++i)
            linearRgb[i] = std::clamp(decoded(shown[i]), 0.f, max);
    return changed;
}

} // namespace editor::ui
