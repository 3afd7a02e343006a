// A panel: one tab of the workspace. It shows the world and never changes it but by commands.
#pragma once

#include "editor/icons.h"
#include "io/scene/changes.h"

namespace editor {

class Document;
class Editor;

class Panel {
public:
    Panel(const char* id, Icon icon) : m_id{id}, m_icon{icon} {}
    virtual ~Panel() = default;
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    const char* id() const { return m_id; } // "hierarchy"; its title is tr("panel.hierarchy")
    Icon icon() const { return m_icon; }

    // Fills the region's child window; called only while its tab is the one in front.
    virtual void draw(Editor& editor) = 0;
    virtual bool padded() const { return true; } // false: it draws up to the edges and scrolls by itself

    // What changed since the last call; comes before the next draw, also to panels that are hidden.
    virtual void follow(const Document& document, const io::Changes& changes) { (void)document, (void)changes; }

private:
    const char* m_id;
    Icon m_icon;
};

} // namespace editor
