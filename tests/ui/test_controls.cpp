// The dialog in which the controls of play are chosen.
#include "io/files/usual_controls.h"
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

using namespace test;
using editor::Key;

namespace {

using Names = std::vector<std::string>;

Names of(Rig& rig, std::string_view action)
{
    return io::controlsOf(rig.document().project().controls, action);
}

struct Dialog : testing::Test {
    Rig rig;
    Dialog()
    {
        rig.editor->actions().run("controls");
        rig.frame(3);
    }
};

TEST_F(Dialog, AKeyTakesThePlaceOfAnother)
{
    EXPECT_TRUE(rig.has("Controls of play", "title", "dialog"));
    rig.click("W", "button", "dialog");
    EXPECT_TRUE(rig.editor->controlsDialog().listening());
    rig.key({.key = Key::X});
    EXPECT_EQ(of(rig, "forward"), (Names{"X", "Up", "pad left -y"}));
    EXPECT_EQ(rig.document().history().names(), Names{"Change controls"});
    EXPECT_TRUE(rig.document().modified());
    rig.document().undo();
    EXPECT_TRUE(rig.document().project().controls.empty());
    EXPECT_FALSE(rig.document().modified());
}

TEST_F(Dialog, ButtonsOfTheMouseAndOfPadsAreHeardToo)
{
    rig.click("Add a control: Jump", "button", "dialog");
    rig.click(rig.at("Controls of play", "title", "dialog"), 1);
    EXPECT_EQ(of(rig, "jump").back(), "mouse 2");
    rig.click("Add a control: Run", "button", "dialog");
    rig.host.pads = {{"pad right trigger", 0.3}}; // rests a little off its rest
    rig.frame(3);
    EXPECT_TRUE(rig.editor->controlsDialog().listening());
    rig.host.pads["pad right trigger"] = 0.9;
    rig.frame(2);
    EXPECT_FALSE(rig.editor->controlsDialog().listening()) << "what was touched before counts once it is meant";
    EXPECT_EQ(of(rig, "run").back(), "pad right trigger");
    EXPECT_TRUE(rig.has("Pad: right trigger", "button", "dialog"));
}

TEST_F(Dialog, WhatIsHeldAlreadyIsNotMeant)
{
    rig.host.pads = {{"pad A", 1}};
    rig.click("Add a control: Run", "button", "dialog");
    rig.frame(5);
    EXPECT_TRUE(rig.editor->controlsDialog().listening());
    rig.host.pads.clear();
    rig.frame(2);
    rig.host.pads = {{"pad A", 1}};
    rig.frame(2);
    EXPECT_EQ(of(rig, "run").back(), "pad A");
}

TEST_F(Dialog, EscapeLeavesAnActionAndThenTheDialog)
{
    rig.click("W", "button", "dialog");
    rig.key({.key = Key::Escape});
    rig.frame(2);
    EXPECT_TRUE(rig.has("Controls of play", "title", "dialog"));
    EXPECT_TRUE(rig.document().project().controls.empty());
    rig.key({.key = Key::Escape});
    rig.frame(2);
    EXPECT_FALSE(rig.editor->controlsDialog().any());
}

TEST_F(Dialog, WhatDoesTwoThingsIsShown)
{
    EXPECT_FALSE(rig.has("C does two things: Crouch and Jump", "label"));
    rig.click("Add a control: Jump", "button", "dialog");
    rig.key({.key = Key::C});
    rig.frame(2);
    EXPECT_TRUE(rig.has("C does two things: Crouch and Jump", "label"));
    rig.click("Remove C from Crouch", "button", "dialog");
    EXPECT_FALSE(rig.has("C does two things: Crouch and Jump", "label"));
    EXPECT_EQ(of(rig, "crouch"), (Names{"Ctrl", "pad B"}));
}

TEST_F(Dialog, AnActionCanBeTakenAwayAndComesBack)
{
    for (const char* name : {"F", "Pad: back"})
        rig.click("Remove " + std::string{name} + " from Fly or walk", "button", "dialog");
    EXPECT_TRUE(of(rig, "fly").empty());
    rig.click("Back to the usual: Fly or walk", "button", "dialog");
    EXPECT_EQ(of(rig, "fly"), io::usualControls("fly"));
    EXPECT_TRUE(rig.document().project().controls.empty());
    rig.click("Remove F from Fly or walk", "button", "dialog");
    rig.click("All back to the usual", "button", "dialog");
    EXPECT_TRUE(rig.document().project().controls.empty());
}

TEST(Controls, AreSavedWithTheProject)
{
    const Folder folder;
    const std::filesystem::path path = folder.path() / "small";
    makeSmallWorld(path);
    {
        Rig rig{nullptr};
        ASSERT_TRUE(rig.editor->open(path));
        rig.editor->actions().run("controls");
        rig.frame(3);
        rig.click("Remove F from Fly or walk", "button", "dialog");
        rig.click("Remove Pad: back from Fly or walk", "button", "dialog");
        rig.click("Close", "button", "dialog");
        ASSERT_TRUE(rig.editor->save());
    }
    Rig again{nullptr};
    ASSERT_TRUE(again.editor->open(path));
    EXPECT_TRUE(of(again, "fly").empty());
    EXPECT_EQ(of(again, "jump"), io::usualControls("jump"));
}

} // namespace
