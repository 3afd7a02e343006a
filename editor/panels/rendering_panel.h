// Rendering: how this person's machine draws; nothing of it belongs to the world, so nothing of it is undone.
#pragma once

#include "editor/panel.h"

namespace editor {

class RenderingPanel final : public Panel {
public:
    RenderingPanel() : Panel{"rendering", Icon::Eye} {}
    void draw(Editor& editor) override;
};

} // namespace editor
