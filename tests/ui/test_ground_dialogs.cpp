// Generating and reshaping the ground as a person does it: a dialog, a picture of what will be, one step, undo.
#include "editor/text.h"
#include "tests/ui/support/rig.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

using namespace test;
using editor::Key;

namespace {

struct GroundDialog : ::testing::Test {
    Rig rig{crates(3)};
    void SetUp() override
    {
        rig.editor->workspace().bringToFront("terrain");
        rig.frame(3);
    }
    void open(const char* action)
    {
        rig.editor->actions().run(action);
        rig.frame(3);
    }
    void waitUntil(auto&& done)
    {
        for (int i = 0; i < 2000 && !done(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
            rig.frame();
        }
        EXPECT_TRUE(done());
    }
    void enter(const char* label, const char* text)
    {
        rig.hold(true);
        rig.click(label, "number", "dialog"); // Ctrl and click types
        rig.hold(false);
        rig.type(text);
        rig.key({.key = Key::Enter});
        rig.frame(2);
    }
    const io::HeightMap& ground() { return *rig.document().scene().heights(); }
    std::vector<std::string> names() { return rig.document().history().names(); }
    io::Value picture() { return rig.value("Preview", "picture"); }
};

TEST_F(GroundDialog, TheTerrainPanelAndTheMenuOpenIt)
{
    rig.click("Generate ground…", "button", "terrain");
    EXPECT_TRUE(rig.has("Generate ground", "title", "dialog"));
    rig.click("Cancel", "button", "dialog");
    EXPECT_FALSE(rig.editor->groundDialogs().any());
    rig.click("Tools", "menu");
    rig.click("Resize ground…", "menu item");
    rig.frame(3);
    EXPECT_TRUE(rig.has("Resize ground", "title", "dialog"));
    rig.key({.key = Key::Escape});
    EXPECT_FALSE(rig.editor->groundDialogs().any());
    EXPECT_TRUE(names().empty());
}

TEST_F(GroundDialog, ThePreviewFollowsTheRecipe)
{
    open("generate_ground");
    const io::Value first = picture();
    EXPECT_TRUE(first.asNumber());
    rig.frame(5);
    EXPECT_EQ(picture(), first);
    rig.click("Another landscape", "button", "dialog");
    EXPECT_NE(picture(), first);
}

TEST_F(GroundDialog, GeneratesInOneStepThatUndoTakesBack)
{
    const io::HeightMap before = ground();
    const io::Terrain terrain = rig.document().scene().terrain();
    const glm::dvec3 crate = rig.position(2);
    open("generate_ground");
    rig.click("Generate", "button", "dialog");
    rig.frame(3);
    EXPECT_FALSE(rig.editor->groundDialogs().any());
    EXPECT_EQ(names(), std::vector<std::string>{"Generate ground"});
    EXPECT_EQ(ground().size, before.size);
    EXPECT_EQ(ground().origin, before.origin); // over the old ground
    EXPECT_GT(ground().max - ground().min, 20);
    EXPECT_NEAR(rig.position(2).y, *ground().height(crate.x, crate.z), 1e-3); // the crate stands on it
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(ground(), before);
    EXPECT_EQ(rig.document().scene().terrain(), terrain);
    EXPECT_EQ(rig.position(2), crate);
}

TEST_F(GroundDialog, BesideTheWindowItCanBeStopped)
{
    rig.host.background = true;
    const io::HeightMap before = ground();
    open("generate_ground");
    waitUntil([this] { return picture().asNumber() != nullptr; });
    rig.click("Generate", "button", "dialog");
    rig.click("Cancel", "button", "dialog");
    waitUntil([this] { return !rig.editor->groundDialogs().working() || names().size() == 1; });
    if (names().empty()) { // it was not done before the click
        EXPECT_EQ(ground(), before);
    }
    const std::size_t done = names().size();
    open("generate_ground");
    waitUntil([this] { return !rig.editor->groundDialogs().working(); });
    rig.click("Generate", "button", "dialog");
    waitUntil([&] { return names().size() == done + 1; });
    rig.frame(2);
    EXPECT_FALSE(rig.editor->groundDialogs().any());
}

TEST_F(GroundDialog, ResamplesWhatIsThere)
{
    const io::HeightMap before = ground();
    open("reshape_ground");
    enter("Points, east-west", "33");
    rig.click("Apply", "button", "dialog");
    rig.frame(2);
    EXPECT_EQ(names(), std::vector<std::string>{"Resize ground"});
    EXPECT_EQ(ground().size, glm::ivec2(33, 33));
    EXPECT_EQ(ground().metresPerTexel, 2 * before.metresPerTexel);
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(ground(), before);
}

TEST_F(GroundDialog, WhatCannotBeDoneIsSaidAndChangesNothing)
{
    const io::HeightMap before = ground();
    open("reshape_ground");
    rig.click("What to do", "combo", "dialog");
    rig.click("Cut out or extend", "option");
    enter("To X", "-128");
    rig.click("Apply", "button", "dialog");
    EXPECT_TRUE(rig.editor->groundDialogs().any());
    EXPECT_EQ(ground(), before);
    EXPECT_TRUE(names().empty());
    rig.key({.key = Key::Escape});
    EXPECT_FALSE(rig.editor->groundDialogs().any());
}

} // namespace
