// StepClock: cuts frames of any length into steps of one length, so that a walk is the same at 10 and at 200 frames a second.
#pragma once

#include "app/play/walker.h"

#include <algorithm>
#include <utility>

namespace play {

class StepClock {
public:
    // Calls step(turned) for each step that is due by now. What the mouse turned (degrees) goes into the first of them: a short frame
    // may have none, and it waits for the next.
    template <class Step> void pass(double seconds, const glm::dvec2& turned, Step&& step)
    {
        constexpr double kMostBehind = 0.25; // s of steps that one frame makes up for
        m_turned += turned;
        m_rest = std::min(m_rest + seconds, kMostBehind);
        for (; m_rest >= kStep; m_rest -= kStep)
            step(std::exchange(m_turned, {0, 0}));
    }
    double share() const { return m_rest / kStep; } // 0..1: how far the frame lies between the last two steps

private:
    double m_rest = 0; // s
    glm::dvec2 m_turned{0};
};

} // namespace play
