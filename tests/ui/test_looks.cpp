// Looks of the day as a person chooses them: at once, over some seconds, one of their own; and the day that runs.
#include "io/files/kept_looks.h"
#include "io/scene/environment_presets.h"
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/ui/support/rig.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

using namespace test;
using editor::Key;

namespace {

namespace fs = std::filesystem;

struct Looks : ::testing::Test {
    std::string before;
    fs::path folder = fs::path{testing::TempDir()} / "wold_looks";
    void SetUp() override
    {
        fs::remove_all(folder);
        if (const char* now = std::getenv("XDG_CONFIG_HOME")) before = now;
        setenv("XDG_CONFIG_HOME", folder.c_str(), 1); // where a person's own are kept
        rig.editor->workspace().bringToFront("environment");
        rig.frame(3);
    }
    void TearDown() override
    {
        setenv("XDG_CONFIG_HOME", before.c_str(), 1);
        fs::remove_all(folder);
    }
    void choose(const char* look)
    {
        rig.click("Look", "combo", "environment");
        rig.frame(2);
        rig.click(look);
        rig.frame(2);
    }
    void over(const char* seconds)
    {
        type("Over", seconds);
    }
    void type(const char* field, const char* text)
    {
        rig.hold(true);
        rig.click(field, "number", "environment");
        rig.hold(false);
        rig.type(text);
        rig.key({.key = Key::Enter});
        rig.frame(2);
    }
    std::string chosen() { return *rig.value("Look", "combo").asString(); }
    const io::Environment& own() { return rig.document().scene().environment(); }
    std::size_t steps() { return rig.document().history().position(); }
    Rig rig{crates(3)};
};

TEST_F(Looks, OneIsChosenInOneStep)
{
    const io::Environment before = own();
    choose("Storm");
    EXPECT_TRUE(own() == io::withPreset(before, io::Preset::Storm));
    EXPECT_EQ(steps(), 1u);
    rig.key(editor::ctrl(Key::Z));
    rig.frame(2);
    EXPECT_TRUE(own() == before);
}

TEST_F(Looks, OneComesOverSomeSecondsAndIsAStepThen)
{
    const io::Environment before = own();
    over("2");
    choose("Overcast");
    EXPECT_TRUE(own() == before);
    rig.pass(0.2);
    const auto shown = rig.editor->live().shown(own());
    ASSERT_TRUE(shown);
    EXPECT_GT(shown->clouds.coverage, before.clouds.coverage);
    EXPECT_LT(shown->clouds.coverage, 0.9f);
    for (int i = 0; i < 20; ++i)
        rig.pass(0.2);
    EXPECT_FALSE(rig.editor->live().turning());
    EXPECT_TRUE(own() == io::withPreset(before, io::Preset::Overcast));
    EXPECT_EQ(steps(), 1u);
}

TEST_F(Looks, TheirOwnAreKeptAndRemoved)
{
    choose("Dusk");
    rig.click("Keep this look", "button", "environment");
    rig.frame(2);
    rig.click("Name of the look");
    rig.type("Mine");
    rig.frame(2);
    rig.click("Keep", "button");
    rig.frame(2);
    ASSERT_EQ(io::KeptLooks{io::looksFolder()}.names(), std::vector<std::string>{"Mine"});
    choose("Noon");
    choose("Mine");
    EXPECT_TRUE(own() == io::withPreset({}, io::Preset::Dusk));
}

TEST_F(Looks, TheDayRunsAndStopsAsOneStep)
{
    const io::Environment before = own();
    rig.click("Run the day", "button", "environment");
    rig.pass(0.2);
    EXPECT_TRUE(own() == before) << "the scene keeps its hour while it runs";
    ASSERT_TRUE(rig.editor->live().shown(own()));
    EXPECT_GT(rig.editor->live().shown(own())->time, before.time);
    rig.pass(0.2);
    rig.click("Run the day", "button", "environment");
    EXPECT_FALSE(rig.editor->live().moves());
    EXPECT_GT(own().time, before.time);
    EXPECT_EQ(steps(), 1u);
}

TEST_F(Looks, WhatIsEditedWhileTheDayRunsIsWhatIsSeen)
{
    const io::Environment before = own();
    rig.click("Run the day", "button", "environment");
    rig.pass(0.2);
    rig.pass(0.2);
    type("Latitude", "30");
    EXPECT_EQ(own().latitude, 30);
    EXPECT_EQ(own().time, before.time) << "the hour is no part of the step";
    EXPECT_TRUE(rig.editor->live().dayRuns());
    const float then = rig.editor->live().shown(own())->time;
    EXPECT_GT(then, before.time);
    rig.key(editor::ctrl(Key::Z));
    rig.frame(2);
    EXPECT_TRUE(own() == before);
    EXPECT_GE(rig.editor->live().shown(own())->time, then) << "the clock goes on";
    type("Time of day", "15");
    EXPECT_NEAR(rig.editor->live().shown(own())->time, 15, 0.1);
}

TEST_F(Looks, UndoWhileOneComesTakesThatBackAlone)
{
    choose("Storm");
    const io::Environment before = own();
    over("60");
    choose("Noon");
    rig.pass(0.2);
    ASSERT_TRUE(rig.editor->live().turning());
    rig.key(editor::ctrl(Key::Z));
    rig.frame(2);
    EXPECT_FALSE(rig.editor->live().turning());
    EXPECT_TRUE(own() == before);
    EXPECT_EQ(steps(), 1u);
    choose("Noon");
    rig.key({.key = Key::Escape});
    rig.frame(2);
    EXPECT_FALSE(rig.editor->live().turning());
    EXPECT_EQ(steps(), 1u);
}

TEST_F(Looks, OneThatComesIsUnsavedAndSavingBringsItToItsEnd)
{
    const Folder project;
    makeSmallWorld(project.path() / "small");
    ASSERT_TRUE(rig.editor->open(project.path() / "small"));
    rig.frame(3);
    const io::Environment before = own();
    over("60");
    choose("Overcast");
    rig.pass(0.2);
    EXPECT_NE(rig.editor->title().find('*'), std::string::npos);
    rig.key(editor::ctrl(Key::S));
    rig.frame(2);
    EXPECT_FALSE(rig.editor->live().turning());
    EXPECT_TRUE(own() == io::withPreset(before, io::Preset::Overcast));
    EXPECT_EQ(rig.editor->title().find('*'), std::string::npos);
    rig.click("Run the day", "button", "environment");
    rig.pass(0.2);
    rig.key(editor::ctrl(Key::S));
    rig.frame(2);
    EXPECT_TRUE(rig.has("Saved as before the day began to run: its hour becomes the scene's when it stops", "toast"));
}

TEST_F(Looks, FaultsInOnesOwnAreSaid)
{
    fs::create_directories(io::looksFolder());
    const std::string file = (io::looksFolder() / "Mine.json").string();
    std::ofstream{file} << "{\"format\": \"wold-environment\", \"version\": 1,\n\"fog\": {\"density\": -5}}";
    choose("Mine");
    EXPECT_TRUE(rig.has(file + ":2: fog.density: -5 is outside 0 to 0.1 1/m", "toast"));
}

TEST_F(Looks, TheRowNamesOneOnlyWhileTheSceneHasIt)
{
    choose("Dusk");
    EXPECT_EQ(chosen(), "Dusk");
    rig.key(editor::ctrl(Key::Z));
    rig.frame(2);
    EXPECT_NE(chosen(), "Dusk");
    rig.key(editor::ctrl(Key::Y));
    rig.frame(2);
    EXPECT_EQ(chosen(), "Dusk");
}

TEST_F(Looks, KeepingOneIsTypedAndEntered)
{
    const auto keep = [&](const char* name) {
        rig.click("Keep this look", "button", "environment");
        rig.frame(2);
        rig.type(name); // the field has the keyboard at once
        rig.frame(2);
        rig.key({.key = Key::Enter});
        rig.frame(2);
    };
    choose("Dusk");
    keep("Mine");
    const io::KeptLooks kept{io::looksFolder()};
    ASSERT_EQ(kept.names(), std::vector<std::string>{"Mine"});
    choose("Noon");
    rig.click("Keep this look", "button", "environment");
    rig.frame(2);
    rig.type("Mine");
    rig.frame(2);
    EXPECT_TRUE(rig.has("Replace", "button")) << "says what it will do";
    EXPECT_FALSE(rig.has("Keep", "button"));
    rig.key({.key = Key::Escape});
    rig.frame(2);
    keep("Dawn");
    EXPECT_EQ(kept.names().size(), 1u);
}

TEST_F(Looks, ADayThatRunsBecomesTheNextAndTheNextYear)
{
    io::Environment late = own();
    late.time = 23.99f;
    late.dayOfYear = 365;
    late.year = 2027;
    late.daySpeed = 3600;
    setEnvironment(rig.document(), "late", late);
    rig.click("Run the day", "button", "environment");
    rig.pass(0.2);
    const auto shown = rig.editor->live().shown(own());
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->year, 2028);
    EXPECT_EQ(shown->dayOfYear, 1);
    EXPECT_LT(shown->time, 1);
}

} // namespace
