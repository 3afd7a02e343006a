#include "editor/panels/tree_rows.h"

#include "editor/search_text.h"

#include <algorithm>
#include <map>

namespace editor {

void TreeRows::follow(const Document& document, const io::Changes& changes)
{
    if (changes.everything) {
        m_known.clear();
        m_openGroups.clear();
        m_openTemplates.clear();
        for (const io::Object& object : document.scene().objects())
            learn(document, object.id);
        m_stale = true;
    }
    for (const io::ObjectId id : changes.objects)
        m_stale |= learn(document, id);
    m_stale |= !changes.templates.empty();
}

// Whether something that the tree shows is not as it was.
bool TreeRows::learn(const Document& document, io::ObjectId id)
{
    const io::Object* object = document.scene().find(id);
    if (!object) return m_known.erase(io::number(id)) > 0;
    Known now{object->parent, object->templateId, object->name};
    const auto [place, added] = m_known.try_emplace(io::number(id));
    if (!added && place->second == now) return false;
    place->second = std::move(now);
    return true;
}

void TreeRows::setFilter(std::string filter)
{
    filter = lowerCase(filter);
    m_stale |= filter != m_filter;
    m_filter = std::move(filter);
}

void TreeRows::setByTemplate(bool byTemplate)
{
    m_stale |= byTemplate != m_byTemplate;
    m_byTemplate = byTemplate;
}

void TreeRows::setOpen(const TreeRow& row, bool open)
{
    auto& set = row.kind == TreeRow::Kind::Template ? m_openTemplates : m_openGroups;
    const std::uint32_t key = row.kind == TreeRow::Kind::Template ? io::number(row.templateId) : io::number(row.id);
    if (open)
        set.insert(key);
    else
        set.erase(key);
    m_stale = true;
}

void TreeRows::reveal(const Document& document, io::ObjectId id)
{
    const Hierarchy& hierarchy = document.hierarchy();
    const io::Object* object = document.scene().find(id);
    if (!object) return;
    bool opened = false;
    for (io::ObjectId up = hierarchy.parent(id); up != io::ObjectId::None; up = hierarchy.parent(up))
        opened |= m_openGroups.insert(io::number(up)).second;
    if (hierarchy.parent(id) == io::ObjectId::None && object->templateId != io::TemplateId::None && m_byTemplate)
        opened |= m_openTemplates.insert(io::number(object->templateId)).second;
    m_stale |= opened;
}

void TreeRows::update(const Document& document)
{
    if (std::exchange(m_stale, false)) build(document);
}

std::size_t TreeRows::find(io::ObjectId id) const
{
    const auto found = std::find_if(m_rows.begin(), m_rows.end(), [id](const TreeRow& row) {
        return row.kind != TreeRow::Kind::Template && row.id == id;
    });
    return found == m_rows.end() ? kNoRow : std::size_t(found - m_rows.begin());
}

void TreeRows::build(const Document& document)
{
    m_rows.clear();
    std::map<std::pair<std::string, std::uint32_t>, std::vector<io::ObjectId>> byTemplate; // by name
    std::vector<io::ObjectId> groups, loose;
    for (const io::Object& object : document.scene().objects()) {
        if (object.parent != io::ObjectId::None && document.scene().find(object.parent)) continue;
        if (object.templateId == io::TemplateId::None)
            groups.push_back(object.id);
        else if (!m_byTemplate)
            loose.push_back(object.id);
        else
            byTemplate[{std::string{document.scene().templateName(object.templateId)}, io::number(object.templateId)}]
                .push_back(object.id);
    }
    std::sort(groups.begin(), groups.end());
    std::sort(loose.begin(), loose.end());
    for (const io::ObjectId id : groups)
        addGroup(document, id, 0);
    for (auto& [name, members] : byTemplate) {
        std::sort(members.begin(), members.end());
        addTemplate(document, io::TemplateId{name.second}, members);
    }
    for (const io::ObjectId id : loose)
        if (matches(document, id)) m_rows.push_back({.id = id, .templateId = document.scene().at(id).templateId});
}

void TreeRows::addGroup(const Document& document, io::ObjectId id, int depth)
{
    const bool own = matches(document, id);
    if (!own && !anyMatches(document, id)) return;
    const std::span<const io::ObjectId> members = document.hierarchy().children(id);
    const bool open = m_openGroups.contains(io::number(id)) || (!m_filter.empty() && !own);
    m_rows.push_back({.kind = TreeRow::Kind::Group, .id = id, .depth = depth, .count = members.size(), .open = open});
    if (!open) return;
    for (const io::ObjectId member : members) {
        const io::Object& object = document.scene().at(member);
        if (object.templateId == io::TemplateId::None)
            addGroup(document, member, depth + 1);
        else if (own || matches(document, member))
            m_rows.push_back({.id = member, .templateId = object.templateId, .depth = depth + 1});
    }
}

void TreeRows::addTemplate(const Document& document, io::TemplateId id, const std::vector<io::ObjectId>& members)
{
    std::vector<io::ObjectId> shown;
    if (m_filter.empty())
        shown = members;
    else
        std::copy_if(members.begin(), members.end(), std::back_inserter(shown),
                     [&](io::ObjectId m) { return matches(document, m); });
    if (shown.empty()) return;
    const bool open = m_openTemplates.contains(io::number(id));
    m_rows.push_back({.kind = TreeRow::Kind::Template, .templateId = id, .count = shown.size(), .open = open});
    for (const io::ObjectId member : shown)
        if (open) m_rows.push_back({.id = member, .templateId = id, .depth = 1});
}

bool TreeRows::matches(const Document& document, io::ObjectId id) const
{
    return m_filter.empty() || holds(displayName(document.scene(), document.scene().at(id)), m_filter);
}

bool TreeRows::anyMatches(const Document& document, io::ObjectId group) const
{
    const std::span<const io::ObjectId> members = document.hierarchy().children(group);
    return std::any_of(members.begin(), members.end(),
                       [&](io::ObjectId m) { return matches(document, m) || anyMatches(document, m); });
}

} // namespace editor
