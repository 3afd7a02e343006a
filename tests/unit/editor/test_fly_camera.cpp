#include "editor/fly_camera.h"
#include "editor/random.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

glm::dvec3 flown(double seconds, int frames)
{
    FlyCamera camera;
    camera.setCamera({.eye = {0, 0, 0}, .yaw = 30, .pitch = 10});
    for (int i = 0; i < frames; ++i)
        camera.fly({0.5, 0, 1}, false, seconds / frames);
    for (int i = 0; i < frames; ++i)
        camera.fly({}, false, seconds / frames);
    return camera.camera().eye;
}

} // namespace

TEST(FlyCamera, TheWayDoesNotDependOnTheFrameRate)
{
    EXPECT_LT(glm::distance(flown(1, 10), flown(1, 240)), 1e-6);
    EXPECT_NEAR(glm::length(flown(1, 60)), 10, 0.5); // 10 m/s for a second
}

TEST(FlyCamera, GlidesOutAndThenRests)
{
    FlyCamera camera;
    camera.fly({0, 0, 1}, true, 0.5);
    EXPECT_TRUE(camera.moving());
    for (int i = 0; i < 200; ++i)
        camera.fly({}, false, 0.016);
    EXPECT_FALSE(camera.moving());
}

TEST(FlyCamera, SpeedByTheWheel)
{
    FlyCamera camera;
    camera.changeSpeed(2);
    EXPECT_NEAR(camera.speed(), 14.4, 1e-9);
    camera.changeSpeed(1e9);
    EXPECT_LE(camera.speed(), FlyCamera::kMaxSpeed);
    camera.changeSpeed(-1e9);
    EXPECT_GE(camera.speed(), FlyCamera::kMinSpeed);
}

TEST(FlyCamera, LooksAsTheMouseMoves)
{
    FlyCamera camera;
    camera.look({100, 0});
    EXPECT_LT(camera.camera().yaw, 0); // right is clockwise from above
    camera.look({0, 100});
    EXPECT_LT(camera.camera().pitch, 0);
    camera.look({0, 1e7});
    EXPECT_GE(camera.camera().pitch, -90);
}

TEST(FlyCamera, FramesABoxSoThatAllOfItIsSeen)
{
    FlyCamera camera;
    camera.setCamera({.eye = {0, 0, 0}, .yaw = 77, .pitch = -20});
    io::WorldBox box;
    box.add(glm::dvec3{100, 0, 50});
    box.add(glm::dvec3{104, 12, 53});
    camera.frame(box, 16.0 / 9);
    for (int i = 0; i < 60; ++i)
        camera.update(1 / 60.0);
    EXPECT_FALSE(camera.moving());
    EXPECT_LT(glm::distance(camera.focus(), box.centre()), 1e-6);
    const View view{.camera = camera.camera()};
    for (int corner = 0; corner < 8; ++corner) {
        const auto pixel = project(view, {corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                                          corner & 4 ? box.max.z : box.min.z});
        ASSERT_TRUE(pixel.has_value());
        EXPECT_TRUE(pixel->x > 0 && pixel->x < view.size.x && pixel->y > 0 && pixel->y < view.size.y);
    }
    const glm::dvec3 eye = camera.camera().eye;
    camera.frame(io::WorldBox{}, 1);
    EXPECT_EQ(camera.camera().eye, eye);
}

TEST(FlyCamera, OrbitKeepsTheFocusAndPanKeepsItUnderTheCursor)
{
    FlyCamera camera;
    camera.setCamera({.eye = {5, 5, 5}, .yaw = 45, .pitch = -30});
    const glm::dvec3 focus = camera.focus();
    camera.orbit({130, -40});
    EXPECT_LT(glm::distance(camera.focus(), focus), 1e-6);

    const View before{.camera = camera.camera()};
    camera.pan({60, 25}, before.size.y);
    const View after{.camera = camera.camera()};
    const glm::dvec2 moved = *project(after, focus) - *project(before, focus);
    EXPECT_NEAR(moved.x, 60, 0.01);
    EXPECT_NEAR(moved.y, 25, 0.01);
    const glm::dvec3 ahead = camera.focus();
    camera.dolly(3);
    EXPECT_LT(glm::distance(camera.focus(), ahead), 1e-6);
}

TEST(FlyCamera, StaysFinite)
{
    Random random{1};
    FlyCamera camera;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec2 pixels{random.in(-1e5, 1e5), random.in(-1e5, 1e5)};
        switch (random.bits() % 7) {
        case 0:
            camera.look(pixels);
            break;
        case 1:
            camera.orbit(pixels);
            break;
        case 2:
            camera.pan(pixels * 1e6, int(random.bits() % 2));
            break;
        case 3:
            camera.dolly(random.in(-1e4, 1e4));
            break;
        case 4:
            camera.fly({random.in(-1, 1), random.in(-1, 1), 1}, true, random.in(-1, 1e4));
            break;
        case 5:
            camera.changeSpeed(random.in(-1e3, 1e3));
            break;
        default:
            camera.setCamera({.eye = {NAN, 1, INFINITY}, .yaw = INFINITY, .pitch = NAN, .fov = -5});
        }
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_TRUE(std::abs(camera.camera().eye[axis]) <= 1e7);
        ASSERT_TRUE(std::isfinite(camera.camera().yaw) && std::abs(camera.camera().pitch) <= 90);
        ASSERT_TRUE(std::isfinite(glm::length(camera.focus())));
    }
}
