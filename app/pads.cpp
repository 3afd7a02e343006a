#include "app/pads.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace app {
namespace {

constexpr const char* kButtons[]{"A",     "B",          "X",           "Y",  "left bumper", "right bumper", "back", "start",
                                 "guide", "left stick", "right stick", "up", "right",       "down",         "left"};
// Shares of the way around the rest where nothing counts: sticks seldom come back to the very middle.
constexpr float kStickRest = 0.2f, kTriggerRest = 0.08f;

void hold(play::Held& held, const std::string& name, double share)
{
    if (share <= 0) return;
    double& most = held["pad " + name];
    most = std::max(most, share);
}

float beyond(float share, float rest)
{
    return std::clamp((share - rest) / (1 - rest), 0.0f, 1.0f);
}

float finite(float value)
{
    return std::isfinite(value) ? std::clamp(value, -1.0f, 1.0f) : 0;
}

// By its distance from the middle and not by each axis, or a stick would snap to the axes as it leaves the middle.
void holdStick(play::Held& held, const std::string& name, const glm::vec2& at)
{
    const float far = glm::length(at);
    if (far <= kStickRest) return;
    const glm::vec2 share = at / far * beyond(far, kStickRest);
    hold(held, name + " -x", -share.x);
    hold(held, name + " +x", share.x);
    hold(held, name + " -y", -share.y);
    hold(held, name + " +y", share.y);
}

} // namespace

std::vector<std::string> padControls()
{
    std::vector<std::string> names;
    for (const char* button : kButtons)
        names.push_back(std::string{"pad "} + button);
    for (const char* stick : {"left", "right"})
        for (const char* way : {"-x", "+x", "-y", "+y"})
            names.push_back(std::string{"pad "} + stick + " " + way);
    for (const char* trigger : {"left trigger", "right trigger"})
        names.push_back(std::string{"pad "} + trigger);
    return names;
}

play::Held heldOn(std::span<const PadState> pads)
{
    play::Held held;
    for (const PadState& pad : pads) {
        for (std::size_t i = 0; i < pad.buttons.size(); ++i)
            if (pad.buttons[i]) hold(held, kButtons[i], 1);
        holdStick(held, "left", {finite(pad.axes[0]), finite(pad.axes[1])});
        holdStick(held, "right", {finite(pad.axes[2]), finite(pad.axes[3])});
        hold(held, "left trigger", beyond((finite(pad.axes[4]) + 1) / 2, kTriggerRest));
        hold(held, "right trigger", beyond((finite(pad.axes[5]) + 1) / 2, kTriggerRest));
    }
    return held;
}

void ReplayedPads::set(const std::string& name, double share)
{
    if (share > 0) m_held[name] = share;
    else m_held.erase(name);
}

} // namespace app
