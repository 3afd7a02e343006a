#include "editor/selection.h"

#include <algorithm>

namespace editor {

void Selection::apply(SelectMode mode, std::span<const io::ObjectId> ids)
{
    if (mode == SelectMode::Set && std::ranges::equal(m_ids, ids)) return;
    const std::vector<io::ObjectId> given(ids.begin(), ids.end()); // the span may be our own
    std::unordered_set<std::uint32_t> were;
    for (const io::ObjectId id : given)
        if (contains(id)) were.insert(io::number(id));

    // What is named again leaves first, so that it comes last and is the primary.
    std::erase_if(m_ids, [&](io::ObjectId id) { return mode == SelectMode::Set || were.contains(io::number(id)); });
    if (mode == SelectMode::Set) m_known.clear();
    for (const std::uint32_t id : were)
        m_known.erase(id);

    for (const io::ObjectId id : given) {
        const bool in = mode == SelectMode::Set || mode == SelectMode::Add ||
                        (mode == SelectMode::Toggle && !were.contains(io::number(id)));
        if (in && id != io::ObjectId::None && m_known.insert(io::number(id)).second) m_ids.push_back(id);
    }
    ++m_revision;
}

void Selection::follow(const io::Scene& scene, const io::Changes& changes)
{
    bool gone = false;
    const auto check = [&](io::ObjectId id) {
        if (contains(id) && !scene.find(id)) {
            m_known.erase(io::number(id));
            gone = true;
        }
    };
    // The number of an instance may name another one once its tile has changed.
    const auto checkInstance = [&](io::ObjectId id) {
        if (!io::isInstance(id)) return;
        const auto instance = scene.findInstance(id);
        if (!instance || std::ranges::binary_search(changes.instances, instance->at, std::less{})) check(id);
    };
    if (!changes.instances.empty() || changes.scatter) std::ranges::for_each(m_ids, checkInstance);
    if (changes.everything)
        std::ranges::for_each(m_ids, check);
    else
        std::ranges::for_each(changes.objects, check);
    if (!gone) return;
    std::erase_if(m_ids, [&](io::ObjectId id) { return !contains(id); });
    ++m_revision;
}

std::vector<io::ObjectId> wholeGroups(const Hierarchy& hierarchy, std::span<const io::ObjectId> ids)
{
    std::vector<io::ObjectId> result;
    std::unordered_set<std::uint32_t> known;
    for (const io::ObjectId id : ids) {
        const io::ObjectId top = hierarchy.topmost(id);
        if (known.insert(io::number(top)).second) result.push_back(top);
    }
    return result;
}

std::vector<io::ObjectId> sameTemplate(const io::Scene& scene, std::span<const io::ObjectId> ids)
{
    std::unordered_set<std::uint32_t> templates;
    for (const io::ObjectId id : ids)
        if (const io::Object* object = scene.find(id); object && object->templateId != io::TemplateId::None)
            templates.insert(io::number(object->templateId));
    std::vector<io::ObjectId> result;
    for (const io::Object& object : scene.objects())
        if (templates.contains(io::number(object.templateId))) result.push_back(object.id);
    std::ranges::sort(result);
    return result;
}

std::vector<io::ObjectId> allObjects(const io::Scene& scene, const Hierarchy& hierarchy)
{
    std::vector<io::ObjectId> result;
    result.reserve(scene.objects().size());
    for (const io::Object& object : scene.objects())
        if (hierarchy.parent(object.id) == io::ObjectId::None) result.push_back(object.id);
    std::ranges::sort(result);
    return result;
}

std::vector<io::ObjectId> inverted(const io::Scene& scene, const Hierarchy& hierarchy, const Selection& selection)
{
    std::vector<io::ObjectId> result = allObjects(scene, hierarchy);
    std::erase_if(result, [&](io::ObjectId id) {
        const auto members = hierarchy.withMembers({&id, 1});
        return std::ranges::any_of(members, [&](io::ObjectId member) { return selection.contains(member); });
    });
    return result;
}

} // namespace editor
