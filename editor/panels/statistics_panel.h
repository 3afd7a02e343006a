// Statistics: where the time of a frame and the memory go.
#pragma once

#include "editor/panel.h"

#include <array>
#include <string>

namespace editor {

class StatisticsPanel final : public Panel {
public:
    StatisticsPanel() : Panel{"statistics", Icon::Chart} {}
    void draw(Editor& editor) override;

private:
    void figures(Editor& editor);
    void graph() const;
    void passes(Editor& editor) const;
    void note(double seconds);

    std::array<float, 120> m_frames{}; // ms, a ring
    std::size_t m_next = 0;
    float m_average = 0; // ms
};

} // namespace editor
