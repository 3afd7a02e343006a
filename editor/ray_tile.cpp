#include "editor/ray_tile.h"

#include <algorithm>

namespace editor {

void RayTile::came(std::uint32_t place)
{
    if (m_stale) return;
    m_came.push_back(place);
    m_lateStale = true;
    if (m_came.size() > kMostLate) m_stale = true;
}

void RayTile::went(std::uint32_t place)
{
    if (m_stale) return;
    if (const auto late = std::ranges::find(m_came, place); late != m_came.end()) {
        m_came.erase(late);
        m_late.lose();
    } else {
        m_main.lose();
        if (m_main.muchLost()) m_stale = true;
    }
}

bool RayTile::build(RTCDevice device, std::span<const RayInstance> instances, const RayTree::MeshOf& meshOf, bool often)
{
    if (!m_stale) {
        m_late.build(device, m_came, instances, meshOf, true);
        m_lateStale = false;
        return false;
    }
    m_box = {};
    for (const std::uint32_t place : members)
        m_box.add(instances[place].bounds);
    m_main.build(device, members, instances, meshOf, often);
    m_late.clear();
    m_came.clear();
    m_stale = m_lateStale = false;
    return true;
}

void RayTile::hit(const RayQuery& query, std::span<const RayInstance> instances, double entry, RayTreeHit& best) const
{
    for (const RayTree* tree : {&m_main, &m_late})
        if (!tree->empty()) tree->hit(query, instances, entry, best.distance, best);
}

} // namespace editor
