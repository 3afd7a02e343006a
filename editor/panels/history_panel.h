// History: the steps that were done; a click goes back or forward to one.
#pragma once

#include "editor/panel.h"

#include <cstddef>

namespace editor {

class HistoryPanel final : public Panel {
public:
    HistoryPanel() : Panel{"history", Icon::Clock} {}
    void draw(Editor& editor) override;

private:
    std::size_t m_seen = 0; // position that was last scrolled to
};

} // namespace editor
