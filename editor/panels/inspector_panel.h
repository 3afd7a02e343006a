// Inspector: the values of what is selected; a change goes to all of the selection.
#pragma once

#include "editor/panel.h"
#include "editor/scalars.h"
#include "io/scene/bounds.h"
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
    void drawInstance(Editor& editor, const io::InstanceRef& instance);
    void drawHeader(Editor& editor, const io::Object& primary);
    void drawTemplateChoice(Editor& editor, const io::Object& primary);
    void drawGroupRow(Editor& editor, const io::Object& primary);
    void drawTransform(Editor& editor, const io::Object& primary);
    void drawFacts(const io::Object& primary) const;
    void drawTemplate(Editor& editor, io::TemplateId id);
    void refresh(Editor& editor, const io::Object& primary);

    std::vector<bool> m_mixed; // by scalar of the transform
    bool m_mixedTemplates = false;
    bool m_mixedNames = false;
    io::WorldBox m_bounds;
    std::uint64_t m_triangles = 0;
    std::size_t m_members = 0;                     // of the primary, when it is a group
    std::uint64_t m_revision = 0, m_selection = 0; // of which all these are
};

} // namespace editor
