// Templates: what can be placed, as pictures under headings; click or drag one into the viewport.
#pragma once

#include "editor/panel.h"
#include "io/scene/ids.h"

#include <imgui.h>
#include <map>
#include <string>
#include <unordered_set>
#include <vector>

namespace editor {

class TemplatesPanel final : public Panel {
public:
    TemplatesPanel() : Panel{"templates", Icon::Tree} {}
    void draw(Editor& editor) override;
    void follow(const Document& document, const io::Changes& changes) override;

private:
    void header(Editor& editor);
    void categories(Editor& editor);
    void grid(Editor& editor);
    void card(Editor& editor, io::TemplateId id);
    void picture(Editor& editor, io::TemplateId id, ImVec2 min, float size);
    void cardMenu(Editor& editor, io::TemplateId id);
    void askToDelete(Editor& editor, io::TemplateId id);
    std::string cardTip(const Document& document, io::TemplateId id) const;
    bool shown(const Document& document, io::TemplateId id) const;

    std::string m_search;
    std::string m_category;                    // empty: all
    std::map<std::string, int> m_categories;   // and how many templates each has
    std::unordered_set<std::uint32_t> m_drawn; // templates whose picture exists already
    float m_size = 92;                         // pixels, side of a picture
    int m_newPictures = 0;                     // made in this frame
};

} // namespace editor
