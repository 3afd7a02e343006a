// Replay: recorded mouse and keys as text, one JSON object a line (docs/replay.md), and as the steps that are fed to
// ImGui. A step that touches the mouse or the keyboard takes a frame of its own, as a hand would.
#pragma once

#include "editor/key_names.h"
#include "io/base/result.h"

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace app {

// A pixel of the window, or a place relative to the middle of a widget that the UI map names.
struct Place {
    std::string panel, label; // both empty: a pixel; an empty panel: in whichever
    std::string kind;         // empty: any
    glm::dvec2 pixel{0};      // or the offset from the middle of the widget
    bool isWidget() const { return !panel.empty() || !label.empty() || !kind.empty(); }
};

namespace step {
struct Move {
    Place from, to;
    double share = 1; // of the way
};
struct Button {
    int button = 0; // left right middle
    bool down = true;
};
struct Wheel {
    glm::dvec2 by{0};
};
struct Key {
    int code = 0; // as GLFW counts keys, and editor::Key
    bool down = true;
};
struct Text {
    std::string text;
};
struct Pad { // a button or half of an axis
    std::string name; // as controls have it: "pad left -y"
    double share = 1; // how far; 0 lets go
};
struct Wait {
    int frames = 1;
};
struct Resize {
    glm::ivec2 size{0};
};
struct Shot {
    std::filesystem::path file; // empty: the next one that --shot names
};
struct UiMap {
    std::filesystem::path file;
};
} // namespace step

using Action = std::variant<step::Move, step::Button, step::Wheel, step::Key, step::Text, step::Pad, step::Wait, step::Resize,
                            step::Shot, step::UiMap>;
struct Step {
    Action action;
    int line = 0; // of the file, for what goes wrong
};

// `where` names the text in errors.
io::Result<std::vector<Step>> parseReplay(std::string_view text, const std::string& where);
io::Result<std::vector<Step>> readReplay(const std::filesystem::path& file);

using editor::keyNamed;
using editor::nameOfKey;

} // namespace app
