// Selection: which objects a person works on, in the order they were chosen; the last one is the primary.
#pragma once

#include "editor/hierarchy.h"
#include "io/scene/changes.h"
#include "io/scene/scene.h"

#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

namespace editor {

enum class SelectMode { Set, Add, Remove, Toggle };

class Selection {
public:
    std::span<const io::ObjectId> ids() const { return m_ids; }
    std::size_t size() const { return m_ids.size(); }
    bool empty() const { return m_ids.empty(); }
    bool contains(io::ObjectId id) const { return m_known.contains(io::number(id)); }
    io::ObjectId primary() const { return m_ids.empty() ? io::ObjectId::None : m_ids.back(); }

    void apply(SelectMode mode, std::span<const io::ObjectId> ids);
    void set(std::span<const io::ObjectId> ids) { apply(SelectMode::Set, ids); }
    void set(io::ObjectId id) { apply(SelectMode::Set, {&id, 1}); }
    void add(io::ObjectId id) { apply(SelectMode::Add, {&id, 1}); }
    void remove(io::ObjectId id) { apply(SelectMode::Remove, {&id, 1}); }
    void toggle(io::ObjectId id) { apply(SelectMode::Toggle, {&id, 1}); }
    void clear() { apply(SelectMode::Set, {}); }

    void follow(const io::Scene& scene, const io::Changes& changes); // drops ids that are gone
    std::uint64_t revision() const { return m_revision; }            // rises when the selection changes

private:
    std::vector<io::ObjectId> m_ids;
    std::unordered_set<std::uint32_t> m_known;
    std::uint64_t m_revision = 1;
};

// What to select when these were clicked: each one's outermost group, once.
std::vector<io::ObjectId> wholeGroups(const Hierarchy& hierarchy, std::span<const io::ObjectId> ids);
std::vector<io::ObjectId> sameTemplate(const io::Scene& scene, std::span<const io::ObjectId> ids);
std::vector<io::ObjectId> allObjects(const io::Scene& scene, const Hierarchy& hierarchy); // groups instead of members
std::vector<io::ObjectId> inverted(const io::Scene& scene, const Hierarchy& hierarchy, const Selection& selection);

} // namespace editor
