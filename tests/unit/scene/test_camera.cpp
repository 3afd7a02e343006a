#include "io/scene/camera.h"

#include <gtest/gtest.h>

namespace io {
namespace {

CameraPath path()
{
    CameraPath path;
    path.keys = {{.time = 1, .eye = {0, 0, 0}, .yaw = 350, .fov = 60},
                 {.time = 3, .eye = {10, 0, 0}, .yaw = 10, .fov = 60},
                 {.time = 4, .eye = {10, 5, 0}, .yaw = 30, .fov = 40}};
    return path;
}

TEST(Camera, LooksAlongMinusZAtYawZeroAndTurnsLeft)
{
    EXPECT_NEAR(forward(Camera{}).z, -1, 1e-12);
    EXPECT_NEAR(forward(Camera{.yaw = 90}).x, -1, 1e-12);
    EXPECT_NEAR(forward(Camera{.pitch = 90}).y, 1, 1e-12);
}

TEST(CameraPath, PassesThroughItsKeys)
{
    const CameraPath p = path();
    EXPECT_EQ(duration(p), 3);
    EXPECT_NEAR(sample(p, 0).eye.x, 0, 1e-12);
    EXPECT_NEAR(sample(p, 2).eye.x, 10, 1e-12);
    EXPECT_NEAR(sample(p, 2).fov, 60, 1e-5);
    EXPECT_NEAR(sample(p, 3).eye.y, 5, 1e-12);
}

TEST(CameraPath, TurnsTheShortWayRound)
{
    const float yaw = sample(path(), 1).yaw;
    EXPECT_NEAR(std::remainder(yaw, 360.0f), 0, 3); // between 350 and 10, not through 180
}

TEST(CameraPath, StaysAtItsEndsOutsideItsTime)
{
    EXPECT_EQ(sample(path(), -5).eye, sample(path(), 0).eye);
    EXPECT_EQ(sample(path(), 99).eye, sample(path(), 3).eye);
}

TEST(CameraPath, LooksAtItsTargetAllAlong)
{
    CameraPath p = path();
    p.lookAt = true;
    p.target = {3, 40, -7};
    for (double t = 0; t <= 3; t += 0.25) {
        const Camera c = sample(p, t);
        EXPECT_NEAR(glm::dot(forward(c), glm::normalize(p.target - c.eye)), 1, 1e-9) << t;
    }
    p.target = sample(p, 1).eye; // it stands on it
    EXPECT_TRUE(std::isfinite(sample(p, 1).yaw));
}

TEST(CameraPath, ItsLengthIsThatOfItsLegs)
{
    CameraPath line;
    line.keys = {{.time = 0, .eye = {0, 0, 0}}, {.time = 1, .eye = {10, 0, 0}}, {.time = 7, .eye = {20, 0, 0}}};
    EXPECT_NEAR(length(line, 0), 10, 1e-9);
    EXPECT_NEAR(length(line), 20, 1e-9);
    EXPECT_EQ(length(line, 2), 0);
    EXPECT_GE(length(path()), 15 - 1e-9); // no way is shorter than the straight one
}

TEST(CameraPath, WithoutOrWithOneKeyIsStill)
{
    EXPECT_EQ(duration(CameraPath{}), 0);
    EXPECT_EQ(sample(CameraPath{}, 1).fov, Camera{}.fov);
    CameraPath one;
    one.keys = {{.time = 2, .eye = {1, 2, 3}}};
    EXPECT_EQ(sample(one, 7).eye, glm::dvec3(1, 2, 3));
}

} // namespace
} // namespace io
