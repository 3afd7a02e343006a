// Workspace: the panels in their regions (left, right, bottom, centre), with tabs that can be dragged to another region
// and splitters between them. The regions are plain ImGui windows that never move by themselves.
#pragma once

#include "editor/layout.h"
#include "editor/panel.h"

#include <imgui.h>
#include <optional>
#include <vector>

namespace editor {

class Workspace {
public:
    void add(Panel& panel, Region home, bool shown = true); // before the first draw
    void setHomeSize(Region region, float pixels);

    void draw(Editor& editor, ImVec2 min, ImVec2 max);

    const std::vector<Panel*>& panels() const { return m_panels; }
    bool shows(std::string_view panel) const { return m_layout.shows(panel); }
    bool inFront(std::string_view panel) const;
    void toggle(std::string_view panel); // hides it, or brings it back to where it is at home
    void bringToFront(std::string_view panel);

    const Layout& layout() const { return m_layout; }
    void restore(const io::Value& saved) { m_layout = layoutFrom(saved, m_home); }
    void reset() { m_layout = m_home; }

private:
    struct Rect {
        ImVec2 min, max;
        bool contains(ImVec2 p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
    };
    std::array<Rect, 4> arranged(ImVec2 min, ImVec2 max) const;
    void splitters(const std::array<Rect, 4>& rects, ImVec2 min, ImVec2 max);
    void splitter(Region region, const Rect& grip, float room);
    void drawRegion(Editor& editor, Region region, const Rect& rect);
    void tabStrip(Region region, const Rect& rect);
    void tab(Region region, const Panel& panel, float& x, float top, bool narrow);
    void drawPanel(Editor& editor, Panel& panel, Region region);
    void dropZones(const std::array<Rect, 4>& rects, ImVec2 min, ImVec2 max);
    void dropTab(Region region);
    Panel* find(std::string_view id) const;
    Region homeOf(std::string_view panel) const;

    std::vector<Panel*> m_panels;
    Layout m_home, m_layout;
    std::string m_dragged;                              // id of the panel whose tab is being dragged
    std::vector<std::pair<Region, float>> m_tabMiddles; // of this frame, to find where a dropped tab goes
    std::string m_toHide;
};

} // namespace editor
