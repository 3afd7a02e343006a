// What is visible in the window, rebuilt every frame: panel, label, kind, rectangle in pixels and value of each widget,
// so that a test, or a program that helps a person, finds what a person would click.
#pragma once

#include "io/base/value.h"

#include <imgui.h>
#include <string>
#include <string_view>

namespace editor {

// A panel's part of the map: everything registered while it lives belongs to that panel.
class MapPanel {
public:
    explicit MapPanel(std::string_view panel);
    ~MapPanel();
    MapPanel(const MapPanel&) = delete;
    MapPanel& operator=(const MapPanel&) = delete;

private:
    std::string m_outer;
};

void clearMap(); // at the start of a frame

// The widget just drawn (ImGui's last item), or a rectangle that we drew ourselves. What is clipped away is left out,
// what is partly clipped is registered by its visible part.
void mapItem(std::string_view kind, std::string_view label, io::Value value = {});
void mapRect(std::string_view kind, std::string_view label, ImVec2 min, ImVec2 max, io::Value value = {});

// [{"panel": "hierarchy", "label": …, "kind": "row", "rect": [x, y, width, height], "value": …}, …] of the last frame.
io::Value uiMap();

} // namespace editor
