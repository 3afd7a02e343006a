// Environment: sun, sky, clouds, fog and shadows of the scene; every change is seen in the next frame.
#pragma once

#include "editor/panel.h"

#include <string>

namespace editor {

class EnvironmentPanel final : public Panel {
public:
    EnvironmentPanel() : Panel{"environment", Icon::Sun} {}
    void draw(Editor& editor) override;

private:
    std::string m_search;
};

} // namespace editor
