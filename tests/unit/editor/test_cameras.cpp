#include "editor/cameras.h"

#include <gtest/gtest.h>

namespace editor {
namespace {

TEST(Cameras, AreMadeWhenFirstAskedForAndTheSameOnesAfter)
{
    Cameras cameras;
    EXPECT_EQ(cameras.find("play"), nullptr);
    io::Camera& play = cameras.named("play");
    play.eye = {1, 2, 3};
    for (const char* other : {"edit", "a", "z", "player"})
        cameras.named(other).eye = {9, 9, 9};
    EXPECT_EQ(&cameras.named("play"), &play);
    EXPECT_EQ(cameras.find("play"), &play);
    EXPECT_EQ(play.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(play.name, "play");
    EXPECT_EQ(&cameras.look("play", {.name = "of the world", .eye = {4, 5, 6}}), &play);
    EXPECT_EQ(play.eye, glm::dvec3(4, 5, 6));
    EXPECT_EQ(play.name, "play"); // names stay unique
    EXPECT_EQ(cameras.names(), (std::vector<std::string>{"a", "edit", "play", "player", "z"}));
    cameras.forget("play");
    EXPECT_EQ(cameras.find("play"), nullptr);
    EXPECT_EQ(cameras.named("play").eye, io::Camera{}.eye);
}

} // namespace
} // namespace editor
