#include "io/scene/transform.h"

#include "io/scene/bounds.h"

#include <gtest/gtest.h>

#include <random>

namespace io {
namespace {

double angleBetween(const glm::dquat& a, const glm::dquat& b)
{
    return 2 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

TEST(Transform, YawTurnsCounterClockwiseSeenFromAbove)
{
    const glm::dvec3 ahead = orientation({0, 90, 0}) * glm::dvec3{0, 0, -1};
    EXPECT_NEAR(ahead.x, -1, 1e-12);
    EXPECT_NEAR(ahead.z, 0, 1e-12);
}

TEST(Transform, AnglesComeBackWithinTheirRange)
{
    for (const glm::vec3& degrees :
         {glm::vec3{10, 20, 30}, {-80, 170, -175}, {45, -120, 90}, {0, 180, 0}, {0, 0, -179}}) {
        const glm::vec3 back = eulerDegrees(orientation(degrees));
        EXPECT_NEAR(back.x, degrees.x, 1e-4);
        EXPECT_NEAR(back.y, degrees.y, 1e-4);
        EXPECT_NEAR(back.z, degrees.z, 1e-4);
    }
}

TEST(Transform, AnyAnglesGiveTheSameTurnBack)
{
    std::mt19937 random{7};
    std::uniform_real_distribution<float> angle{-720, 720};
    for (int i = 0; i < 2000; ++i) {
        const glm::dquat turn = orientation({angle(random), angle(random), angle(random)});
        EXPECT_LT(angleBetween(turn, orientation(eulerDegrees(turn))), 1e-5);
    }
}

TEST(Transform, LookingStraightUpOrDownLosesNothing)
{
    for (const float pitch : {90.0f, -90.0f, 89.9999f}) {
        const glm::dquat turn = orientation({pitch, 33, 21});
        EXPECT_LT(angleBetween(turn, orientation(eulerDegrees(turn))), 1e-3) << pitch;
    }
}

TEST(Transform, MatrixScalesThenTurnsThenMoves)
{
    const Transform transform{.position = {1, 2, 3}, .rotation = {0, 90, 0}, .scale = {2, 1, 1}};
    const glm::dvec3 moved{worldFromModel(transform) * glm::dvec4{1, 0, 0, 1}};
    EXPECT_NEAR(moved.x, 1, 1e-9);
    EXPECT_NEAR(moved.y, 2, 1e-9);
    EXPECT_NEAR(moved.z, 1, 1e-9);
    const glm::vec3 linear = linearPart(transform) * glm::vec3{1, 0, 0};
    EXPECT_NEAR(linear.z, -2, 1e-6);
}

TEST(Bounds, TransformedBoxHoldsAllCorners)
{
    Box box;
    EXPECT_TRUE(box.empty());
    box.add(glm::vec3{-1, 0, -1});
    box.add(glm::vec3{1, 2, 1});
    const WorldBox world = transformed(box, worldFromModel({.position = {1e6, 0, 0}, .rotation = {0, 45, 0}}));
    EXPECT_NEAR(world.size().x, 2 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(world.centre().x, 1e6, 1e-6);
    EXPECT_NEAR(world.max.y, 2, 1e-12);
}

} // namespace
} // namespace io
