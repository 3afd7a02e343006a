// The keyboard as the host feeds it: ImGuiIO::KeysDown is indexed by GLFW's key codes, in the window and in a replay.
#pragma once

#include <imgui.h>
#include <string>

namespace editor {

// clang-format off
enum class Key : int {
    None = 0,
    Space = 32, Digit0 = 48, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
    A = 65, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    LeftBracket = 91, RightBracket = 93,
    Escape = 256, Enter, Tab, Backspace, Insert, Delete, Right, Left, Down, Up, PageUp, PageDown, Home, End,
    F1 = 290, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
};
// clang-format on

inline bool down(Key key)
{
    return key != Key::None && ImGui::IsKeyDown(int(key));
}
inline bool pressed(Key key, bool repeat = false)
{
    return key != Key::None && ImGui::IsKeyPressed(int(key), repeat);
}

// A key with its modifiers: what a shortcut is.
struct Chord {
    Key key = Key::None;
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const Chord&) const = default;
};

constexpr Chord ctrl(Key key)
{
    return {.key = key, .ctrl = true};
}
constexpr Chord ctrlShift(Key key)
{
    return {.key = key, .ctrl = true, .shift = true};
}

bool pressed(const Chord& chord, bool repeat = false); // with exactly these modifiers
std::string name(const Chord& chord);                  // "Ctrl+Shift+Z" in the language of the window

} // namespace editor
