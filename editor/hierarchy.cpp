#include "editor/hierarchy.h"

#include <algorithm>
#include <unordered_set>

namespace editor {

void Hierarchy::update(const io::Scene& scene, const io::Changes& changes)
{
    if (changes.everything) {
        m_parents.clear();
        m_children.clear();
        for (const io::Object& object : scene.objects())
            join(object.id, object.parent);
        return;
    }
    // All leave before the first joins, so that two groups that change places are never inside each other.
    for (const io::ObjectId id : changes.objects) {
        const io::Object* object = scene.find(id);
        if (parent(id) != (object ? object->parent : io::ObjectId::None)) leave(id);
    }
    for (const io::ObjectId id : changes.objects)
        if (const io::Object* object = scene.find(id); object && parent(id) != object->parent) join(id, object->parent);
}

void Hierarchy::leave(io::ObjectId id)
{
    const auto found = m_parents.find(io::number(id));
    if (found == m_parents.end()) return;
    std::vector<io::ObjectId>& siblings = m_children[io::number(found->second)];
    siblings.erase(std::ranges::lower_bound(siblings, id));
    if (siblings.empty()) m_children.erase(io::number(found->second));
    m_parents.erase(found);
}

// A file may hold a ring of groups; here the link that would close it counts as none.
void Hierarchy::join(io::ObjectId id, io::ObjectId group)
{
    if (group == io::ObjectId::None || topmost(group) == id) return;
    std::vector<io::ObjectId>& siblings = m_children[io::number(group)];
    siblings.insert(std::ranges::lower_bound(siblings, id), id);
    m_parents[io::number(id)] = group;
}

std::span<const io::ObjectId> Hierarchy::children(io::ObjectId group) const
{
    const auto found = m_children.find(io::number(group));
    return found == m_children.end() ? std::span<const io::ObjectId>{} : found->second;
}

io::ObjectId Hierarchy::parent(io::ObjectId id) const
{
    const auto found = m_parents.find(io::number(id));
    return found == m_parents.end() ? io::ObjectId::None : found->second;
}

io::ObjectId Hierarchy::topmost(io::ObjectId id) const
{
    for (io::ObjectId up = parent(id); up != io::ObjectId::None; up = parent(up))
        id = up;
    return id;
}

std::vector<io::ObjectId> Hierarchy::withMembers(std::span<const io::ObjectId> ids) const
{
    std::vector<io::ObjectId> result;
    std::unordered_set<std::uint32_t> known;
    std::vector<io::ObjectId> waiting(ids.rbegin(), ids.rend());
    while (!waiting.empty()) {
        const io::ObjectId id = waiting.back();
        waiting.pop_back();
        if (!known.insert(io::number(id)).second) continue;
        result.push_back(id);
        const auto members = children(id);
        waiting.insert(waiting.end(), members.rbegin(), members.rend());
    }
    return result;
}

std::vector<io::ObjectId> Hierarchy::outermost(std::span<const io::ObjectId> ids) const
{
    std::unordered_set<std::uint32_t> chosen;
    for (const io::ObjectId id : ids)
        chosen.insert(io::number(id));
    std::vector<io::ObjectId> result;
    for (const io::ObjectId id : ids) {
        bool inside = false;
        for (io::ObjectId up = parent(id); up != io::ObjectId::None && !inside; up = parent(up))
            inside = chosen.contains(io::number(up));
        if (!inside && chosen.erase(io::number(id))) {
            result.push_back(id);
            chosen.insert(io::number(id));
        }
    }
    return result;
}

} // namespace editor
