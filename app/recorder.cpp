#include "app/recorder.h"

#include "app/replay.h"
#include "io/files/json.h"

#include <GLFW/glfw3.h>
#include <cmath>
#include <fmt/format.h>

namespace app {
namespace {

constexpr const char* kButtons[] = {"left", "right", "middle"};

std::string utf8(ImWchar letter)
{
    const auto c = unsigned(letter);
    if (c < 0x80) return {char(c)};
    if (c < 0x800) return {char(0xc0 | c >> 6), char(0x80 | (c & 0x3f))};
    return {char(0xe0 | c >> 12), char(0x80 | (c >> 6 & 0x3f)), char(0x80 | (c & 0x3f))};
}

bool isModifier(int code)
{
    return code >= GLFW_KEY_LEFT_SHIFT && code <= GLFW_KEY_RIGHT_SUPER;
}

} // namespace

void Recorder::keys(const ImGuiIO& io, bool down, bool modifiers)
{
    for (int code = 0; code < 512; ++code) {
        if (io.KeysDown[code] == m_keys[code] || io.KeysDown[code] != down || isModifier(code) != modifiers) continue;
        m_keys[code] = down;
        const std::string name = nameOfKey(code);
        if (!name.empty()) write(fmt::format("{{\"{}\": \"{}\"}}", down ? "keydown" : "keyup", name));
    }
}

void Recorder::write(const std::string& line)
{
    if (m_idle > 1) m_file << "{\"wait\": " << m_idle - 1 << "}\n";
    m_idle = 0;
    m_file << line << '\n' << std::flush;
}

void Recorder::frame(const ImGuiIO& io)
{
    ++m_idle;
    const bool moved = io.MousePos.x != m_mouse.x || io.MousePos.y != m_mouse.y;
    if (moved && ImGui::IsMousePosValid(&io.MousePos))
        write(fmt::format("{{\"move\": [{}, {}]}}", std::round(io.MousePos.x * io.DisplayFramebufferScale.x),
                          std::round(io.MousePos.y * io.DisplayFramebufferScale.y)));
    m_mouse = io.MousePos;
    for (int i = 0; i < 3; ++i)
        if (io.MouseDown[i] != m_buttons[i]) {
            m_buttons[i] = io.MouseDown[i];
            write(fmt::format("{{\"{}\": \"{}\"}}", m_buttons[i] ? "press" : "release", kButtons[i]));
        }
    // Ctrl and its like go down before the other keys of their frame and up after them, so that a chord stays one.
    keys(io, true, true);
    keys(io, true, false);
    keys(io, false, false);
    keys(io, false, true);
    if (io.MouseWheel != 0 || io.MouseWheelH != 0)
        write(fmt::format("{{\"wheel\": [{}, {}]}}", io.MouseWheelH, io.MouseWheel));
    std::string typed;
    for (const ImWchar letter : io.InputQueueCharacters)
        typed += utf8(letter);
    if (!typed.empty()) write(io::writeJson(io::Value::Object{{"text", typed}}));
}

} // namespace app
