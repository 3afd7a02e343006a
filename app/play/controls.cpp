#include "app/play/controls.h"

#include "io/files/usual_controls.h"

#include <algorithm>

namespace play {
namespace {

constexpr double kTurn = 150; // degrees a second, of a stick pushed all the way
constexpr double kHalf = 0.5; // from here on a stick counts as pressed

} // namespace

Controls::Controls(std::span<const io::Control> bindings)
{
    for (const std::string_view action : io::playActions())
        m_by.emplace(action, io::controlsOf(bindings, action));
}

std::vector<std::string> Controls::actions()
{
    return {io::playActions().begin(), io::playActions().end()};
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
    for (const auto& [action, by] : m_by) {
        const bool down = amount(action, held) >= kHalf;
        if (down && !m_down.contains(action)) m_pressed.insert(action);
        if (down) m_down.insert(action);
        else m_down.erase(action);
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
