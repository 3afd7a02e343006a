// Hierarchy: which objects a group holds. Follows the scene; a change costs what it names.
#pragma once

#include "io/scene/changes.h"
#include "io/scene/scene.h"

#include <span>
#include <unordered_map>
#include <vector>

namespace editor {

class Hierarchy {
public:
    void update(const io::Scene& scene, const io::Changes& changes);

    std::span<const io::ObjectId> children(io::ObjectId group) const; // sorted by id
    bool holdsAny(io::ObjectId group) const { return !children(group).empty(); }
    io::ObjectId parent(io::ObjectId id) const;  // None when it is in no group
    io::ObjectId topmost(io::ObjectId id) const; // the outermost group it is in, or itself

    // The ids and everything in those that are groups, each once, in order.
    std::vector<io::ObjectId> withMembers(std::span<const io::ObjectId> ids) const;
    // Those of the ids that are inside none of the others.
    std::vector<io::ObjectId> outermost(std::span<const io::ObjectId> ids) const;

private:
    void leave(io::ObjectId id);
    void join(io::ObjectId id, io::ObjectId group);

    std::unordered_map<std::uint32_t, io::ObjectId> m_parents; // only of objects in a group
    std::unordered_map<std::uint32_t, std::vector<io::ObjectId>> m_children;
};

} // namespace editor
