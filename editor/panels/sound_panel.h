// Sound: how loud a person hears worlds, and whether the open one sounds while it is edited.
#pragma once

#include "editor/panel.h"

namespace editor {

class SoundPanel final : public Panel {
public:
    SoundPanel() : Panel{"sound", Icon::Speaker} {}
    void draw(Editor& editor) override;
};

} // namespace editor
