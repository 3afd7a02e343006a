// RayTile: some thousand instances that lie together, as one Embree tree and a small one of those that came after it
// was built; both are built anew when many came or much has gone.
#pragma once

#include "editor/ray_tree.h"

#include <vector>

namespace editor {

class RayTile {
public:
    static constexpr std::size_t kMostLate = 256; // instances in the small tree

    std::vector<std::uint32_t> members; // places of instances

    bool stale() const { return m_stale || m_lateStale; }
    void touch() { m_stale = true; }       // all is to be built anew
    void came(std::uint32_t place);        // a member
    void went(std::uint32_t place);        // it is a member no longer
    const io::WorldBox& box() const { return m_box; }
    void widen(const io::WorldBox& box) { m_box.add(box); }

    // As RayTree::build. Answers whether the box may have become smaller.
    bool build(RTCDevice device, std::span<const RayInstance> instances, const RayTree::MeshOf& meshOf, bool often);
    void hit(const RayQuery& query, std::span<const RayInstance> instances, double entry, RayTreeHit& best) const;

private:
    RayTree m_main, m_late;
    std::vector<std::uint32_t> m_came; // since the main tree was built
    io::WorldBox m_box; // around the members; wider after one went
    bool m_stale = true;
    bool m_lateStale = false;
};

} // namespace editor
