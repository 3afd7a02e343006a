// Keys: the keyboard's keys by GLFW's numbers, as the window hands them to ImGui, and chords of them for actions.
#pragma once

#include <imgui.h>
#include <string>

namespace editor {

enum class Key : int {
    None = 0,
    Space = 32,
    A = 65, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    Escape = 256, Enter = 257, Tab = 258, Backspace = 259, Insert = 260, Delete = 261,
    Right = 262, Left = 263, Down = 264, Up = 265, PageUp = 266, PageDown = 267, Home = 268, End = 269,
    F1 = 290, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
};

struct Chord {
    Key key = Key::None;
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const Chord&) const = default;
};

inline bool down(Key key)
{
    return key != Key::None && ImGui::IsKeyDown(int(key));
}
inline bool pressed(Key key, bool repeat = false)
{
    return key != Key::None && ImGui::IsKeyPressed(int(key), repeat);
}
bool pressed(const Chord& chord, bool repeat = false); // with exactly these modifiers
std::string name(const Chord& chord);                  // in the language of the window

} // namespace editor
