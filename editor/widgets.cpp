#include "editor/widgets.h"

#include "editor/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

namespace editor::ui {
namespace {

struct ButtonLook {
    ImU32 rest, hover, held, text;
};

ButtonLook look(Emphasis emphasis)
{
    using namespace palette;
    switch (emphasis) {
    case Emphasis::Accent:
        return {kAccentDeep, IM_COL32(116, 84, 208, 255), kAccent, IM_COL32_WHITE};
    case Emphasis::Quiet:
        return {0, kHover, kPressed, kText};
    case Emphasis::Normal:
        break;
    }
    return {kRaised, kHover, kPressed, kText};
}

void iconFace(const IconButton& what, ImVec2 min, ImVec2 max, bool hovered, bool held)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 back = what.on ? palette::kAccentDeep : held ? palette::kPressed : hovered ? palette::kHover : 0;
    if (back) draw.AddRectFilled(min, max, back, 4);
    const float side = std::round(what.size * 0.58f);
    const ImU32 colour = what.on ? IM_COL32_WHITE : what.colour ? what.colour : palette::kText;
    drawIcon(draw, what.icon, {(min.x + max.x - side) / 2, (min.y + max.y - side) / 2}, side,
             what.enabled ? colour : withAlpha(colour, 0.35f));
}

} // namespace

bool button(const char* id, const char* text, Emphasis emphasis, ImVec2 size)
{
    const ButtonLook colours = look(emphasis);
    ImGui::PushStyleColor(ImGuiCol_Button, colours.rest);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colours.hover);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, colours.held);
    ImGui::PushStyleColor(ImGuiCol_Text, colours.text);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{14, 6});
    const bool clicked = ImGui::Button((std::string{text} + "###" + id).c_str(), size);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(4);
    mapItem("button", text);
    return clicked;
}

bool iconButton(const IconButton& what)
{
    const ImVec2 min = ImGui::GetCursorScreenPos();
    if (!what.enabled) ImGui::BeginDisabled();
    const bool clicked = ImGui::InvisibleButton(what.id, {what.size, what.size});
    if (!what.enabled) ImGui::EndDisabled();
    iconFace(what, min, {min.x + what.size, min.y + what.size}, ImGui::IsItemHovered(), ImGui::IsItemActive());
    mapItem(what.enabled ? "button" : "disabled button", what.label, what.on);
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        tooltip((what.tooltip.empty() ? what.label : what.tooltip).c_str());
    return clicked && what.enabled;
}

bool checkbox(const char* id, const char* text, bool& value, std::string_view label)
{
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFrameHeight() - 8;
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float width = side + (size.x > 0 ? size.x + 8 : 0);
    const bool clicked = ImGui::InvisibleButton(id, {width, ImGui::GetFrameHeight()});
    if (clicked) value = !value;
    const ImVec2 a{min.x, min.y + 4}, b{min.x + side, min.y + 4 + side};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float alpha = ImGui::GetStyle().Alpha;
    const ImU32 off = ImGui::IsItemHovered() ? palette::kHover : palette::kField;
    draw.AddRectFilled(a, b, withAlpha(value ? palette::kAccentDeep : off, alpha), 3);
    if (!value) draw.AddRect(a, b, withAlpha(palette::kSoftEdge, alpha), 3);
    if (value) drawIcon(draw, Icon::Check, {a.x + 2, a.y + 2}, side - 4, withAlpha(IM_COL32_WHITE, alpha));
    draw.AddText({b.x + 8, min.y + (ImGui::GetFrameHeight() - size.y) / 2}, withAlpha(palette::kText, alpha), text);
    mapItem("checkbox", label.empty() ? text : label, value);
    return clicked;
}

bool toggleChip(const char* id, const char* text, Icon icon, ImU32 colour, bool& on)
{
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 label = ImGui::CalcTextSize(text);
    const ImVec2 size{label.x + 38, ImGui::GetFrameHeight()};
    if (ImGui::InvisibleButton(id, size)) on = !on;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 max{min.x + size.x, min.y + size.y};
    draw.AddRectFilled(min, max,
                       on                       ? palette::kRaised
                       : ImGui::IsItemHovered() ? palette::kHover
                                                : palette::kField,
                       size.y / 2);
    drawIcon(draw, icon, {min.x + 10, min.y + (size.y - 13) / 2}, 13, on ? colour : palette::kFaintText);
    draw.AddText({min.x + 28, min.y + (size.y - label.y) / 2}, on ? palette::kText : palette::kFaintText, text);
    mapItem("toggle", text, on);
    return ImGui::IsItemDeactivated() && ImGui::IsItemHovered();
}

bool textField(const char* id, const char* hint, std::string& text, ImGuiInputTextFlags flags)
{
    const bool changed = ImGui::InputTextWithHint(id, hint, &text, flags);
    mapItem("text", hint, text);
    return changed;
}

bool searchField(const char* id, const char* hint, std::string& text)
{
    const ImVec2 min = ImGui::GetCursorScreenPos();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{28, 5});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, 5);
    const bool changed = textField(id, hint, text);
    ImGui::PopStyleVar(2);
    const float height = ImGui::GetItemRectSize().y;
    drawIcon(*ImGui::GetWindowDrawList(), Icon::Search, {min.x + 8, min.y + (height - 14) / 2}, 14, palette::kSoftText);
    if (text.empty()) return changed;
    const ImVec2 after = ImGui::GetCursorScreenPos();
    ImGui::PushID(id);
    ImGui::SetItemAllowOverlap();
    ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x - 24, min.y + (height - 20) / 2});
    const bool cleared =
        iconButton({.id = "clear", .icon = Icon::Close, .label = tr("common.clear_search"), .size = 20});
    ImGui::PopID();
    ImGui::SetCursorScreenPos(after);
    if (cleared) text.clear();
    return changed || cleared;
}

bool combo(const char* id, std::string_view label, std::span<const std::string> items, int& chosen, bool mixed)
{
    const char* shown =
        mixed || chosen < 0 || chosen >= int(items.size()) ? tr("common.mixed") : items[std::size_t(chosen)].c_str();
    bool changed = false;
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kField);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{6, 6});
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth(), height = ImGui::GetFrameHeight();
    const bool open = ImGui::BeginCombo(id, shown, ImGuiComboFlags_HeightLarge | ImGuiComboFlags_NoArrowButton);
    if (!open) mapItem("combo", label, shown);
    if (open) {
        const MapPanel popup{"popup"};
        for (int i = 0; i < int(items.size()); ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(items[std::size_t(i)].c_str(), i == chosen && !mixed)) changed = true, chosen = i;
            mapItem("option", items[std::size_t(i)], i == chosen);
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    drawIcon(*ImGui::GetWindowDrawList(), Icon::ChevronDown, {min.x + width - 20, min.y + (height - 12) / 2}, 12,
             withAlpha(palette::kSoftText, ImGui::GetStyle().Alpha));
    return changed;
}

bool menuItem(const char* text, const char* shortcut, bool checked, bool enabled, Icon icon)
{
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const std::string padded = std::string{"        "} + text; // room for the icon or the tick
    const bool clicked = ImGui::MenuItem(padded.c_str(), shortcut, false, enabled);
    const ImU32 colour = enabled ? palette::kSoftText : palette::kFaintText;
    const float top = min.y + (ImGui::GetItemRectSize().y - 14) / 2 - ImGui::GetStyle().ItemSpacing.y / 2;
    if (checked)
        drawIcon(*ImGui::GetWindowDrawList(), Icon::Check, {min.x + 2, top}, 14, palette::kAccent);
    else if (icon != Icon::None)
        drawIcon(*ImGui::GetWindowDrawList(), icon, {min.x + 2, top}, 14, colour);
    mapItem(enabled ? "menu item" : "disabled menu item", text, checked);
    return clicked;
}

bool beginMenu(const char* text, bool enabled)
{
    const bool inBar = ImGui::GetCurrentWindow()->DC.LayoutType == ImGuiLayoutType_Horizontal;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const std::string padded = inBar ? std::string{text} : std::string{"        "} + text;
    const float width = ImGui::CalcTextSize(text).x + 12;
    const bool open = ImGui::BeginMenu(padded.c_str(), enabled);
    if (inBar)
        mapRect("menu", text, min, {min.x + width, min.y + ImGui::GetFrameHeight()}, open);
    else if (!open)
        mapItem("menu", text, open);
    return open;
}

bool section(const char* id, const char* text, bool openAtFirst)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID(id);
    bool open = storage.GetBool(key, openAtFirst);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 28};
    if (ImGui::InvisibleButton(id, size)) storage.SetBool(key, open = !open);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(min, {min.x + size.x, min.y + size.y},
                       ImGui::IsItemHovered() ? palette::kHover : palette::kRaised, 3);
    drawIcon(draw, open ? Icon::ChevronDown : Icon::ChevronRight, {min.x + 8, min.y + 8}, 12, palette::kSoftText);
    ImGui::PushFont(boldFont());
    draw.AddText({min.x + 28, min.y + (size.y - ImGui::GetFontSize()) / 2}, palette::kText, text);
    ImGui::PopFont();
    mapItem("section", text, open);
    return open;
}

void propertyLabel(std::string_view label, std::string_view unit, bool strong)
{
    const float full = ImGui::GetContentRegionAvail().x;
    const float column = std::clamp(full * 0.38f, 80.f, 190.f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float startX = ImGui::GetCursorPosX();
    const std::string suffix = unit.empty() ? std::string{} : " " + std::string{unit};
    const float unitWidth = suffix.empty() ? 0 : ImGui::CalcTextSize(suffix.c_str()).x;
    const std::string shown = fitted(label, column - 10 - unitWidth);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, strong ? palette::kText : IM_COL32(188, 188, 196, 255));
    ImGui::TextUnformatted(shown.data(), shown.data() + shown.size());
    ImGui::PopStyleColor();
    if (shown.size() < label.size() && ImGui::IsItemHovered()) tooltip(std::string{label}.c_str());
    if (!suffix.empty())
        ImGui::GetWindowDrawList()->AddText(
            {at.x + ImGui::CalcTextSize(shown.c_str()).x, at.y + ImGui::GetStyle().FramePadding.y},
            withAlpha(palette::kFaintText, ImGui::GetStyle().Alpha), suffix.c_str());
    ImGui::SameLine(startX + column);
    ImGui::SetNextItemWidth(-FLT_MIN);
}

void tooltip(const char* text)
{
    constexpr float kDelay = 0.35f; // s that the pointer rests on the item
    if (ImGui::GetCurrentContext()->HoveredId != 0 && ImGui::GetCurrentContext()->HoveredIdTimer < kDelay) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 4);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{10, 7});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(380);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar(2);
}

void heading(const char* text)
{
    ImGui::PushFont(boldFont());
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

void progressBar(float fraction, float width)
{
    const float share = std::clamp(fraction, 0.f, 1.f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({at.x, at.y + 4}, {at.x + width, at.y + 10}, palette::kField, 3);
    if (share > 0.01f) draw.AddRectFilled({at.x, at.y + 4}, {at.x + width * share, at.y + 10}, palette::kAccent, 3);
    ImGui::Dummy({width, 16});
}

void softText(std::string_view text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kSoftText);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void emptyState(Icon icon, const char* title, const char* text)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float wrap = std::min(room.x - 24, 300.f);
    if (wrap < 40) return;
    const ImVec2 body = ImGui::CalcTextSize(text, nullptr, false, wrap);
    const float height = 44 + 24 + body.y;
    float y = start.y + std::max(8.f, (room.y - height) * 0.42f);
    const float middle = start.x + room.x / 2;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    drawIcon(draw, icon, {middle - 15, y}, 30, palette::kFaintText);
    y += 42;
    ImGui::PushFont(boldFont());
    const ImVec2 size = ImGui::CalcTextSize(title);
    draw.AddText({middle - size.x / 2, y}, palette::kSoftText, title);
    ImGui::PopFont();
    draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {middle - body.x / 2, y + 24}, palette::kFaintText, text,
                 nullptr, wrap);
}

void iconText(Icon icon, ImU32 colour, std::string_view text)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    drawIcon(*ImGui::GetWindowDrawList(), icon, {at.x, at.y + (ImGui::GetTextLineHeight() - 14) / 2}, 14, colour);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 22);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

std::string fitted(std::string_view text, float width)
{
    const auto fits = [width](std::string_view part) {
        return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x <= width;
    };
    if (fits(text)) return std::string{text};
    std::size_t low = 0, high = text.size();
    const float dots = ImGui::CalcTextSize("…").x;
    while (low + 1 < high) { // the longest start that leaves room for the dots
        const std::size_t middle = (low + high) / 2;
        if (ImGui::CalcTextSize(text.data(), text.data() + middle).x + dots <= width)
            low = middle;
        else
            high = middle;
    }
    while (low > 0 && (text[low] & 0xc0) == 0x80)
        --low; // never within a letter
    return std::string{text.substr(0, low)} + "…";
}

} // namespace editor::ui
