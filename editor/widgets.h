// The widgets of the window: ImGui's with our look, each putting itself into the ui map. Texts arrive translated; the
// ImGui id is the `id` given, so that a change of language never moves the focus.
#pragma once

#include "editor/icons.h"
#include "editor/theme.h"
#include "editor/typed_number.h"
#include "editor/ui_map.h"

#include <imgui.h>
#include <span>
#include <string>
#include <string_view>

namespace editor::ui {

constexpr float kToolSize = 30; // pixels, side of a toolbar button

enum class Emphasis { Normal, Accent, Quiet };

bool button(const char* id, const char* text, Emphasis emphasis = Emphasis::Normal, ImVec2 size = {0, 0});
struct IconButton {
    const char* id;
    Icon icon = Icon::None;
    std::string label; // of the ui map, and of the tooltip when that has no text of its own
    std::string tooltip = {};
    bool on = false; // a switch that is on
    bool enabled = true;
    float size = kToolSize;
    ImU32 colour = 0; // of the icon; 0: the text's
};
bool iconButton(const IconButton& what);
bool checkbox(const char* id, const char* text, bool& value,
              std::string_view label = {});                                           // of the ui map, if not the text
bool toggleChip(const char* id, const char* text, Icon icon, ImU32 colour, bool& on); // a filter's switch
bool textField(const char* id, const char* hint, std::string& text, ImGuiInputTextFlags flags = 0);
bool searchField(const char* id, const char* hint, std::string& text);
bool combo(const char* id, std::string_view label, std::span<const std::string> items, int& chosen, bool mixed = false);

// A number in a field with a bar that shows where it lies between its bounds. Drag, or click and type.
struct NumberField {
    const char* id;         // "##azimuth"
    std::string_view label; // of the ui map
    double min, max;        // unbounded where max - min is over kOpenRange
    double speed = 0;       // per pixel; 0: from the bounds
    int decimals = 2;
    std::string_view unit = {};
    bool logarithmic = false;
    bool mixed = false;     // shows a dash until it is changed
    int axis = -1;          // 0, 1, 2: a red, green or blue edge
    float width = 0;        // pixels; 0: the rest of the line
    std::string shown = {}; // in place of the digits, as "10:30"
};
constexpr double kOpenRange = 20000;
bool number(const NumberField& field, double& value, TypedNumber* typed = nullptr); // `typed`: how, if it was

bool colourField(const char* id, std::string_view label, float* linearRgb, float max, bool mixed = false,
                 float width = 0);

bool menuItem(const char* text, const char* shortcut = nullptr, bool checked = false, bool enabled = true,
              Icon icon = Icon::None);
bool beginMenu(const char* text, bool enabled = true); // ImGui::EndMenu() when true

// A header across the panel; answers whether it is open.
bool section(const char* id, const char* text, bool openAtFirst = true);
// A row of two columns: the label here, the value's widget next, as wide as the rest. `tip` says what is cut off.
void propertyLabel(std::string_view label, std::string_view unit = {}, bool strong = false);

void tooltip(const char* text); // of the item just drawn
void heading(const char* text);
void progressBar(float fraction, float width);
void softText(std::string_view text);
void emptyState(Icon icon, const char* title, const char* text); // in the middle of a panel that has nothing to show
void iconText(Icon icon, ImU32 colour, std::string_view text);
std::string fitted(std::string_view text, float width); // cut at the end with "…" where it does not fit

} // namespace editor::ui
