// Bringing a height map in and taking the ground out, as a person does it in the Terrain panel.
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/ui/support/rig.h"

#include "io/files/height_map_file.h"
#include "io/files/image_file.h"

#include <filesystem>
#include <gtest/gtest.h>

using namespace test;
using editor::Key;
namespace fs = std::filesystem;

namespace {

struct Heights : testing::Test {
    Folder folder;
    fs::path project = folder.path() / "small";
    std::unique_ptr<Rig> rig;

    void SetUp() override
    {
        makeSmallWorld(project);
        write("same.png", {65, 65});
        write("other.png", {33, 33});
        std::ignore = folder.write("bare.raw", std::string(20 * 10 * 2, '\3'));
        std::ignore = folder.write("broken.png", "no picture");
        rig = std::make_unique<Rig>(nullptr);
        ASSERT_TRUE(rig->editor->open(project));
        rig->editor->workspace().bringToFront("terrain");
        rig->frame(3);
        rig->click("Shape", "section"); // makes room
        rig->frame(3);
    }
    void write(const char* name, glm::ivec2 size)
    {
        io::HeightGrid grid{.size = size};
        for (int i = 0; i < size.x * size.y; ++i)
            grid.metres.push_back(float(i % size.x) * 0.1f);
        ASSERT_TRUE(io::writeHeightMap16(folder.path() / name, grid, 0, 12));
    }
    void open()
    {
        rig->click("Import…", "button");
        rig->frame(3);
        ASSERT_TRUE(rig->has("Import a height map", "title", "dialog"));
    }
    void choose(const char* file)
    {
        rig->click(file, "file", "dialog");
        rig->frame(3);
    }
    void type(const char* field, const char* text)
    {
        rig->hold(true); // Ctrl and click types
        rig->click(field, "number", "dialog");
        rig->hold(false);
        rig->frame(2);
        rig->key(editor::ctrl(Key::A));
        rig->type(text);
        rig->key({.key = Key::Enter});
        rig->frame(3);
    }
    const io::Scene& scene() { return rig->document().scene(); }
};

TEST_F(Heights, AHeightMapOfTheSameMeasuresIsImportedAndUndone)
{
    const auto before = scene().heights();
    open();
    EXPECT_FALSE(rig->has("Replace ground", "button", "dialog"));
    choose("same.png");
    rig->click("Import", "button", "dialog");
    rig->frame(3);
    EXPECT_FALSE(rig->editor->dialogs().any());
    EXPECT_EQ(scene().terrain().heightMap, "terrain/same.png");
    EXPECT_NEAR(scene().heights()->at(10, 3), 1, 1e-3);
    EXPECT_EQ(rig->document().history().names(), std::vector<std::string>{"Import heights"});
    rig->key(editor::ctrl(Key::Z));
    EXPECT_EQ(*scene().heights(), *before);
    rig->key(editor::ctrl(Key::Y));
    rig->key(editor::ctrl(Key::S));
    EXPECT_EQ(io::readImage(project / "terrain/same.png")->bytes, io::readImage(folder / "same.png")->bytes);
}

TEST_F(Heights, WhatDiffersIsSaidBeforeItIsReplaced)
{
    const auto before = scene().heights();
    open();
    choose("other.png");
    EXPECT_TRUE(rig->has("The ground has 65 x 65 points now, and would have 33 x 33.", "warning", "dialog"));
    EXPECT_FALSE(rig->has("Import", "button", "dialog"));
    rig->click("Cancel", "button", "dialog");
    rig->frame(3);
    EXPECT_EQ(scene().heights(), before);
    open();
    choose("other.png");
    type("Texel", "2");
    type("Highest value", "40");
    EXPECT_TRUE(rig->has("A texel is 1 m now, and would be 2 m.", "warning", "dialog"));
    rig->click("Replace ground", "button", "dialog");
    rig->frame(3);
    EXPECT_EQ(scene().heights()->size, glm::ivec2(33));
    EXPECT_EQ(scene().terrain().metresPerTexel, 2);
    EXPECT_EQ(scene().terrain().maxHeight, 40);
    EXPECT_EQ(scene().terrain().origin, glm::dvec2(-32, -32));
    rig->key(editor::ctrl(Key::Z));
    EXPECT_EQ(*scene().heights(), *before);
}

TEST_F(Heights, FaultsAreShownInTheDialogAndBareSamplesAskForTheirSize)
{
    const auto before = scene().heights();
    open();
    choose("broken.png");
    EXPECT_FALSE(rig->has("Import", "button", "dialog") && rig->has("Texel", "number", "dialog"));
    choose("bare.raw");
    type("Width", "20");
    type("Height", "10");
    EXPECT_TRUE(rig->has("Texel", "number", "dialog"));
    EXPECT_EQ(scene().heights(), before);
    rig->click("Replace ground", "button", "dialog");
    rig->frame(3);
    EXPECT_EQ(scene().heights()->size, glm::ivec2(20, 10));
}

TEST_F(Heights, TheGroundIsExported)
{
    rig->click("Export…", "button");
    rig->frame(3);
    ASSERT_TRUE(rig->has("Export the ground", "title", "dialog"));
    rig->click("Export", "button", "dialog");
    rig->frame(3);
    EXPECT_FALSE(rig->editor->dialogs().any());
    EXPECT_EQ(io::readImage(folder / "ground.png")->bytes, io::readImage(project / "terrain/ground.png")->bytes);
    rig->click("Export…", "button");
    rig->frame(3);
    EXPECT_TRUE(rig->has("ground.png exists and will be replaced.", "warning", "dialog"));
    rig->click("Format", "combo", "dialog");
    rig->frame(2);
    rig->click("glTF mesh, one file", "option");
    rig->frame(2);
    rig->click("Export", "button", "dialog");
    rig->frame(3);
    EXPECT_TRUE(fs::exists(folder.path() / "ground.glb"));
}

} // namespace
