// Planting with the brush, as a person does it in the viewport and the Scatter panel.
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

using namespace test;
using editor::Key;
using editor::ScatterMode;

namespace {

struct Scattering : ::testing::Test {
    Rig rig{crates(3)};
    void SetUp() override
    {
        rig.document().run(std::make_unique<editor::SwapScatterLayers>(
            "Layer", std::vector<io::ScatterLayer>{{.id = rig.document().freshScatterId(), .name = "wood", .species = {{.templateName = "post"}}, .density = 0.5f, .spacing = 0.5f}}));
        rig.editor->workspace().bringToFront("scatter");
        rig.editor->viewport().scatterBrush.radius = 5;
        rig.frame(3);
    }
    const io::InstanceTiles& tiles() { return rig.document().scene().instances(rig.document().scene().scatterLayers().front().id); }
    std::size_t count() { return io::instanceCount(tiles()); }
    std::vector<std::string> names() { return rig.document().history().names(); }
    void stroke() { rig.drag(rig.onScreen({0, 0, -10}), rig.onScreen({16, 0, -10})); }
};

TEST_F(Scattering, AStrokePlantsAndIsOneStep)
{
    rig.click("Plant", "button");
    EXPECT_TRUE(rig.editor->viewport().scattering);
    stroke();
    EXPECT_EQ(names(), (std::vector<std::string>{"Layer", "Plant"}));
    const double area = 16 * 10 + 3.14159 * 25;
    EXPECT_NEAR(double(count()), 0.5 * area, 0.5 * area * 0.15);
    const std::uint64_t once = io::instanceHash(tiles());
    stroke(); // the same way once more plants nothing
    EXPECT_EQ(io::instanceHash(tiles()), once);
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(count(), 0u);
    EXPECT_TRUE(rig.editor->selection().empty()); // nothing was picked meanwhile
}

TEST_F(Scattering, CtrlErasesShiftThinsAndEscapeTakesBackWhatIsBeingDrawn)
{
    rig.click("Plant", "button");
    stroke();
    const std::size_t full = count();
    const std::uint64_t before = io::instanceHash(tiles());
    rig.hold(false, true);
    stroke();
    rig.hold(false);
    EXPECT_LT(double(count()), double(full) * 0.7);
    EXPECT_GT(double(count()), double(full) * 0.3);
    EXPECT_EQ(names().back(), "Thin plants");
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(io::instanceHash(tiles()), before);

    rig.move(rig.onScreen({0, 0, -10}));
    rig.hold(true);
    rig.press();
    rig.move(rig.onScreen({16, 0, -10}));
    EXPECT_EQ(count(), 0u);
    rig.key({.key = Key::Escape, .ctrl = true});
    EXPECT_EQ(io::instanceHash(tiles()), before);
    rig.release();
    rig.hold(false);
    EXPECT_TRUE(rig.editor->viewport().scattering); // the brush stays in hand
    rig.key({.key = Key::Escape});
    EXPECT_FALSE(rig.editor->viewport().scattering);
}

TEST_F(Scattering, AStrokeWhereRulesLetNothingGrowSaysSo)
{
    std::vector<io::ScatterLayer> layers{rig.document().scene().scatterLayers().begin(), rig.document().scene().scatterLayers().end()};
    layers.front().altitude = {500, 600};
    rig.document().run(std::make_unique<editor::SwapScatterLayers>("Layer", layers));
    rig.frame(2);
    rig.click("Plant", "button");
    EXPECT_TRUE(rig.editor->toasts().empty());
    stroke();
    EXPECT_EQ(count(), 0u);
    EXPECT_FALSE(rig.editor->toasts().empty());
}

TEST_F(Scattering, ALassoFillsWhatItSurroundsAndAClickPlantsOne)
{
    rig.click("Lasso", "button");
    rig.move(rig.onScreen({-8, 0, -8}));
    rig.press();
    for (const glm::dvec3& corner : {glm::dvec3{8, 0, -8}, glm::dvec3{8, 0, 4}, glm::dvec3{-8, 0, 4}})
        rig.move(rig.onScreen(corner));
    EXPECT_EQ(count(), 0u);
    rig.release();
    EXPECT_NEAR(double(count()), 0.5 * 16 * 12, 10);
    EXPECT_EQ(names().back(), "Plant in a lasso");
    const std::size_t before = count();
    rig.click("Single", "button");
    rig.click(rig.onScreen({0, 0, 8}));
    EXPECT_EQ(count(), before + 1);
}

TEST_F(Scattering, MakesObjectsWhereAsked)
{
    rig.editor->viewport().scatterBrush.target = editor::ScatterTarget::Objects;
    rig.click("Plant", "button");
    stroke();
    EXPECT_EQ(count(), 0u);
    const std::size_t objects = rig.document().scene().objects().size();
    EXPECT_GT(objects, 60u);
    stroke();
    EXPECT_EQ(rig.document().scene().objects().size(), objects);
    rig.hold(true);
    stroke();
    rig.hold(false);
    EXPECT_EQ(rig.document().scene().objects().size(), 3u); // the crates are of no species of the layer
}

TEST_F(Scattering, KeysTakeTheBrushAndChangeItsSize)
{
    rig.key({.key = Key::V});
    EXPECT_TRUE(rig.editor->viewport().scattering);
    const float radius = rig.editor->viewport().scatterBrush.radius;
    rig.key({.key = Key::RightBracket});
    EXPECT_GT(rig.editor->viewport().scatterBrush.radius, radius);
    rig.key({.key = Key::W}); // another tool puts it down
    EXPECT_FALSE(rig.editor->viewport().scattering);
}

TEST_F(Scattering, ThePanelAddsFillsClearsAndRemovesLayers)
{
    rig.click("Fill", "button");
    rig.frame(2);
    EXPECT_GT(count(), 500u);
    rig.click("Clear", "button");
    EXPECT_EQ(count(), 0u);
    rig.click("Add layer", "button");
    rig.frame(2);
    EXPECT_EQ(rig.document().scene().scatterLayers().size(), 2u);
    EXPECT_EQ(rig.document().scene().scatterLayers().back().id, rig.editor->viewport().scatterLayer);
    rig.click("Add species", "button");
    EXPECT_EQ(rig.document().scene().scatterLayers().back().species.size(), 1u);
    rig.click("Remove layer");
    EXPECT_EQ(rig.document().scene().scatterLayers().size(), 1u);
}

TEST_F(Scattering, RulesAreEvaluatedAgainWhereTheGroundWasShaped)
{
    std::vector<io::ScatterLayer> layers{rig.document().scene().scatterLayers().front()};
    layers.front().rule = true;
    layers.front().altitude = {-1, 0.05f};
    editor::setScatterLayers(rig.document(), "Rule", layers);
    rig.frame(2);
    rig.click("Evaluate rules", "button");
    rig.frame(2);
    const std::size_t level = count();
    const std::uint64_t before = io::instanceHash(tiles());
    EXPECT_GT(level, 500u);
    rig.editor->viewport().sculptWith(*rig.editor, editor::BrushTool::Raise);
    rig.frame(2);
    stroke();
    EXPECT_LT(count(), level); // too high for them now
    rig.key(editor::ctrl(Key::Z)); // one step takes back ground and plants
    EXPECT_EQ(io::instanceHash(tiles()), before);
}

} // namespace
