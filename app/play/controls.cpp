#include "app/play/controls.h"

#include <algorithm>
#include <array>

namespace play {
namespace {

struct Usual {
    const char* action;
    std::array<const char*, 3> by;
};
constexpr Usual kUsual[]{{"forward", {"W", "Up", "pad left -y"}}, {"back", {"S", "Down", "pad left +y"}},
                         {"left", {"A", "Left", "pad left -x"}},  {"right", {"D", "Right", "pad left +x"}},
                         {"look_left", {"pad right -x"}},         {"look_right", {"pad right +x"}},
                         {"look_up", {"pad right -y"}},           {"look_down", {"pad right +y"}},
                         {"run", {"Shift", "pad left stick"}},    {"crouch", {"Ctrl", "C", "pad B"}},
                         {"jump", {"Space", "pad A"}},            {"fly", {"F", "pad back"}},
                         {"eye", {"V", "pad Y"}}};
constexpr double kTurn = 150; // degrees a second, of a stick pushed all the way
constexpr double kHalf = 0.5; // from here on a stick counts as pressed

} // namespace

Controls::Controls(std::span<const io::Control> bindings)
{
    for (const io::Control& control : bindings)
        m_by[control.action].push_back(control.by);
    for (const Usual& usual : kUsual)
        if (!m_by.contains(usual.action))
            for (const char* by : usual.by)
                if (by) m_by[usual.action].push_back(by);
}

std::vector<std::string> Controls::actions()
{
    std::vector<std::string> names;
    for (const Usual& usual : kUsual)
        names.emplace_back(usual.action);
    return names;
}

double Controls::amount(std::string_view action, const Held& held) const
{
    double most = 0;
    if (const auto by = m_by.find(action); by != m_by.end())
        for (const std::string& name : by->second)
            if (const auto found = held.find(name); found != held.end()) most = std::max(most, std::clamp(found->second, 0.0, 1.0));
    return most;
}

bool Controls::pressed(std::string_view action) const
{
    return m_pressed.contains(action);
}

Wish Controls::wish(const Held& held, const glm::dvec2& turned)
{
    m_pressed.clear();
    for (const Usual& usual : kUsual) {
        const bool down = amount(usual.action, held) >= kHalf;
        if (down && !m_down.contains(usual.action)) m_pressed.insert(usual.action);
        if (down) m_down.insert(usual.action);
        else m_down.erase(usual.action);
    }
    const auto between = [&](std::string_view more, std::string_view less) { return amount(more, held) - amount(less, held); };
    return {.move = {between("right", "left"), between("forward", "back")},
            .yaw = turned.x + between("look_left", "look_right") * kTurn * kStep,
            .pitch = turned.y + between("look_up", "look_down") * kTurn * kStep,
            .run = m_down.contains("run"),
            .crouch = m_down.contains("crouch"),
            .jump = m_down.contains("jump"),
            .fly = pressed("fly")};
}

} // namespace play
