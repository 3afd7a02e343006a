// Environment: light and air of the scene, and the looks that can be put onto it; every change is seen in the next frame.
#pragma once

#include "editor/panel.h"

#include <string>

namespace editor {

class EnvironmentPanel final : public Panel {
public:
    EnvironmentPanel() : Panel{"environment", Icon::Sun} {}
    void draw(Editor& editor) override;

private:
    void looks(Editor& editor);      // a row: one to choose, over how many seconds, keep this one, run the day
    void keepLook(Editor& editor);   // the popup that asks for its name
    void choose(Editor& editor, const std::string& name);

    std::string m_search;
    double m_seconds = 0; // over which a chosen look comes
    std::string m_chosen; // look, as the row shows it
    std::string m_name;   // to keep one under
};

} // namespace editor
