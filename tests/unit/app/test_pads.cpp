// What a game pad holds, without one.
#include "app/pads.h"

#include <gtest/gtest.h>
#include <limits>

namespace app {
namespace {

double at(const play::Held& held, const std::string& name)
{
    const auto found = held.find(name);
    return found == held.end() ? 0 : found->second;
}

TEST(Pads, AtRestNothingIsHeld)
{
    PadState worn; // its sticks come back to near the middle
    worn.axes = {0.1f, -0.12f, 0.15f, 0.05f, -0.95f, -1};
    EXPECT_TRUE(heldOn({&worn, 1}).empty());
}

TEST(Pads, SticksCountFromTheirRestOnAndInBothDirections)
{
    PadState pad;
    pad.axes[0] = -0.6f;
    pad.axes[1] = 1;
    pad.axes[2] = 0.6f;
    const play::Held held = heldOn({&pad, 1});
    EXPECT_NEAR(at(held, "pad right +x"), 0.5, 1e-6); // half of the way from the rest to the end
    EXPECT_EQ(at(held, "pad right -x"), 0);
    EXPECT_NEAR(at(held, "pad left -x") / at(held, "pad left +y"), 0.6, 1e-6) << "the direction is the stick's";
    EXPECT_GT(at(held, "pad left +y"), 0.8);
}

TEST(Pads, ButtonsAndTriggersHaveTheirNames)
{
    PadState pad;
    pad.buttons[0] = pad.buttons[9] = pad.buttons[11] = true;
    pad.axes[5] = 1;
    EXPECT_EQ(heldOn({&pad, 1}), (play::Held{{"pad A", 1}, {"pad left stick", 1}, {"pad up", 1}, {"pad right trigger", 1}}));
}

TEST(Pads, OfTwoTheFartherCountsAndOneThatIsGoneLetsGo)
{
    PadState pads[2];
    pads[0].axes[0] = 0.6f;
    pads[1].axes[0] = 1;
    EXPECT_EQ(at(heldOn(pads), "pad left +x"), 1);
    EXPECT_NEAR(at(heldOn({pads, 1}), "pad left +x"), 0.5, 1e-6);
    EXPECT_TRUE(heldOn({}).empty());
}

TEST(Pads, WhatADriverMakesUpDoesNoHarm)
{
    PadState pad;
    pad.axes = {std::numeric_limits<float>::quiet_NaN(), 40, std::numeric_limits<float>::infinity(), 0, 9, std::numeric_limits<float>::quiet_NaN()};
    for (const auto& [name, share] : heldOn({&pad, 1}))
        EXPECT_TRUE(share > 0 && share <= 1.000001) << name << " " << share;
}

TEST(Pads, MakeThePlayerWalkAndTurn)
{
    PadState pad;
    pad.axes[1] = -1;
    pad.axes[2] = 1;
    play::Controls controls;
    const play::Wish wish = controls.wish(heldOn({&pad, 1}), {});
    EXPECT_NEAR(wish.move.y, 1, 1e-6);
    EXPECT_LT(wish.yaw * 60, -100); // degrees a second, to the right
    EXPECT_EQ(controls.wish(heldOn({}), {}).move, glm::dvec2(0)) << "pulled out, it lets go of everything";
}

} // namespace
} // namespace app
