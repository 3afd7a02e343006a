// Brushes and strokes: what they make of the ground, that it does not hang on frames, and that undo gives it back.
#include "editor/placement.h"
#include "editor/stroke.h"
#include "tests/unit/editor/worlds.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

// Everything from place to place at so many steps.
void drawn(Document& document, const Brush& brush, int steps, StrokeKeys keys = {})
{
    Stroke stroke{document, brush, keys, "Stroke"};
    for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps;
        stroke.to({-100 + 200 * t, 0, -60 + 130 * t});
    }
    stroke.end();
}

const io::HeightMap& ground(const Document& document)
{
    return *document.scene().heights();
}

double roughness(const io::HeightMap& map) // the mean bend of the ground
{
    double sum = 0;
    for (int z = 1; z + 1 < map.size.y; ++z)
        for (int x = 1; x + 1 < map.size.x; ++x)
            sum += std::abs(double(map.at(x + 1, z)) + map.at(x - 1, z) + map.at(x, z + 1) + map.at(x, z - 1) - 4 * map.at(x, z));
    return sum;
}

std::optional<HeightPatch> dab(const io::HeightMap& map, const Brush& brush, float amount, const glm::dvec2& at = {0, 0}, double level = 0)
{
    return dabOn(map, brush, {.centre = at, .amount = amount, .level = level});
}

TEST(Brush, RaisesFullyInTheMiddleAndNothingAtItsEdge)
{
    const auto map = test::flat(101, 5);
    for (const BrushCurve curve : {BrushCurve::Smooth, BrushCurve::Linear, BrushCurve::Dome, BrushCurve::Point}) {
        const Brush brush{.radius = 20, .falloff = 0.75f, .curve = curve};
        const auto patch = dab(*map, brush, 4);
        ASSERT_TRUE(patch);
        const io::HeightMap raised = map->with(patch->heights, patch->at);
        EXPECT_EQ(raised.height(0, 0), 9);
        EXPECT_EQ(raised.height(4, 3), 9); // within the full quarter
        EXPECT_EQ(raised.height(20, 0), 5);
        EXPECT_EQ(raised.height(0, 30), 5);
        double last = 9;
        for (double x = 0; x <= 21; ++x) {
            EXPECT_LE(*raised.height(x, 0), last);
            last = *raised.height(x, 0);
        }
    }
    EXPECT_FALSE(dab(*map, {.radius = 20}, 4, {500, 0}));
    EXPECT_TRUE(dab(*map, {.radius = 20}, 4, {60, 0})); // half of it beside the ground
}

TEST(Brush, EachToolDoesWhatItIsCalled)
{
    const auto map = test::hills(129, 2, 3);
    const auto after = [&](Brush brush, float amount, double level = 0) {
        brush.radius = 60;
        const auto patch = dab(*map, brush, amount, {0, 0}, level);
        return map->with(patch->heights, patch->at);
    };
    EXPECT_LT(roughness(after({.tool = BrushTool::Smooth, .falloff = 0.2f}, 1)), roughness(*map) * 0.9);
    EXPECT_NEAR(*after({.tool = BrushTool::Flatten, .falloff = 0.2f}, 1, 7).height(10, 10), 7, 1e-5);
    EXPECT_GT(roughness(after({.tool = BrushTool::Noise, .scale = 10}, 5)), roughness(*map));
    EXPECT_LT(*after({.tool = BrushTool::Lower}, 3).height(0, 0), *map->height(0, 0) - 2.9);
    EXPECT_LT(roughness(after({.tool = BrushTool::Slump, .talus = 8}, 1)), roughness(*map));

    const io::HeightMap steps = after({.tool = BrushTool::Terrace, .falloff = 0, .step = 4}, 1);
    int level = 0, seen = 0;
    for (int z = 45; z < 85; ++z)
        for (int x = 45; x < 85; ++x, ++seen) {
            const float rest = std::abs(std::remainder(steps.at(x, z), 4.0f));
            level += rest < 0.05f;
        }
    EXPECT_GT(level, seen / 3); // treads

    // What water takes from one place it leaves at others under the brush, so little is lost.
    const Brush rain{.tool = BrushTool::Erode, .radius = 60, .falloff = 0};
    const auto worn = dab(*map, rain, 1);
    double before = 0, now = 0, moved = 0;
    for (int z = 0; z < worn->heights.size.y; ++z)
        for (int x = 0; x < worn->heights.size.x; ++x) {
            const double was = map->at(worn->at.x + x, worn->at.y + z), is = worn->heights.at(x, z);
            before += was;
            now += is;
            moved += std::abs(is - was);
        }
    EXPECT_GT(moved, 50);
    EXPECT_LT(std::abs(now - before), moved * 0.15);
}

TEST(Brush, KeepsToSlopesAndHeights)
{
    const auto map = test::hills(129, 2, 3);
    const Brush low{.radius = 100, .falloff = 0, .altitude = {-1e5f, 0}};
    const auto patch = dab(*map, low, 5);
    for (int z = 0; z < patch->heights.size.y; ++z)
        for (int x = 0; x < patch->heights.size.x; ++x) {
            const float was = map->at(patch->at.x + x, patch->at.y + z);
            ASSERT_TRUE(was <= 0 || patch->heights.at(x, z) == was);
        }
    const auto level = test::flat(65, 0);
    EXPECT_EQ(*level->with(dab(*level, {.slope = {20, 90}}, 5)->heights, {0, 0}).height(0, 0), 0);
    const auto flatOnly = dab(*level, {.slope = {0, 20}}, 5);
    EXPECT_EQ(level->with(flatOnly->heights, flatOnly->at).height(0, 0), 5);
}

TEST(Brush, ARampIsEvenFromEndToEnd)
{
    const auto map = test::hills(257, 1, 8);
    const glm::dvec3 from{-80, 3, -40}, to{70, 23, 50};
    const auto patch = rampOn(*map, {.tool = BrushTool::Ramp, .radius = 10, .falloff = 0.3f}, from, to, 1);
    ASSERT_TRUE(patch);
    const io::HeightMap made = map->with(patch->heights, patch->at);
    for (double t = 0; t <= 1; t += 0.05)
        EXPECT_NEAR(*made.height(glm::mix(from.x, to.x, t), glm::mix(from.z, to.z, t)), glm::mix(from.y, to.y, t), 0.15) << t;
    EXPECT_FALSE(rampOn(*map, {.tool = BrushTool::Ramp}, from, from, 1));
}

TEST(Brush, ARampMayEndBesideTheMap)
{
    const auto map = test::hills(65, 1, 8);
    const auto patch = patchOf(*map, {.tool = BrushTool::Ramp, .radius = 6}, {0, 0}, {500, 0}, 1);
    ASSERT_TRUE(patch);
    EXPECT_FALSE(patchOf(*map, {.tool = BrushTool::Ramp, .radius = 6}, {400, 0}, {500, 0}, 1));
}

TEST(Brush, OneSmallerThanATexelChangesTheTexel)
{
    const io::HeightMap map{io::HeightGrid{.size = {9, 9}, .metres = std::vector<float>(81, 5), .metresPerTexel = 90}};
    const auto patch = dab(map, {.tool = BrushTool::Raise, .radius = 5, .falloff = 0}, 3, {200, 210});
    ASSERT_TRUE(patch);
    const io::HeightMap made = map.with(patch->heights, patch->at);
    EXPECT_EQ(made.at(2, 2), 8);
    EXPECT_EQ(made.at(4, 4), 5);
}

TEST(Brush, AStampKeepsThePicturesSides)
{
    const auto map = test::flat(101, 5);
    Brush brush{.tool = BrushTool::Stamp, .radius = 40, .falloff = 0};
    brush.stamp = std::make_shared<const io::HeightGrid>(io::HeightGrid{.size = {80, 10}, .metres = std::vector<float>(800, 1)});
    const auto patch = dab(*map, brush, 20);
    ASSERT_TRUE(patch);
    const io::HeightMap made = map->with(patch->heights, patch->at);
    EXPECT_NEAR(*made.height(35, 0), 25, 1e-4);
    EXPECT_NEAR(*made.height(0, 35), 5, 1e-4);
    brush.rotation = 90;
    const auto turned = dab(*map, brush, 20);
    EXPECT_NEAR(*map->with(turned->heights, turned->at).height(0, 35), 25, 1e-4);
}

TEST(Stroke, TheSameWayLeavesTheSameGroundAtAnyFrameRate)
{
    for (const BrushTool tool : {BrushTool::Raise, BrushTool::Smooth, BrushTool::Noise, BrushTool::Erode, BrushTool::Flatten}) {
        const auto slow = test::forest(0, 4), fast = test::forest(0, 4);
        drawn(*slow, {.tool = tool, .radius = 15}, 5);
        drawn(*fast, {.tool = tool, .radius = 15}, 60);
        double most = 0;
        for (int z = 0; z < 257; ++z)
            for (int x = 0; x < 257; ++x)
                most = std::max(most, std::abs(double(ground(*slow).at(x, z)) - ground(*fast).at(x, z)));
        EXPECT_LT(most, tool == BrushTool::Erode ? 0.05 : 1e-3) << int(tool); // 5 and 60 sums of the same way differ in their last bits
    }
}

TEST(Stroke, IsOneStepThatUndoGivesBackToTheLastBit)
{
    const auto document = test::forest(300, 4);
    const auto before = document->scene().heights();
    const std::string text = test::text(document->scene());
    drawn(*document, {.radius = 30}, 40);
    EXPECT_EQ(document->history().names(), std::vector<std::string>{"Stroke"});
    const auto raised = document->scene().heights();
    const std::string raisedText = test::text(document->scene());
    EXPECT_NE(text, raisedText); // objects followed
    EXPECT_FALSE(raised->sameHeights(*before));
    document->undo();
    EXPECT_TRUE(document->scene().heights()->sameHeights(*before));
    EXPECT_EQ(test::text(document->scene()), text);
    document->redo();
    EXPECT_TRUE(document->scene().heights()->sameHeights(*raised));
    EXPECT_EQ(test::text(document->scene()), raisedText);
}

TEST(Stroke, ManyUndoneAndRedoneAreTheSameGround)
{
    const auto document = test::forest(50, 4);
    std::vector<std::shared_ptr<const io::HeightMap>> states{document->scene().heights()};
    Random random{5};
    for (int i = 0; i < 20; ++i) {
        const Brush brush{.tool = BrushTool(random.bits() % 4), .radius = float(random.in(5, 60)), .strength = 0.8f};
        drawn(*document, brush, 7);
        states.push_back(document->scene().heights());
    }
    for (int i = 20; i-- > 0;) {
        document->undo();
        EXPECT_TRUE(document->scene().heights()->sameHeights(*states[std::size_t(i)])) << i;
    }
    document->goTo(13);
    EXPECT_TRUE(document->scene().heights()->sameHeights(*states[13]));
}

TEST(Stroke, ACancelledOneLeavesNothing)
{
    const auto document = test::forest(100, 4);
    const auto before = document->scene().heights();
    const std::string text = test::text(document->scene());
    Stroke stroke{*document, {.radius = 40}, {}, "Stroke"};
    stroke.to({0, 0, 0});
    stroke.to({50, 0, 0});
    EXPECT_FALSE(document->scene().heights()->sameHeights(*before));
    stroke.cancel();
    EXPECT_TRUE(document->scene().heights()->sameHeights(*before));
    EXPECT_EQ(test::text(document->scene()), text);
    EXPECT_FALSE(document->history().canUndo());
}

TEST(Stroke, ObjectsKeepTheirHeightAboveTheGroundOrStay)
{
    for (const bool follow : {true, false}) {
        const auto document = test::forest(400, 4);
        std::vector<std::pair<io::ObjectId, double>> above;
        const auto over = [&](const io::Object& object) {
            const glm::dvec3& p = object.transform.position;
            return p.y - document->scene().heights()->height(p.x, p.z).value_or(p.y);
        };
        std::vector<double> heights;
        for (const io::Object& object : document->scene().objects()) {
            above.emplace_back(object.id, over(object));
            heights.push_back(object.transform.position.y);
        }
        drawn(*document, {.radius = 50, .strength = 1}, 9, {.objectsFollow = follow});
        int moved = 0;
        for (std::size_t i = 0; i < above.size(); ++i) {
            const io::Object& object = document->scene().at(above[i].first);
            EXPECT_TRUE(!follow || std::abs(over(object) - above[i].second) < 1e-6);
            moved += object.transform.position.y != heights[i];
        }
        EXPECT_EQ(moved > 20, follow);
        EXPECT_EQ(moved == 0, !follow);
    }
}

TEST(Stroke, KeysTurnItRoundAndSmooth)
{
    const auto document = test::forest(0, 4);
    const double before = *ground(*document).height(0, 5);
    drawn(*document, {.radius = 20}, 9, {.inverted = true});
    EXPECT_LT(*ground(*document).height(0, 5), before);
    document->undo();
    const double rough = roughness(ground(*document));
    drawn(*document, {.radius = 40}, 9, {.smooths = true});
    EXPECT_LT(roughness(ground(*document)), rough);
}

TEST(Stroke, ARestingPointerGoesOnAtAPaceOfItsOwn)
{
    const auto slow = test::forest(0, 4), fast = test::forest(0, 4);
    for (const auto& [document, frames] : {std::pair{slow.get(), 5}, std::pair{fast.get(), 60}}) {
        Stroke stroke{*document, {.radius = 20}, {}, "Stroke"};
        stroke.to({0, 0, 0});
        for (int i = 0; i < frames; ++i)
            stroke.rest(1.01 / frames);
        stroke.end();
    }
    EXPECT_TRUE(ground(*slow).sameHeights(ground(*fast)));
}

TEST(Stroke, TheGroundUnderRaysFollows)
{
    const auto document = test::forest(0, 4);
    Picker picker;
    test::followed(picker, *document).prepare();
    drawn(*document, {.radius = 30, .strength = 1}, 9);
    test::followed(picker, *document);
    Random random{6};
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 p{random.in(-120, 120), random.in(-80, 90)};
        const PickHit hit = picker.pick({.origin = {p.x, 500, p.y}, .direction = {0, -1, 0}});
        ASSERT_EQ(hit.surface, Surface::Terrain);
        EXPECT_NEAR(hit.position.y, *ground(*document).height(p.x, p.y), 1e-3);
    }
}

TEST(History, TwoHundredWideStrokesStayInTheBudgetAndItSaysWhenItLetsGo)
{
    io::World world;
    world.scene.exchange(test::hills(1025, 1, 2));
    Document document{std::move(world)};
    document.setUndoBudget(std::size_t(32) << 20);
    for (int i = 0; i < 200; ++i) {
        Stroke stroke{document, {.tool = i % 3 ? BrushTool::Raise : BrushTool::Noise, .radius = 100}, {}, "Wide"};
        stroke.to({-300.0 + i * 3, 0, -200.0 + (i * 37) % 400});
        stroke.to({-100.0 + i * 3, 0, -200.0 + (i * 53) % 400});
        stroke.end();
        ASSERT_LE(document.history().bytes(), std::size_t(32) << 20);
    }
    EXPECT_GT(document.history().dropped(), 0u);
    EXPECT_GT(document.history().position(), 20u);
    while (document.history().canUndo())
        document.undo();
}

} // namespace
