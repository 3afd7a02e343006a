// Hierarchy: every object of the scene as a tree; chosen, renamed, put into groups here.
#pragma once

#include "editor/panel.h"
#include "editor/panels/tree_rows.h"

#include <imgui.h>

namespace editor {

class HierarchyPanel final : public Panel {
public:
    HierarchyPanel() : Panel{"hierarchy", Icon::Layers} {}
    void draw(Editor& editor) override;
    void follow(const Document& document, const io::Changes& changes) override { m_rows.follow(document, changes); }

private:
    void header(Editor& editor);
    void tree(Editor& editor);
    void revealSelection(Editor& editor);
    void row(Editor& editor, const TreeRow& row, std::size_t index);
    void rowFace(Editor& editor, const TreeRow& row, ImVec2 min, ImVec2 max, bool hovered) const;
    void clickRow(Editor& editor, const TreeRow& row, std::size_t index);
    void dragRow(Editor& editor, const TreeRow& row);
    void dropOn(Editor& editor, io::ObjectId group);
    void renameField(Editor& editor, const TreeRow& row);
    void keys(Editor& editor);
    std::string text(const Document& document, const TreeRow& row) const;
    std::vector<io::ObjectId> idsOf(const Document& document, const TreeRow& row) const;
    bool selected(Editor& editor, const TreeRow& row) const;

    TreeRows m_rows;
    std::string m_search;
    std::size_t m_anchor = TreeRows::kNoRow; // where a range begins
    std::size_t m_scrollTo = TreeRows::kNoRow;
    std::uint64_t m_seenSelection = 0;
    io::ObjectId m_renaming = io::ObjectId::None;
    std::string m_newName;
    bool m_renameBegins = false;
};

} // namespace editor
