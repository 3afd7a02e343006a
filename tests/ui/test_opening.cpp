// File > Open while a world is loaded, or still being read.
#include "io/files/atomic_file.h"
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/ui/support/rig.h"

#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>
#include <thread>

using namespace test;
namespace fs = std::filesystem;

namespace {

void waitFor(Rig& rig, auto&& done)
{
    for (int i = 0; i < 1000 && !done(); ++i) {
        rig.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
    rig.frame(3);
}

TEST(Opening, TheSecondOfTwoRequestsIsWhatOpens)
{
    const Folder folder;
    for (const char* name : {"first", "second"})
        makeSmallWorld(folder.path() / name);
    Rig rig{crates(2)};
    rig.host.background = true;
    rig.editor->openLater(folder.path() / "first");
    rig.editor->openLater(folder.path() / "second");
    waitFor(rig, [&] { return !rig.host.recent.empty(); });
    EXPECT_EQ(rig.host.recent, (std::vector<fs::path>{folder.path() / "second"}));
    EXPECT_EQ(rig.document().project().folder, folder.path() / "second");
}

TEST(Opening, ByTheDialogWithAWorldLoaded)
{
    const Folder folder;
    makeSmallWorld(folder.path() / "first");
    makeSmallWorld(folder.path() / "second");
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(folder.path() / "first"));
    rig.frame(3);
    rig.editor->selection().set(io::ObjectId{1});
    rig.host.background = true;
    rig.editor->actions().run("open");
    rig.frame(3);
    rig.click("second", "folder", "dialog"); // the dialog begins beside the open project
    rig.click("Open", "button", "dialog");
    waitFor(rig, [&] { return rig.host.recent.size() == 2; });
    EXPECT_EQ(rig.document().project().folder, folder.path() / "second");
    EXPECT_TRUE(rig.editor->selection().empty());
    EXPECT_FALSE(rig.document().history().canUndo());
}

TEST(Opening, AFailureKeepsTheWorldItsChangesAndItsHistory)
{
    const Folder folder;
    makeSmallWorld(folder.path() / "first");
    makeSmallWorld(folder.path() / "broken");
    std::ignore = io::writeFile(folder.path() / "broken/scenes/main.scene.json", "{\n\"objects\": [");
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(folder.path() / "first"));
    rig.host.background = true;
    editor::edit(rig.document(), "Move", std::vector{io::ObjectId{1}},
                 [](io::Object& o) { o.transform.position.y = 1.25; });
    rig.editor->openLater(folder.path() / "broken");
    waitFor(rig, [&] { return rig.editor->dialogs().any(); });
    EXPECT_TRUE(rig.has("The project cannot be opened", "title", "dialog"));
    rig.click("OK", "button", "dialog");
    EXPECT_EQ(rig.document().project().folder, folder.path() / "first");
    EXPECT_EQ(rig.position(1).y, 1.25);
    EXPECT_TRUE(rig.document().modified());
    rig.document().undo();
    EXPECT_FALSE(rig.document().modified());
}

} // namespace
