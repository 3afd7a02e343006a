// Statistics over the picture, what they are made of, and how coarse a moving picture is drawn.
#include "editor/frame_history.h"
#include "editor/resolution.h"
#include "editor/statistics_overlay.h"
#include "editor/ui_map.h"
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

using namespace test;
using editor::Key;

namespace {

std::vector<renderer::PassTime> passes(double cpu, double gpu)
{
    return {{.name = "shadow", .cpuMs = cpu, .gpuMs = gpu}, {.name = "lighting", .cpuMs = 2 * cpu, .gpuMs = 2 * gpu}};
}

TEST(FrameHistory, KeepsTheLastFramesOldestFirst)
{
    editor::FrameHistory frames;
    EXPECT_EQ(frames.meanMs(), 0);
    for (int i = 1; i <= 125; ++i)
        frames.note(i / 1000.0, {});
    ASSERT_EQ(frames.size(), editor::FrameHistory::kFrames);
    EXPECT_DOUBLE_EQ(frames.at(0).ms, 6);
    EXPECT_DOUBLE_EQ(frames.at(119).ms, 125);
    EXPECT_DOUBLE_EQ(frames.meanMs(), 65.5);
}

TEST(FrameHistory, PassesAreAveragedOverTheFramesThatHadThem)
{
    editor::FrameHistory frames;
    frames.note(0.01, passes(1, 3));
    frames.note(0.01, passes(3, 5));
    frames.note(0.01, std::vector<renderer::PassTime>{{.name = "lighting", .cpuMs = 8, .gpuMs = 0}});
    const std::vector<renderer::PassTime> means = frames.means();
    ASSERT_EQ(means.size(), 2u);
    EXPECT_EQ(means[0].name, "lighting");
    EXPECT_DOUBLE_EQ(means[0].cpuMs, (2 + 6 + 8) / 3.0);
    EXPECT_DOUBLE_EQ(means[1].gpuMs, 4);
}

TEST(Statistics, LieOverThePictureByKeyAndMenu)
{
    Rig rig;
    EXPECT_FALSE(rig.has("CPU ms", "timeline"));
    rig.key({.key = Key::F3});
    EXPECT_TRUE(rig.has("CPU ms", "timeline"));
    EXPECT_TRUE(rig.has("GPU ms", "timeline"));
    for (const char* test : {"Inside the view", "Large enough", "Not behind others", "Drawn", "GPU memory", "Pictures, heights"})
        EXPECT_TRUE(rig.has(test, "statistic")) << test;
    EXPECT_FALSE(rig.has("Culling", "statistic"));
    rig.click("View", "menu");
    rig.click("Statistics", "menu item");
    EXPECT_FALSE(rig.has("CPU ms", "timeline"));
}

TEST(FreezeCulling, IsSwitchedByKeyAndMenuAndEndsWithTheWorld)
{
    Rig rig;
    rig.key({.key = Key::F7});
    EXPECT_TRUE(rig.editor->viewport().freezeCulling);
    rig.click("View", "menu");
    rig.click("Freeze culling", "menu item");
    EXPECT_FALSE(rig.editor->viewport().freezeCulling);
    rig.key({.key = Key::F7});
    rig.editor->adopt(crates(2));
    EXPECT_FALSE(rig.editor->viewport().freezeCulling);
}

TEST(FreezeCulling, IsSaidInTheStatistics)
{
    Rig rig;
    const renderer::FrameStats frozen{.instances = 9, .instancesInside = 4, .instancesLarge = 3, .cullingFrozen = true};
    ImGui::NewFrame();
    editor::clearMap();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({700, 700});
    ImGui::Begin("##over");
    editor::statisticsOverlay({}, frozen, {}, {0, 0}, {700, 700});
    ImGui::End();
    ImGui::Render();
    EXPECT_EQ(*rig.value("Culling", "statistic").asString(), "frozen");
    EXPECT_EQ(*rig.value("Inside the view", "statistic").asString(), "4 of 9");
    EXPECT_EQ(*rig.value("Large enough", "statistic").asString(), "3 of 4");
    EXPECT_EQ(*rig.value("Not behind others", "statistic").asString(), "not tested");
}

TEST(TreeNodes, AreShownByKeyAndMenu)
{
    Rig rig;
    rig.key({.key = Key::F6});
    EXPECT_EQ(rig.editor->show, renderer::Show::Nodes);
    rig.key({.key = Key::F6});
    EXPECT_EQ(rig.editor->show, renderer::Show::Final);
    rig.click("View", "menu");
    rig.click("Nodes of the scene tree", "menu item", "menu");
    EXPECT_EQ(rig.editor->show, renderer::Show::Nodes);
}

TEST(Resolution, GoesDownUntilTheRateIsHeldAndComesBack)
{
    editor::Resolution resolution;
    resolution.note(1, 30);
    EXPECT_EQ(resolution.scale(), 1); // a hitch
    for (int i = 0; i < 40; ++i)
        resolution.note(resolution.scale() > 0.6 ? 0.060 : 0.030, 30);
    EXPECT_EQ(resolution.scale(), 0.5);
    for (int i = 0; i < 40; ++i)
        resolution.note(0.010, 30);
    EXPECT_EQ(resolution.scale(), 1);
    for (int i = 0; i < 4; ++i)
        resolution.note(0.060, 30);
    EXPECT_LT(resolution.scale(), 1);
    resolution.sharpen();
    EXPECT_EQ(resolution.scale(), 1);
}

TEST(Resolution, DoesNotGoToAndFro)
{
    editor::Resolution resolution;
    int changes = 0;
    for (int i = 0; i < 600; ++i) { // full is too slow, and the next is so quick that full seems within reach
        const double before = resolution.scale();
        resolution.note(before == 1 ? 0.040 : 0.017, 30);
        changes += before != resolution.scale();
    }
    EXPECT_LT(changes, 12);
}

TEST(Resolution, FollowsTheRateThatThePersonWants)
{
    for (const double rate : {15.0, 60.0}) {
        Rig rig;
        rig.host.background = true; // else every picture is drawn in full
        rig.host.rate = rate;
        rig.move(rig.onScreen({8, 0, 10}));
        rig.press(1);
        for (int i = 0; i < 10; ++i)
            rig.pass(1 / 30.0);
        EXPECT_EQ(rig.editor->viewport().pictureScale() < 1, rate == 60) << rate;
        rig.release(1);
        EXPECT_EQ(rig.editor->viewport().pictureScale(), 1) << rate; // sharp when it rests
    }
}

TEST(Panels, ShowWhatUndoMadeInTheSameFrame)
{
    Rig rig;
    rig.editor->selection().set(io::ObjectId{2});
    rig.frame(2);
    rig.key({.key = Key::Delete});
    rig.frame(3);
    ASSERT_EQ(rig.document().scene().objects().size(), 4u);
    rig.hold(true);
    ImGui::GetIO().KeysDown[int(Key::Z)] = true;
    rig.frame(); // the one in which it is undone
    ImGui::GetIO().KeysDown[int(Key::Z)] = false;
    EXPECT_EQ(rig.document().scene().objects().size(), 5u);
    EXPECT_TRUE(rig.has("crate 2", "row", "hierarchy"));
}

} // namespace
