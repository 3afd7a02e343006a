#include "editor/camera_paths.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

io::CameraPath three()
{
    io::CameraPath path{.name = "fly"};
    for (const double x : {0.0, 8.0, 40.0})
        addKey(path, {.eye = {x, 2, 0}});
    return path;
}

TEST(CameraPaths, KeysComeAsLateAsTheirWayIsLong)
{
    const io::CameraPath path = three();
    EXPECT_DOUBLE_EQ(path.keys[1].time, 1);
    EXPECT_DOUBLE_EQ(path.keys[2].time, 5);
    io::CameraPath same = path;
    addKey(same, {.eye = {40, 2, 0}});
    EXPECT_GT(same.keys[3].time, same.keys[2].time);
}

TEST(CameraPaths, TimesGoOnRisingWhateverIsTyped)
{
    io::CameraPath path = three();
    setTime(path, 1, -50);
    EXPECT_LT(path.keys[0].time, path.keys[1].time);
    EXPECT_DOUBLE_EQ(path.keys[2].time - path.keys[1].time, 4); // what follows came along
    setTime(path, 2, 20);
    EXPECT_DOUBLE_EQ(path.keys[2].time, 20);
    setTime(path, 7, 3); // there is no such key
}

TEST(CameraPaths, DurationStretchesAndSpeedEvensOut)
{
    io::CameraPath path = three();
    setDuration(path, 10);
    EXPECT_DOUBLE_EQ(io::duration(path), 10);
    EXPECT_DOUBLE_EQ(path.keys[1].time, 2);
    setSpeed(path, 4);
    for (std::size_t leg = 0; leg < 2; ++leg)
        EXPECT_NEAR(io::length(path, leg) / (path.keys[leg + 1].time - path.keys[leg].time), 4, 1e-6);
    setDuration(path, 0);
    EXPECT_GT(path.keys[1].time, path.keys[0].time);
    io::CameraPath none;
    setDuration(none, 3);
    setSpeed(none, 3);
    EXPECT_TRUE(none.keys.empty());
}

} // namespace
