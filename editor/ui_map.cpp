#include "editor/ui_map.h"

#include <imgui_internal.h>
#include <vector>

namespace editor {
namespace {

struct Item {
    std::string panel, label;
    std::string kind;
    ImVec2 min, max;
    io::Value value;
};

std::vector<Item> g_items;
std::string g_panel = "window";

// In pixels of the picture, whatever the window's scale.
io::Value rectangle(const Item& item)
{
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    return io::Value::Array{item.min.x * scale.x, item.min.y * scale.y, (item.max.x - item.min.x) * scale.x,
                            (item.max.y - item.min.y) * scale.y};
}

} // namespace

MapPanel::MapPanel(std::string_view panel) : m_outer{std::move(g_panel)}
{
    g_panel = panel;
}

MapPanel::~MapPanel()
{
    g_panel = std::move(m_outer);
}

void clearMap()
{
    g_items.clear();
}

void mapItem(std::string_view kind, std::string_view label, io::Value value)
{
    mapRect(kind, label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), std::move(value));
}

void mapRect(std::string_view kind, std::string_view label, ImVec2 min, ImVec2 max, io::Value value)
{
    // The reading form: the other marks ImGui's fallback window as used, which then shows itself as "Debug".
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    ImRect seen{min, max};
    const ImRect display{{0, 0}, ImGui::GetIO().DisplaySize};
    seen.ClipWith(window.IsFallbackWindow ? display : window.ClipRect);
    min = seen.Min;
    max = seen.Max;
    if (min.x >= max.x || min.y >= max.y) return;
    g_items.push_back({g_panel, std::string{label}, std::string{kind}, min, max, std::move(value)});
}

io::Value uiMap()
{
    io::Value::Array result;
    for (const Item& item : g_items) {
        io::Value::Object entry{
            {"panel", item.panel}, {"label", item.label}, {"kind", item.kind}, {"rect", rectangle(item)}};
        if (!item.value.isNull()) entry.emplace_back("value", item.value);
        result.emplace_back(std::move(entry));
    }
    return result;
}

} // namespace editor
