#include "io/scene/shadow_ends.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace io {
namespace {

Shadows byHand(int cascades, std::array<float, 5> ends, float distance)
{
    return {.cascades = cascades, .distance = distance, .splits = Splits::Manual, .end1 = ends[0], .end2 = ends[1], .end3 = ends[2], .end4 = ends[3], .end5 = ends[4]};
}

std::string faultOf(const Shadows& shadows)
{
    const auto fault = endFault(shadows);
    return fault ? fault->key + ": " + fault->what : "";
}

TEST(ShadowEnds, OnlyThoseThatCountMustRise)
{
    EXPECT_EQ(faultOf({}), "");
    EXPECT_EQ(faultOf(byHand(4, {15, 45, 110, 9, 9}, 350)), "");
    EXPECT_EQ(faultOf(byHand(4, {15, 15, 110, 9, 9}, 350)), "end_2: 15 m must be beyond end_1, 15 m");
    EXPECT_EQ(faultOf(byHand(6, {15, 45, 110, 250, 600}, 350)), "distance: 350 m must be beyond end_5, 600 m");
    EXPECT_EQ(faultOf(byHand(1, {600, 45, 110, 250, 600}, 350)), "");
    Shadows practical = byHand(6, {5, 4, 3, 2, 1}, 350);
    practical.splits = Splits::Practical;
    EXPECT_EQ(faultOf(practical), "");
}

TEST(ShadowEnds, OneThatIsDraggedPushesTheOthers)
{
    Shadows shadows = byHand(4, {15, 45, 110, 9, 9}, 350);
    shadows.end1 = 200;
    pushEnds(shadows, "end_1");
    EXPECT_EQ(shadows, byHand(4, {200, 201, 202, 9, 9}, 350));
    shadows.end1 = 4000;
    pushEnds(shadows, "end_1");
    EXPECT_EQ(shadows, byHand(4, {347, 348, 349, 9, 9}, 350)) << "the distance stays";
    shadows.end3 = 1;
    pushEnds(shadows, "end_3");
    EXPECT_EQ(shadows, byHand(4, {1, 2, 3, 9, 9}, 350));
    shadows = byHand(4, {15, 45, 110, 9, 9}, 20);
    pushEnds(shadows, "distance");
    EXPECT_EQ(shadows, byHand(4, {15, 18, 19, 9, 9}, 20));
    shadows = byHand(6, {15, 45, 110, 200, 5000}, 5000);
    pushEnds(shadows, "end_5");
    EXPECT_EQ(faultOf(shadows), "");
    EXPECT_EQ(shadows.end5, 4999);
}

TEST(ShadowEnds, ThoseThatBeginToCountFindAPlace)
{
    Shadows shadows = byHand(6, {15, 45, 110, 250, 600}, 350);
    spreadEnds(shadows);
    EXPECT_EQ(faultOf(shadows), "");
    EXPECT_EQ(shadows.end4, 250);
    EXPECT_NEAR(shadows.end5, std::sqrt(250.0 * 350), 0.1);
    shadows = byHand(6, {900, 800, 700, 600, 500}, 100);
    spreadEnds(shadows);
    EXPECT_EQ(faultOf(shadows), "");
    EXPECT_GE(shadows.end1, 1);
    const Shadows before = shadows;
    spreadEnds(shadows);
    EXPECT_EQ(shadows, before);
}

} // namespace
} // namespace io
