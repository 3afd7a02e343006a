// Statistics: where the time of a frame and the memory go.
#pragma once

#include "editor/frame_history.h"
#include "editor/panel.h"

namespace editor {

class StatisticsPanel final : public Panel {
public:
    StatisticsPanel() : Panel{"statistics", Icon::Chart} {}
    void draw(Editor& editor) override;

private:
    void figures(Editor& editor);
    void graph(const FrameHistory& frames) const;
    void passes(Editor& editor) const;
};

} // namespace editor
