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
            setParent(object.id, object.parent);
        return;
    }
    for (const io::ObjectId id : changes.objects) {
        const io::Object* object = scene.find(id);
        setParent(id, object ? object->parent : io::ObjectId::None);
    }
}

void Hierarchy::setParent(io::ObjectId id, io::ObjectId parent)
{
    const io::ObjectId before = this->parent(id);
    if (before == parent) return;
    if (before != io::ObjectId::None) {
        std::vector<io::ObjectId>& siblings = m_children[io::number(before)];
        siblings.erase(std::ranges::lower_bound(siblings, id));
        if (siblings.empty()) m_children.erase(io::number(before));
    }
    if (parent != io::ObjectId::None) {
        std::vector<io::ObjectId>& siblings = m_children[io::number(parent)];
        siblings.insert(std::ranges::lower_bound(siblings, id), id);
        m_parents[io::number(id)] = parent;
    } else {
        m_parents.erase(io::number(id));
    }
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
    // A file may hold a ring of groups; it has no outermost one, and nobody may hang on it.
    std::size_t steps = 0;
    for (io::ObjectId up = parent(id); up != io::ObjectId::None && steps <= m_parents.size(); up = parent(up), ++steps)
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
        std::size_t steps = 0;
        for (io::ObjectId up = parent(id); up != io::ObjectId::None && !inside && steps <= m_parents.size();
             up = parent(up), ++steps)
            inside = up != id && chosen.contains(io::number(up));
        if (!inside && chosen.erase(io::number(id))) {
            result.push_back(id);
            chosen.insert(io::number(id));
        }
    }
    return result;
}

} // namespace editor
