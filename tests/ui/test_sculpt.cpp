// Shaping the ground with the brush, as a person does it in the viewport.
#include "editor/pointer_way.h"
#include "tests/ui/support/rig.h"

#include <gtest/gtest.h>

using namespace test;
using editor::BrushTool;
using editor::Key;

namespace {

struct Sculpting : ::testing::Test {
    Rig rig{crates(3)};
    void SetUp() override
    {
        rig.editor->workspace().bringToFront("terrain");
        rig.frame(3);
    }
    double ground(double x, double z) { return *rig.document().scene().heights()->height(x, z); }
    std::vector<std::string> names() { return rig.document().history().names(); }
};

TEST_F(Sculpting, AStrokeRaisesTheGroundAndIsOneStep)
{
    rig.click("Raise", "button");
    EXPECT_TRUE(rig.editor->viewport().sculpting);
    rig.drag(rig.onScreen({0, 0, -10}), rig.onScreen({16, 0, -10}));
    EXPECT_EQ(names(), std::vector<std::string>{"Raise ground"});
    EXPECT_GT(ground(8, -12), 0.1);
    EXPECT_GT(rig.position(2).y, 0); // the crate came along
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(ground(8, -12), 0);
    EXPECT_EQ(rig.position(2).y, 0);
    EXPECT_TRUE(rig.editor->selection().empty()); // nothing was picked meanwhile
}

TEST_F(Sculpting, TheSameWayLeavesTheSameGroundInFewFramesAndInMany)
{
    const ImVec2 middle = rig.onScreen({0, 0, -10}); // fast enough that the pointer never rests: that would count by time
    const glm::dvec2 a{middle.x - 240, middle.y + 60}, b{middle.x + 240, middle.y + 20}, bow{0, 90};
    const auto at = [&](double t) { return glm::mix(a, b, t) + bow * (4 * t * (1 - t)); };
    const auto drawn = [&](int frames) { // along a bow, of which each frame sees 120 / frames points
        rig.move({float(a.x), float(a.y)});
        rig.press();
        for (int i = 1; i <= frames; ++i) {
            std::vector<glm::dvec2> way;
            for (int j = (i - 1) * 120 / frames + 1; j <= i * 120 / frames; ++j)
                way.push_back(at(j / 120.0));
            const glm::dvec2 end = way.back();
            editor::setPointerWay(std::move(way));
            ImGui::GetIO().MousePos = {float(end.x), float(end.y)};
            rig.frame();
        }
        editor::setPointerWay({});
        rig.release();
        const io::HeightMap& map = *rig.document().scene().heights();
        std::vector<float> metres = map.read(map.texels()).metres;
        rig.key(editor::ctrl(Key::Z));
        return metres;
    };
    for (const char* tool : {"Raise", "Noise"}) {
        rig.click(tool, "button");
        const std::vector<float> few = drawn(4), many = drawn(60);
        double most = 0, differ = 0;
        for (std::size_t i = 0; i < few.size(); ++i) {
            most = std::max(most, std::abs(double(few[i])));
            differ = std::max(differ, std::abs(double(few[i]) - double(many[i])));
        }
        EXPECT_GT(most, 0.5) << tool;
        EXPECT_LT(differ, most * 0.01) << tool;
    }
}

TEST_F(Sculpting, CtrlLowersAndEscapeTakesBackWhatIsBeingDrawn)
{
    rig.click("Raise", "button");
    rig.hold(true);
    rig.drag(rig.onScreen({0, 0, -10}), rig.onScreen({12, 0, -10}));
    rig.hold(false);
    EXPECT_LT(ground(8, -12), -0.1);
    const double before = ground(8, -12);
    rig.move(rig.onScreen({0, 0, 0}));
    rig.press();
    rig.move(rig.onScreen({12, 0, 0}));
    EXPECT_NE(ground(8, -12), before);
    rig.key({.key = Key::Escape});
    EXPECT_EQ(ground(8, -12), before);
    rig.release();
    EXPECT_EQ(names().size(), 1u);
    EXPECT_TRUE(rig.editor->viewport().sculpting); // the brush stays in hand
    rig.key({.key = Key::Escape});
    EXPECT_FALSE(rig.editor->viewport().sculpting);
}

TEST_F(Sculpting, GrassIsGrownAndMownByStrokesOfOneStepEach)
{
    setGrass(rig.document(), "Kinds", io::Grass{.kinds = {{.name = "meadow"}}});
    rig.frame(3);
    const auto dense = [&] { // where the strokes go
        const std::shared_ptr<const io::GrassMap>& map = rig.document().scene().grassMap();
        return map ? map->at({8, -10}).density[0] : 0.0f;
    };
    rig.click("Grow", "button");
    rig.drag(rig.onScreen({0, 0, -10}), rig.onScreen({16, 0, -10}));
    EXPECT_EQ(names().back(), "Grow grass");
    EXPECT_GT(dense(), 0.05f);
    const std::size_t steps = names().size();
    rig.hold(true); // Ctrl mows
    for (int i = 0; i < 12; ++i)
        rig.drag(rig.onScreen({0, 0, -10}), rig.onScreen({16, 0, -10}));
    rig.hold(false);
    EXPECT_EQ(names().size(), steps + 12);
    EXPECT_LT(dense(), 0.02f);
    for (int i = 0; i < 13; ++i)
        rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(dense(), 0);
}

TEST_F(Sculpting, KeysTakeTheBrushAndChangeItsSize)
{
    rig.key({.key = Key::B});
    EXPECT_TRUE(rig.editor->viewport().sculpting);
    const float radius = rig.editor->viewport().brush.radius;
    rig.key({.key = Key::RightBracket});
    EXPECT_GT(rig.editor->viewport().brush.radius, radius);
    rig.key({.key = Key::LeftBracket});
    rig.key({.key = Key::LeftBracket});
    EXPECT_LT(rig.editor->viewport().brush.radius, radius);
    rig.key({.key = Key::W}); // another tool puts it down
    EXPECT_FALSE(rig.editor->viewport().sculpting);
}

TEST_F(Sculpting, AHeldButtonGoesOn)
{
    rig.click("Raise", "button");
    rig.move(rig.onScreen({0, 0, -10}));
    rig.press();
    const double first = ground(0, -12);
    rig.frame(60);
    EXPECT_GT(ground(0, -12), first * 2);
    rig.release();
    EXPECT_EQ(names().size(), 1u);
}

TEST_F(Sculpting, ARampRunsFromPressToRelease)
{
    rig.click("Raise", "button");
    rig.click(rig.onScreen({20, 0, -20}));
    const double high = ground(20, -20);
    rig.click("Ramp", "button");
    rig.drag(rig.onScreen({-20, 0, -20}), rig.onScreen({20, high, -20}));
    EXPECT_EQ(names().back(), "Ramp");
    EXPECT_GT(ground(0, -20), high * 0.2);
    EXPECT_LT(ground(0, -20), high * 0.8);
}

TEST_F(Sculpting, UndoAndAnotherWorldEndAStrokeThatIsBeingDrawn)
{
    rig.click("Raise", "button");
    rig.move(rig.onScreen({0, 0, -10}));
    rig.press();
    rig.move(rig.onScreen({8, 0, -10}));
    EXPECT_NE(ground(4, -12), 0);
    rig.document().undo();
    EXPECT_EQ(ground(4, -12), 0);
    rig.move(rig.onScreen({12, 0, -10})); // still held: nothing more is drawn
    EXPECT_EQ(ground(8, -12), 0);
    rig.release();
    rig.move(rig.onScreen({0, 0, -10}));
    rig.press();
    rig.editor->adopt(crates(1));
    rig.frame(2);
    rig.move(rig.onScreen({8, 0, -10}));
    rig.release();
    EXPECT_FALSE(rig.document().history().canUndo());
}

TEST_F(Sculpting, PaintGoesIntoAFileOfItsOwn)
{
    io::Terrain terrain = rig.document().scene().terrain();
    terrain.layers = {{.name = "grass"}, {.name = "rock"}};
    ASSERT_TRUE(editor::setTerrain(rig.document(), "Layers", terrain));
    rig.frame(2);
    rig.click("Paint", "button");
    rig.click("Layer", "combo");
    rig.click("rock", "option");
    rig.drag(rig.onScreen({0, 0, -10}), rig.onScreen({16, 0, -10}));
    EXPECT_EQ(names().back(), "Paint ground");
    ASSERT_NE(rig.document().scene().cover(), nullptr);
    EXPECT_FALSE(rig.document().scene().terrain().coverMap.empty());
    const io::Cover cover = io::unpacked(rig.document().scene().cover()->at(34, 30));
    EXPECT_EQ(cover.base, 1);
    EXPECT_GT(cover.painted, 0.2f);
    rig.key(editor::ctrl(Key::Z));
    EXPECT_EQ(rig.document().scene().cover(), nullptr);
}

} // namespace
