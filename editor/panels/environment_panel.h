// Environment: light and air of the scene, and the looks that can be put onto it; every change is seen in the next frame.
#pragma once

#include "editor/panel.h"
#include "editor/panels/look_row.h"

#include <string>

namespace editor {

class EnvironmentPanel final : public Panel {
public:
    EnvironmentPanel() : Panel{"environment", Icon::Sun} {}
    void draw(Editor& editor) override;

private:
    LookRow m_looks;
    std::string m_search;
};

} // namespace editor
