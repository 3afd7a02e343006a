// The Templates panel deletes templates: with their objects, as one step.
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/ui/support/rig.h"

#include <filesystem>
#include <gtest/gtest.h>

using namespace test;
using editor::Key;
namespace fs = std::filesystem;

namespace {

void chooseDelete(Rig& rig, const char* name)
{
    rig.click(rig.at(name, "template"), 1);
    rig.frame(2);
    rig.click("Delete template…", "menu item");
    rig.frame(2);
}

TEST(Templates, AnUnusedOneIsDeletedAtOnce)
{
    Rig rig;
    rig.click("post", "template"); // it is being placed, too
    chooseDelete(rig, "post");
    EXPECT_FALSE(rig.editor->dialogs().any());
    EXPECT_FALSE(rig.has("post", "template"));
    EXPECT_EQ(rig.editor->viewport().placing(), io::TemplateId::None);
    EXPECT_EQ(rig.document().history().names(), (std::vector<std::string>{"Delete template"}));
    rig.key(editor::ctrl(Key::Z));
    EXPECT_TRUE(rig.has("post", "template"));
}

TEST(Templates, AUsedOneAsksAndTakesItsObjectsAlong)
{
    Rig rig;
    rig.editor->selection().set(io::ObjectId{2});
    chooseDelete(rig, "crate");
    EXPECT_TRUE(rig.has("Delete the template crate?", "title", "dialog"));
    rig.click("Cancel", "button", "dialog");
    EXPECT_EQ(rig.document().scene().objects().size(), 5u);
    chooseDelete(rig, "crate");
    rig.click("Delete all", "button", "dialog");
    EXPECT_TRUE(rig.document().scene().objects().empty());
    EXPECT_EQ(rig.document().scene().find(io::TemplateId{1}), nullptr);
    EXPECT_TRUE(rig.editor->selection().empty());
    EXPECT_EQ(rig.document().history().names().size(), 1u);
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(rig.document().scene().objects().size(), 5u);
    EXPECT_TRUE(rig.has("crate", "template"));
}

TEST(Templates, TheFileGoesAndComesBackWithSave)
{
    const Folder folder;
    const fs::path project = folder.path() / "small";
    makeSmallWorld(project);
    const std::string list = textOf(project / "project.json"), file = textOf(project / "templates/crate.json");
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(project));
    rig.frame(3);
    chooseDelete(rig, "crate");
    rig.click("Delete all", "button", "dialog");
    EXPECT_TRUE(fs::exists(project / "templates/crate.json")); // until it is saved
    rig.key(editor::ctrl(Key::S));
    EXPECT_FALSE(fs::exists(project / "templates/crate.json"));
    rig.key(editor::ctrl(Key::Z));
    rig.key(editor::ctrl(Key::S));
    EXPECT_EQ(textOf(project / "templates/crate.json"), file);
    EXPECT_EQ(textOf(project / "project.json"), list);
}

TEST(Templates, OneThatAnotherSceneUsesStays)
{
    const Folder folder;
    const fs::path project = folder.path() / "small";
    makeSmallWorld(project);
    fs::copy_file(project / "scenes/main.scene.json", project / "scenes/night.scene.json");
    io::Complaints complaints;
    auto world = io::openWorld(project, {}, complaints);
    ASSERT_TRUE(world);
    world->project.scenes.push_back({"night", "scenes/night.scene.json"});
    ASSERT_TRUE(io::saveWorld(*world));
    Rig rig{nullptr};
    ASSERT_TRUE(rig.editor->open(project));
    rig.frame(3);
    chooseDelete(rig, "crate");
    EXPECT_TRUE(rig.has("crate cannot be deleted", "title", "dialog"));
    rig.click("OK", "button", "dialog");
    EXPECT_NE(rig.document().scene().find(io::TemplateId{1}), nullptr);
}

} // namespace
