// The controls of play: what does each of the player's actions in this project. A click on one listens for the key, button or stick
// that is to take its place; what two actions share is shown. Each change is a step of undo, saved with the project.
#pragma once

#include "editor/held_controls.h"

#include <optional>
#include <string>
#include <vector>

namespace editor {

class Editor;

class ControlsDialog {
public:
    void show() { m_open = true; }
    void draw(Editor& editor);
    bool any() const { return m_open; }
    bool listening() const { return m_listening.has_value(); } // pads are asked in each frame

private:
    struct Listening {
        std::string action;
        std::size_t place = 0; // of its controls; beyond the last: one more
        Held before;           // what was held then does not count until it is let go
    };
    void listen(Editor& editor, std::string action, std::size_t place);
    void takeHeld(Editor& editor);
    void row(Editor& editor, std::string_view action);
    void control(Editor& editor, std::string_view action, const std::vector<std::string>& by, std::size_t place);
    void sharedOnes(Editor& editor);
    void close();

    bool m_open = false;
    std::optional<Listening> m_listening;
};

} // namespace editor
