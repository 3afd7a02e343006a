// Inspector: the values of what is selected; a change goes to all of the selection.
#pragma once

#include "editor/panel.h"
#include "editor/scalars.h"
#include "io/scene/object.h"

#include <string>
#include <vector>

namespace editor {

class InspectorPanel final : public Panel {
public:
    InspectorPanel() : Panel{"inspector", Icon::Sliders} {}
    void draw(Editor& editor) override;

private:
    void drawObjects(Editor& editor);
    void drawHeader(Editor& editor, const io::Object& primary);
    void drawTemplateChoice(Editor& editor, const io::Object& primary);
    void drawGroupRow(Editor& editor, const io::Object& primary);
    void drawTransform(Editor& editor, const io::Object& primary);
    void drawFacts(Editor& editor, const io::Object& primary);
    void drawTemplate(Editor& editor, io::TemplateId id);
    void refreshMixed(Editor& editor, const io::Object& primary);

    std::vector<bool> m_mixed;       // by scalar of the transform
    bool m_mixedTemplates = false;
    bool m_mixedNames = false;
    std::uint64_t m_revision = 0, m_selection = 0; // of which the three are
};

} // namespace editor
