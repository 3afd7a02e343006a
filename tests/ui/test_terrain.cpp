// The Terrain panel: the measures of the ground and its layers, through undo.
#include "tests/support/program.h"
#include "tests/support/small_world.h"
#include "tests/ui/support/rig.h"

#include "io/files/atomic_file.h"

#include <filesystem>
#include <gtest/gtest.h>

using namespace test;
using editor::Key;
namespace fs = std::filesystem;

namespace {

struct TerrainPanel : testing::Test {
    Folder folder;
    fs::path project = folder.path() / "small";
    std::unique_ptr<Rig> rig;

    void SetUp() override
    {
        makeSmallWorld(project);
        fs::create_directories(project / "textures");
        fs::copy_file(project / "terrain/ground.png", project / "textures/moss.png");
        rig = std::make_unique<Rig>(nullptr);
        ASSERT_TRUE(rig->editor->open(project));
        rig->editor->workspace().bringToFront("terrain");
        rig->frame(3);
        rig->click("Shape", "section"); // makes room
        rig->frame(3);
    }
    const io::Terrain& terrain() { return rig->document().scene().terrain(); }
    const std::vector<std::string> names() { return rig->document().history().names(); }
};

TEST_F(TerrainPanel, HeightsAreDraggedAndUndone)
{
    const auto before = rig->document().scene().heights();
    const double highest = terrain().maxHeight;
    const ImVec2 field = rig->at("Highest", "number");
    rig->drag(field, {field.x + 60, field.y});
    EXPECT_GT(terrain().maxHeight, highest);
    EXPECT_GT(rig->document().scene().heights()->max, before->max);
    EXPECT_EQ(names(), (std::vector<std::string>{"Change Highest"}));
    rig->key(editor::ctrl(Key::Z));
    EXPECT_EQ(terrain().maxHeight, highest);
    EXPECT_EQ(rig->document().scene().heights()->max, before->max);
}

TEST_F(TerrainPanel, ALayersRuleIsDraggedWithoutReadingAFile)
{
    const auto heights = rig->document().scene().heights();
    rig->click("Ground", "section"); // makes room
    rig->click("grass", "section");
    const ImVec2 field = rig->at("Slope Y", "number");
    rig->drag(field, {field.x - 40, field.y});
    EXPECT_LT(terrain().layers[0].slope.y, 90);
    EXPECT_EQ(rig->document().scene().heights(), heights);
    EXPECT_EQ(names().size(), 1u);
}

TEST_F(TerrainPanel, ATextureIsChosenFromTheProject)
{
    rig->click("grass", "section");
    rig->click("Texture", "combo");
    rig->click("textures/moss.png", "option");
    EXPECT_EQ(terrain().layers[0].texture, "textures/moss.png");
    EXPECT_NE(rig->document().assets().layers[0].colour, nullptr);
    rig->key(editor::ctrl(Key::Z));
    EXPECT_EQ(terrain().layers[0].texture, "");
    EXPECT_EQ(rig->document().assets().layers[0].colour, nullptr);
}

TEST_F(TerrainPanel, LayersComeGoAndChangePlaces)
{
    rig->click("Add layer", "button");
    ASSERT_EQ(terrain().layers.size(), 2u);
    rig->click("layer", "section");
    rig->click("Move before the previous", "button");
    EXPECT_EQ(terrain().layers[0].name, "layer");
    rig->click("layer", "section"); // what is open stays with its place
    rig->frame(2);
    if (!rig->has("Remove the layer", "button")) rig->click("layer", "section");
    rig->click("Remove the layer", "button");
    EXPECT_EQ(terrain().layers.size(), 1u);
    EXPECT_EQ(names(), (std::vector<std::string>{"Add layer", "Move layer", "Remove layer"}));
    rig->document().goTo(0);
    EXPECT_EQ(terrain().layers.size(), 1u);
    EXPECT_EQ(terrain().layers[0].name, "grass");
}

} // namespace
