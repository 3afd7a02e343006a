#include "editor/workspace.h"

#include "editor/text.h"
#include "editor/widgets.h"
#include "io/base/contract.h"

#include <algorithm>

namespace editor {
namespace {

constexpr float kGap = 4;    // pixels between regions, where the splitters are
constexpr float kStrip = 32; // height of a tab strip
constexpr float kTabGap = 2;
constexpr float kLeastSide = 160, kLeastBottom = 110, kLeastCentre = 240;
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                                    ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNavFocus;

std::string title(const Panel& panel)
{
    return tr("panel." + std::string{panel.id()});
}

float tabWidth(const Panel& panel, bool front, bool narrow)
{
    if (narrow && !front) return 34; // its icon alone
    return ImGui::CalcTextSize(title(panel).c_str()).x + (front ? 60 : 40);
}

} // namespace

void Workspace::add(Panel& panel, Region home, bool shown)
{
    m_panels.push_back(&panel);
    if (shown)
        m_home.at(home).panels.emplace_back(panel.id());
    else
        m_home.hidden.emplace_back(panel.id());
    Tabs& tabs = m_home.at(home);
    if (!tabs.panels.empty()) tabs.front = tabs.panels.front();
    m_layout = m_home;
}

void Workspace::setHomeSize(Region region, float pixels)
{
    m_home.at(region).size = m_layout.at(region).size = pixels;
}

bool Workspace::inFront(std::string_view panel) const
{
    return std::any_of(m_layout.regions.begin(), m_layout.regions.end(),
                       [panel](const Tabs& t) { return t.front == panel; });
}

void Workspace::toggle(std::string_view panel)
{
    if (shows(panel))
        m_layout.hide(panel);
    else
        m_layout.put(panel, homeOf(panel));
}

void Workspace::bringToFront(std::string_view panel)
{
    if (!shows(panel)) m_layout.put(panel, homeOf(panel));
    for (Tabs& tabs : m_layout.regions)
        if (std::find(tabs.panels.begin(), tabs.panels.end(), panel) != tabs.panels.end()) tabs.front = panel;
}

Panel* Workspace::find(std::string_view id) const
{
    const auto found = std::find_if(m_panels.begin(), m_panels.end(), [id](const Panel* p) { return p->id() == id; });
    return found == m_panels.end() ? nullptr : *found;
}

Region Workspace::homeOf(std::string_view panel) const
{
    for (const Region region : kRegions) {
        const std::vector<std::string>& ids = m_home.at(region).panels;
        if (std::find(ids.begin(), ids.end(), panel) != ids.end()) return region;
    }
    return Region::Bottom;
}

std::array<Workspace::Rect, 4> Workspace::arranged(ImVec2 min, ImVec2 max) const
{
    const auto size = [this](Region region, float least, float most) {
        const Tabs& tabs = m_layout.at(region);
        return tabs.panels.empty() ? 0 : std::clamp(tabs.size, least, std::max(least, most));
    };
    const float width = max.x - min.x, height = max.y - min.y;
    float left = size(Region::Left, kLeastSide, width), right = size(Region::Right, kLeastSide, width);
    const float most =
        std::max(width * 0.25f, width - std::max(kLeastCentre, width * 0.4f)); // the centre keeps the rest
    const float share = std::min(1.f, most / std::max(left + right, 1.f));
    left = std::floor(left * share);
    right = std::floor(right * share);
    const float bottom = size(Region::Bottom, kLeastBottom, height * 0.5f);
    const float x0 = min.x + left + (left > 0 ? kGap : 0), x1 = max.x - right - (right > 0 ? kGap : 0);
    const float y1 = max.y - bottom - (bottom > 0 ? kGap : 0);
    std::array<Rect, 4> rects;
    rects[std::size_t(Region::Left)] = {min, {min.x + left, max.y}};
    rects[std::size_t(Region::Right)] = {{max.x - right, min.y}, max};
    rects[std::size_t(Region::Bottom)] = {{x0, max.y - bottom}, {x1, max.y}};
    rects[std::size_t(Region::Centre)] = {{x0, min.y}, {x1, y1}};
    return rects;
}

void Workspace::draw(Editor& editor, ImVec2 min, ImVec2 max)
{
    if (max.x - min.x < 1 || max.y - min.y < 1) return;
    m_tabMiddles.clear();
    const std::array<Rect, 4> rects = arranged(min, max);
    splitters(rects, min, max);
    for (const Region region : kRegions)
        if (!m_layout.at(region).panels.empty()) drawRegion(editor, region, rects[std::size_t(region)]);
    dropZones(rects, min, max);
    if (!m_toHide.empty()) m_layout.hide(std::exchange(m_toHide, {}));
}

void Workspace::splitters(const std::array<Rect, 4>& rects, ImVec2 min, ImVec2 max)
{
    const MapPanel map{"workspace"};
    const Rect& left = rects[std::size_t(Region::Left)];
    const Rect& right = rects[std::size_t(Region::Right)];
    const Rect& bottom = rects[std::size_t(Region::Bottom)];
    if (left.max.x > left.min.x)
        splitter(Region::Left, {{left.max.x, min.y}, {left.max.x + kGap, max.y}}, max.x - min.x);
    if (right.max.x > right.min.x)
        splitter(Region::Right, {{right.min.x - kGap, min.y}, {right.min.x, max.y}}, max.x - min.x);
    if (bottom.max.y > bottom.min.y)
        splitter(Region::Bottom, {{bottom.min.x, bottom.min.y - kGap}, {bottom.max.x, bottom.min.y}}, max.y - min.y);
}

// A window of its own, no larger than the grip: what it covers could not be clicked.
void Workspace::splitter(Region region, const Rect& grip, float room)
{
    const std::string label{name(region)};
    ImGui::SetNextWindowPos(grip.min);
    ImGui::SetNextWindowSize({grip.max.x - grip.min.x, grip.max.y - grip.min.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
    ImGui::Begin(("##splitter." + label).c_str(), nullptr, kFixed | ImGuiWindowFlags_NoBackground);
    ImGui::InvisibleButton(label.c_str(), {grip.max.x - grip.min.x, grip.max.y - grip.min.y});
    mapItem("splitter", label, m_layout.at(region).size);
    const bool across = region == Region::Bottom, active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(across ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
        ImGui::GetWindowDrawList()->AddRectFilled(grip.min, grip.max, active ? palette::kAccent : palette::kHover);
    }
    if (active) {
        float& size = m_layout.at(region).size;
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        size += across ? -moved.y : region == Region::Left ? moved.x : -moved.x;
        size = std::clamp(size, across ? kLeastBottom : kLeastSide, std::max(kLeastSide, room - kLeastCentre));
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void Workspace::drawRegion(Editor& editor, Region region, const Rect& rect)
{
    ImGui::SetNextWindowPos(rect.min);
    ImGui::SetNextWindowSize({rect.max.x - rect.min.x, rect.max.y - rect.min.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
    ImGui::Begin(("##region." + std::string{name(region)}).c_str(), nullptr, kFixed);
    ImGui::PopStyleVar();
    tabStrip(region, rect);
    if (Panel* panel = find(m_layout.at(region).front)) drawPanel(editor, *panel, region);
    ImGui::End();
}

void Workspace::tabStrip(Region region, const Rect& rect)
{
    const MapPanel map{"tabs"};
    ImGui::GetWindowDrawList()->AddRectFilled(rect.min, {rect.max.x, rect.min.y + kStrip}, palette::kStrip);
    float x = rect.min.x + 4;
    const std::vector<std::string> ids = m_layout.at(region).panels; // a copy: a click may change the layout
    float all = x - rect.min.x;
    for (const std::string& id : ids)
        if (const Panel* panel = find(id)) all += tabWidth(*panel, id == m_layout.at(region).front, false) + kTabGap;
    const bool narrow = all > rect.max.x - rect.min.x; // then only the one in front says its name
    for (const std::string& id : ids)
        if (const Panel* panel = find(id)) tab(region, *panel, x, rect.min.y, narrow);
}

void Workspace::tab(Region region, const Panel& panel, float& x, float top, bool narrow)
{
    const std::string text = title(panel);
    Tabs& tabs = m_layout.at(region);
    const bool front = tabs.front == panel.id();
    const bool named = front || !narrow;
    const ImVec2 min{x, top + 4}, max{x + tabWidth(panel, front, narrow), top + kStrip};
    m_tabMiddles.emplace_back(region, (min.x + max.x) / 2);
    x = max.x + kTabGap;

    ImGui::SetCursorScreenPos(min);
    ImGui::InvisibleButton(panel.id(), {max.x - min.x, max.y - min.y});
    ImGui::SetItemAllowOverlap();
    const bool hovered = ImGui::IsItemHovered();
    if (ImGui::IsItemActivated()) tabs.front = panel.id();
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 6)) m_dragged = panel.id();
    mapItem("tab", text, front);
    if (!named && hovered && m_dragged.empty()) ui::tooltip(text.c_str());

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (front || hovered)
        draw.AddRectFilled(min, max, front ? palette::kPanel : palette::kRaised, 4, ImDrawFlags_RoundCornersTop);
    if (front) draw.AddRectFilled(min, {max.x, min.y + 2}, palette::kAccent, 4, ImDrawFlags_RoundCornersTop);
    const ImU32 colour = front ? palette::kText : palette::kSoftText;
    drawIcon(draw, panel.icon(), {min.x + 10, min.y + 7}, 14, front ? palette::kAccent : palette::kFaintText);
    if (named) draw.AddText({min.x + 30, min.y + (max.y - min.y - ImGui::GetFontSize()) / 2}, colour, text.c_str());
    if (!front) return;
    ImGui::SetCursorScreenPos({max.x - 25, min.y + 4});
    const std::string close = std::string{"close."} + panel.id();
    if (ui::iconButton({.id = close.c_str(),
                        .icon = Icon::Close,
                        .label = trf("common.hide_panel", text),
                        .size = 20,
                        .colour = palette::kFaintText}))
        m_toHide = panel.id();
}

void Workspace::drawPanel(Editor& editor, Panel& panel, Region region)
{
    const MapPanel map{panel.id()};
    ImGui::SetCursorPos({0, kStrip});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, panel.padded() ? ImVec2{10, 10} : ImVec2{0, 0});
    const ImGuiWindowFlags flags = panel.padded() ? ImGuiWindowFlags_AlwaysUseWindowPadding
                                                  : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::BeginChild((std::string{panel.id()} + "." + std::string{name(region)}).c_str(), {0, 0}, false, flags);
    ImGui::PopStyleVar();
    mapRect("panel", title(panel), ImGui::GetWindowPos(),
            {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
    panel.draw(editor);
    ImGui::EndChild();
}

// While a tab is dragged: shows where it would go, and puts it there when it is let go.
void Workspace::dropZones(const std::array<Rect, 4>& rects, ImVec2 min, ImVec2 max)
{
    if (m_dragged.empty()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    constexpr float kEdge = 72; // of a region that is empty now
    std::optional<Region> target;
    for (const Region region : {Region::Centre, Region::Left, Region::Right, Region::Bottom}) {
        Rect zone = rects[std::size_t(region)];
        if (m_layout.at(region).panels.empty()) {
            if (region == Region::Left) zone = {min, {min.x + kEdge, max.y}};
            if (region == Region::Right) zone = {{max.x - kEdge, min.y}, max};
            if (region == Region::Bottom) zone = {{zone.min.x, max.y - kEdge}, {zone.max.x, max.y}};
        }
        if (!zone.contains(mouse)) continue;
        target = region;
        draw.AddRectFilled(zone.min, zone.max, palette::kAccentFaint);
        draw.AddRect(zone.min, zone.max, palette::kAccent, 3, 0, 2);
    }
    if (const Panel* panel = find(m_dragged)) {
        const std::string text = title(*panel);
        const ImVec2 at{mouse.x + 12, mouse.y + 8};
        draw.AddRectFilled(at, {at.x + ImGui::CalcTextSize(text.c_str()).x + 40, at.y + 28}, palette::kRaised, 4);
        drawIcon(draw, panel->icon(), {at.x + 10, at.y + 7}, 14, palette::kAccent);
        draw.AddText({at.x + 30, at.y + 6}, palette::kText, text.c_str());
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    if (target) dropTab(*target);
    m_dragged.clear();
}

void Workspace::dropTab(Region region)
{
    const float x = ImGui::GetIO().MousePos.x;
    std::size_t place = 0;
    for (const auto& [where, middle] : m_tabMiddles)
        if (where == region && x > middle) ++place;
    const std::vector<std::string>& ids = m_layout.at(region).panels;
    const auto own = std::find(ids.begin(), ids.end(), m_dragged);
    if (own != ids.end() && std::size_t(own - ids.begin()) < place) --place; // it leaves its old place first
    if (m_layout.at(region).panels.empty() && m_layout.at(region).size <= 0)
        m_layout.at(region).size = m_home.at(region).size;
    m_layout.put(m_dragged, region, place);
}

} // namespace editor
