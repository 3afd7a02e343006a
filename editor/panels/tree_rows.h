// The rows of the Hierarchy panel: groups with their members, and what is in no group under its template. Made new
// only when names, parents or templates changed, so that moving things costs nothing however many there are.
#pragma once

#include "editor/document.h"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace editor {

struct TreeRow {
    enum class Kind { Object, Group, Template }; // Template: a heading for all of one that are in no group
    Kind kind = Kind::Object;
    io::ObjectId id = io::ObjectId::None;
    io::TemplateId templateId = io::TemplateId::None;
    int depth = 0;
    std::size_t count = 0; // of members
    bool open = false;
};

class TreeRows {
public:
    void follow(const Document& document, const io::Changes& changes);
    void setFilter(std::string filter); // only what holds it in its name, and the groups around that
    void setByTemplate(bool byTemplate);
    bool byTemplate() const { return m_byTemplate; }
    void setOpen(const TreeRow& row, bool open);
    void reveal(const Document& document, io::ObjectId id); // opens what it is in

    void update(const Document& document);
    const std::vector<TreeRow>& rows() const { return m_rows; } // as of the last update()
    static constexpr std::size_t kNoRow = ~std::size_t(0);
    std::size_t find(io::ObjectId id) const; // of the last update()

private:
    struct Known {
        io::ObjectId parent = io::ObjectId::None;
        io::TemplateId templateId = io::TemplateId::None;
        std::string name;
        bool operator==(const Known&) const = default;
    };
    bool learn(const Document& document, io::ObjectId id);
    void build(const Document& document);
    void addGroup(const Document& document, io::ObjectId id, int depth);
    void addTemplate(const Document& document, io::TemplateId id, const std::vector<io::ObjectId>& members);
    bool matches(const Document& document, io::ObjectId id) const;
    bool anyMatches(const Document& document, io::ObjectId group) const;

    std::unordered_map<std::uint32_t, Known> m_known;
    std::unordered_set<std::uint32_t> m_openGroups, m_openTemplates;
    std::vector<TreeRow> m_rows;
    std::string m_filter; // lower case
    bool m_byTemplate = true;
    bool m_stale = true;
};

} // namespace editor
