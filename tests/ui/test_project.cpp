// Projects on disk as the window opens, saves and makes them.
#include "io/files/atomic_file.h"
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/ui/support/rig.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

using namespace test;
using editor::Key;
namespace fs = std::filesystem;

namespace {

struct Project {
    Folder folder;
    fs::path path = folder.path() / "small";

    Project() { makeSmallWorld(path); }
    std::string scene() const { return textOf(path / "scenes/main.scene.json"); }
};

void moveFirst(Rig& rig)
{
    editor::edit(rig.document(), "Move", std::vector{io::ObjectId{1}},
                 [](io::Object& o) { o.transform.position.y = 1.25; });
    rig.frame();
}

TEST(Project, IsSavedByItsKey)
{
    const Project project;
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(project.path));
    EXPECT_EQ(rig.editor->title(), "Small – main – Wold");
    EXPECT_EQ(rig.host.recent.back(), project.path);
    const std::string before = project.scene();
    moveFirst(rig);
    EXPECT_EQ(rig.editor->title(), "Small – main * – Wold");
    EXPECT_EQ(project.scene(), before); // changes live in memory until they are saved
    rig.key(editor::ctrl(Key::S));
    EXPECT_EQ(rig.editor->title(), "Small – main – Wold");
    EXPECT_NE(project.scene().find("1.25"), std::string::npos);
    EXPECT_FALSE(rig.editor->toasts().empty());
}

TEST(Project, AFailedSaveIsAMessageAndKeepsTheChanges)
{
    const Project project;
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(project.path));
    moveFirst(rig);
    fs::remove_all(project.path);
    std::ignore = project.folder.write("small", "a file where the folder was");
    rig.key(editor::ctrl(Key::S));
    rig.frame(3);
    EXPECT_TRUE(rig.has("The project cannot be saved", "title", "dialog"));
    rig.click("OK", "button", "dialog");
    EXPECT_TRUE(rig.document().modified());
}

TEST(Project, SaveBeforeClosingSaves)
{
    const Project project;
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(project.path));
    moveFirst(rig);
    rig.editor->requestClose();
    rig.frame(3);
    rig.click("Save", "button", "dialog");
    EXPECT_TRUE(rig.editor->wantsClose());
    EXPECT_NE(project.scene().find("1.25"), std::string::npos);
}

TEST(Project, RevertAsksAndGoesBackToTheDisk)
{
    const Project project;
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(project.path));
    const glm::dvec3 before = rig.position(1);
    moveFirst(rig);
    rig.editor->actions().run("revert");
    rig.frame(3);
    rig.click("Discard changes", "button", "dialog");
    EXPECT_EQ(rig.position(1), before);
    EXPECT_FALSE(rig.document().modified());
}

TEST(Project, IsOpenedInTheBackground)
{
    const Project project;
    Rig rig{crates(2)};
    rig.host.background = true;
    rig.editor->openLater(project.path);
    rig.frame();
    EXPECT_EQ(rig.document().scene().objects().size(), 2u); // still there
    for (int i = 0; i < 1000 && rig.document().project().name != "Small"; ++i) {
        rig.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
    EXPECT_EQ(rig.document().project().name, "Small");
    rig.frame(3);
    EXPECT_FALSE(rig.has("Cancel", "button", "dialog"));
    rig.click("crate", "template"); // nothing lies over the window any more
    EXPECT_NE(rig.editor->viewport().placing(), io::TemplateId::None);
}

TEST(Project, EscapeCancelsWhatIsBeingOpened)
{
    const Project project;
    Rig rig{crates(2)};
    rig.host.background = true;
    rig.editor->openLater(project.path);
    ImGui::GetIO().KeysDown[int(Key::Escape)] = true; // in the first frame: the reading may be over after it
    rig.frame();
    ImGui::GetIO().KeysDown[int(Key::Escape)] = false;
    for (int i = 0; i < 20; ++i) {
        rig.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
    EXPECT_EQ(rig.document().scene().objects().size(), 2u);
    EXPECT_FALSE(rig.has("Cancel", "button", "dialog"));
}

TEST(Project, ADamagedOneIsAMessageAndTheRestGoesOn)
{
    const Project project;
    std::ignore = io::writeFile(project.path / "project.json", "{\"name\": ");
    Rig rig;
    rig.host.background = true;
    rig.editor->openLater(project.path);
    for (int i = 0; i < 1000 && !rig.editor->dialogs().any(); ++i) {
        rig.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
    rig.frame(3);
    rig.click("OK", "button", "dialog");
    EXPECT_EQ(rig.document().scene().objects().size(), 5u);
}

TEST(Project, IsMadeByTheDialog)
{
    const Project project;
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(project.path)); // the dialog begins beside it
    rig.editor->dialogs().showSaveAs(*rig.editor);
    rig.frame(3);
    rig.click("Folder name", "text", "dialog");
    rig.key(editor::ctrl(Key::A));
    rig.type("copy");
    rig.click("Save", "button", "dialog");
    EXPECT_TRUE(fs::exists(project.folder.path() / "copy/project.json"));
    EXPECT_EQ(rig.document().project().folder, project.folder.path() / "copy");
}

} // namespace
