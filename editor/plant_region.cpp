#include "editor/plant_region.h"

#include <algorithm>
#include <cmath>

namespace editor {

PlantRegion PlantRegion::disc(const glm::dvec2& centre, double radius)
{
    PlantRegion region;
    region.m_radius = radius;
    region.m_bounds = {centre - radius, centre + radius};
    return region;
}

PlantRegion PlantRegion::polygon(std::vector<glm::dvec2> corners)
{
    PlantRegion region;
    if (!corners.empty()) region.m_bounds = {corners.front(), corners.front()};
    for (const glm::dvec2& corner : corners)
        region.m_bounds = {glm::min(region.m_bounds.low, corner), glm::max(region.m_bounds.high, corner)};
    region.m_corners = std::move(corners);
    return region;
}

PlantRegion PlantRegion::everywhere()
{
    constexpr double kFar = 1e7; // m
    PlantRegion region;
    region.m_bounds = {glm::dvec2{-kFar}, glm::dvec2{kFar}};
    return region;
}

bool PlantRegion::contains(const glm::dvec2& at) const
{
    if (!m_bounds.contains(at)) return false;
    if (m_radius) return glm::distance(at, (m_bounds.low + m_bounds.high) / 2.0) <= *m_radius;
    if (m_corners.empty()) return true;
    bool inside = false;
    for (std::size_t i = 0, before = m_corners.size() - 1; i < m_corners.size(); before = i++) {
        const glm::dvec2 &a = m_corners[i], &b = m_corners[before];
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

} // namespace editor
