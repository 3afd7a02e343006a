// Console: the lines of the log, by level and by what is searched for.
#pragma once

#include "editor/panel.h"
#include "io/base/log.h"

#include <array>
#include <string>
#include <vector>

namespace editor {

class ConsolePanel final : public Panel {
public:
    ConsolePanel() : Panel{"console", Icon::Console} {}
    void draw(Editor& editor) override;

private:
    void takeNewLines();
    void header();
    void line(const io::log::Line& line) const;
    bool shown(const io::log::Line& line) const;
    void filter();

    std::vector<io::log::Line> m_lines;
    std::vector<std::size_t> m_shown;                      // places in m_lines
    std::array<bool, 4> m_levels{false, true, true, true}; // debug, info, warning, error
    std::array<std::size_t, 4> m_counts{};
    std::uint64_t m_last = 0;
    std::string m_search;
    bool m_toEnd = false;
};

} // namespace editor
