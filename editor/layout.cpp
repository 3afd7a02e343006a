#include "editor/layout.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr float kLeast = 80, kMost = 4000; // pixels, that a saved size may have

bool contains(const std::vector<std::string>& list, std::string_view id)
{
    return std::find(list.begin(), list.end(), id) != list.end();
}

void mendFront(Tabs& tabs)
{
    if (!contains(tabs.panels, tabs.front)) tabs.front = tabs.panels.empty() ? "" : tabs.panels.front();
}

std::vector<std::string> strings(const io::Value* list)
{
    std::vector<std::string> result;
    if (const io::Value::Array* array = list ? list->asArray() : nullptr)
        for (const io::Value& item : *array)
            if (const std::string* s = item.asString()) result.push_back(*s);
    return result;
}

io::Value::Array asArray(const std::vector<std::string>& list)
{
    return {list.begin(), list.end()};
}

std::vector<std::string> known(const Layout& home)
{
    std::vector<std::string> all = home.hidden;
    for (const Tabs& tabs : home.regions)
        all.insert(all.end(), tabs.panels.begin(), tabs.panels.end());
    return all;
}

void readRegion(const io::Value& saved, Layout& layout, Region region)
{
    Tabs& tabs = layout.at(region);
    if (const io::Value* size = saved.find("size"))
        if (const double* pixels = size->asNumber(); pixels && std::isfinite(*pixels) && *pixels > 0)
            tabs.size = std::clamp(float(*pixels), kLeast, kMost);
    for (const std::string& id : strings(saved.find("tabs"))) {
        if (!layout.shows(id) && !contains(layout.hidden, id)) continue; // no such panel
        layout.put(id, region);
    }
    if (const io::Value* front = saved.find("front"))
        if (const std::string* id = front->asString()) tabs.front = *id;
    mendFront(tabs);
}

} // namespace

std::string_view name(Region region)
{
    constexpr std::string_view kNames[] = {"left", "right", "bottom", "centre"};
    return kNames[std::size_t(region)];
}

bool Layout::shows(std::string_view panel) const
{
    return std::any_of(regions.begin(), regions.end(), [panel](const Tabs& t) { return contains(t.panels, panel); });
}

void Layout::take(std::string_view panel)
{
    std::erase(hidden, panel);
    for (Tabs& tabs : regions) {
        std::erase(tabs.panels, panel);
        mendFront(tabs);
    }
}

void Layout::put(std::string_view panel, Region region, std::size_t place)
{
    const std::string id{panel};
    take(id);
    Tabs& tabs = at(region);
    tabs.panels.insert(tabs.panels.begin() + std::ptrdiff_t(std::min(place, tabs.panels.size())), id);
    tabs.front = id;
}

void Layout::hide(std::string_view panel)
{
    const std::string id{panel};
    take(id);
    hidden.push_back(id);
}

io::Value toValue(const Layout& layout)
{
    io::Value result;
    for (const Region region : kRegions) {
        const Tabs& tabs = layout.at(region);
        io::Value& entry = result[name(region)];
        entry["tabs"] = asArray(tabs.panels);
        entry["front"] = tabs.front;
        if (region != Region::Centre) entry["size"] = std::round(tabs.size);
    }
    result["hidden"] = asArray(layout.hidden);
    return result;
}

Layout layoutFrom(const io::Value& saved, const Layout& home)
{
    Layout layout = home;
    if (!saved.asObject()) return layout;
    for (const Region region : kRegions)
        if (const io::Value* entry = saved.find(name(region))) readRegion(*entry, layout, region);
    const std::vector<std::string> panels = known(home);
    for (const std::string& id : strings(saved.find("hidden")))
        if (contains(panels, id)) layout.hide(id);
    return layout;
}

} // namespace editor
