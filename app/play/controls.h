// Controls: what keys, buttons and sticks make the player do: a project's own bindings, and for every other action the usual ones.
#pragma once

#include "app/play/walker.h"
#include "io/files/project.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace play {

constexpr double kTurnOfPixel = 0.15; // degrees that the head turns for a pixel of the pointer

// What is held, by the name that io::Control gives it, and how far: 1 for a key, up to 1 for a stick.
using Held = std::map<std::string, double, std::less<>>;

class Controls {
public:
    explicit Controls(std::span<const io::Control> bindings = {});
    Wish wish(const Held& held, const glm::dvec2& turned); // turned: degrees left and up since the last step
    bool pressed(std::string_view action) const; // it went down in the last step

    static std::vector<std::string> actions();

private:
    double amount(std::string_view action, const Held& held) const;
    std::map<std::string, std::vector<std::string>, std::less<>> m_by;
    std::set<std::string, std::less<>> m_down, m_pressed;
};

} // namespace play
