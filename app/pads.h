// Game pads: what is held on them, by the names that controls give it ("pad A", "pad left -y"). Where it comes from, a window or
// a replay, is an interface, so that it can be tested without a device.
#pragma once

#include "app/play/controls.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace app {

class Pads {
public:
    virtual ~Pads() = default;
    virtual play::Held held() const = 0; // on all that are plugged in; one that was pulled out holds nothing
};

// One pad as GLFW maps it: buttons in the order of GLFW_GAMEPAD_BUTTON_*, sticks -1..1 with y downwards, triggers -1 at rest.
struct PadState {
    std::array<bool, 15> buttons{};
    std::array<float, 6> axes{0, 0, 0, 0, -1, -1};
};

std::vector<std::string> padControls(); // the names of all that may be held
play::Held heldOn(std::span<const PadState> pads);

// What a replay says.
class ReplayedPads final : public Pads {
public:
    void set(const std::string& name, double share);
    play::Held held() const override { return m_held; }

private:
    play::Held m_held;
};

} // namespace app
