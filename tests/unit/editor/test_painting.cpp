// Painting layers over the ground: what a texel makes of it, and that steps, files and lists of layers keep it.
#include "editor/painting.h"
#include "editor/stroke.h"
#include "io/files/cover_map_file.h"
#include "io/scene/ground.h"
#include "tests/unit/editor/worlds.h"

#include <gtest/gtest.h>
#include <unistd.h>

using namespace editor;

namespace {

std::unique_ptr<Document> meadow()
{
    auto document = test::forest(0, 4);
    io::Terrain terrain = document->scene().terrain();
    terrain.layers = {{.name = "grass"}, {.name = "rock"}, {.name = "sand"}};
    EXPECT_TRUE(setTerrain(*document, "Layers", terrain));
    return document;
}

void painted(Document& document, BrushTool tool, int layer, const glm::dvec2& at, float radius, float amount = 1)
{
    const io::Scene& scene = document.scene();
    const auto patch = paintOn(*scene.heights(), coverOf(scene), {.tool = tool, .radius = radius, .falloff = 0.5f, .layer = layer}, {.centre = at, .amount = amount});
    ASSERT_TRUE(patch);
    changeCover(document, "Paint", *patch);
}

io::Cover coverAt(const Document& document, const glm::dvec2& place)
{
    const io::HeightMap& map = *document.scene().heights();
    const glm::ivec2 texel{glm::round((place - map.origin) / map.metresPerTexel)};
    return io::unpacked(document.scene().cover()->at(texel.x, texel.y));
}

// How much of the ground a layer then is, where nothing but paint shows.
float shareOf(const io::Cover& c, int layer)
{
    return (c.base == layer ? 1 - c.share : 0) + (c.over == layer ? c.share : 0);
}

TEST(Cover, BitsComeBack)
{
    for (int base = 0; base < 32; ++base)
        for (int byte = 0; byte < 255; byte += 2) {
            const io::Cover cover{base, 31 - base, float(byte) / 255, float(255 - byte) / 255};
            EXPECT_EQ(io::unpacked(io::packed(cover)), cover);
        }
    EXPECT_EQ(io::packed(io::Cover{}), 0u);
}

TEST(Cover, EveryStrokeOfALayerBringsMoreOfItUntilNothingElseShows)
{
    for (const io::Cover& start : {io::Cover{}, io::Cover{0, 1, 0.3f, 1}, io::Cover{2, 1, 0.8f, 0.4f}, io::Cover{1, 1, 0, 0.1f}}) {
        io::Cover cover = start;
        float before = start.painted * shareOf(start, 2);
        for (int i = 0; i < 60; ++i) {
            cover = painted(cover, BrushTool::Paint, 2, 0, 0.2f);
            const float now = cover.painted * shareOf(cover, 2);
            EXPECT_GE(now, before - 1e-5f);
            EXPECT_LE(cover.share, 1.0001f);
            EXPECT_LE(cover.painted, 1.0001f);
            before = now;
        }
        EXPECT_GT(before, 0.99f);
    }
}

TEST(Cover, ErasingLeavesTheRulesAndReplacingOnlyTheOther)
{
    io::Cover cover{0, 1, 0.3f, 1};
    EXPECT_EQ(painted(cover, BrushTool::Replace, 2, 1, 1), (io::Cover{0, 2, 0.3f, 1}));
    EXPECT_EQ(painted(cover, BrushTool::Replace, 2, 3, 1), cover);
    for (int i = 0; i < 60; ++i)
        cover = painted(cover, BrushTool::Erase, 0, 0, 0.2f);
    EXPECT_EQ(cover, io::Cover{});
}

TEST(Painting, IsOneStepAndGoesAwayWithIt)
{
    const auto document = meadow();
    const std::size_t steps = document->history().position();
    painted(*document, BrushTool::Paint, 1, {0, 0}, 30);
    EXPECT_EQ(document->history().position(), steps + 1);
    EXPECT_EQ(coverAt(*document, {0, 0}), (io::Cover{1, 1, 0, 1}));
    EXPECT_EQ(coverAt(*document, {60, 0}), io::Cover{});
    EXPECT_FALSE(document->scene().terrain().coverMap.empty());
    const auto once = document->scene().cover();
    painted(*document, BrushTool::Paint, 2, {20, 0}, 30, 0.5f);
    const auto twice = document->scene().cover();
    document->undo();
    EXPECT_EQ(*document->scene().cover(), *once);
    document->undo();
    EXPECT_EQ(document->scene().cover(), nullptr);
    EXPECT_TRUE(document->scene().terrain().coverMap.empty());
    document->goTo(steps + 2);
    EXPECT_EQ(*document->scene().cover(), *twice);
}

TEST(Painting, FadesSmoothlyToTheEdge)
{
    const auto document = meadow();
    painted(*document, BrushTool::Paint, 1, {0, 0}, 100);
    const io::CoverMap& cover = *document->scene().cover();
    for (int z = 0; z < cover.size().y; ++z)
        for (int x = 1; x < cover.size().x; ++x)
            ASSERT_LE(std::abs(io::unpacked(cover.at(x, z)).painted - io::unpacked(cover.at(x - 1, z)).painted), 16.0f / 255); // 2 m of 50
}

TEST(Painting, FillsWhereSlopesLetIt)
{
    const auto document = meadow();
    fillCover(*document, "Fill", {.tool = BrushTool::Paint, .slope = {25, 90}, .layer = 1});
    const io::HeightMap& map = *document->scene().heights();
    int steep = 0, level = 0;
    for (int z = 2; z + 2 < map.size.y; ++z)
        for (int x = 2; x + 2 < map.size.x; ++x) {
            const glm::dvec2 place = map.origin + glm::dvec2{x, z} * map.metresPerTexel;
            const double slope = glm::degrees(std::acos(map.normal(place.x, place.y)->y));
            const float painted = io::unpacked(document->scene().cover()->at(x, z)).painted;
            steep += slope > 28;
            level += slope < 22;
            EXPECT_TRUE(slope <= 28 || painted > 0.9f) << slope;
            EXPECT_TRUE(slope >= 22 || painted == 0) << slope;
        }
    EXPECT_GT(steep, 100);
    EXPECT_GT(level, 100);
    EXPECT_EQ(document->history().names().back(), "Fill");
}

TEST(Painting, GoesWithItsLayersWhenTheListChanges)
{
    const auto document = meadow();
    painted(*document, BrushTool::Paint, 1, {-50, 0}, 20);
    painted(*document, BrushTool::Paint, 2, {50, 0}, 20);
    const auto before = document->scene().cover();
    auto layers = document->scene().terrain().layers;
    layers.erase(layers.begin() + 1);
    setLayers(*document, "Remove", layers, std::vector{0, -1, 1});
    EXPECT_EQ(coverAt(*document, {50, 0}).base, 1);         // sand is the second now
    EXPECT_EQ(coverAt(*document, {-50, 0}), io::Cover{});   // where rock was, the rules hold again
    EXPECT_EQ(document->scene().terrain().layers.size(), 2u);
    document->undo();
    EXPECT_EQ(*document->scene().cover(), *before);
    EXPECT_EQ(document->scene().terrain().layers.size(), 3u);
}

TEST(Painting, AFileHoldsItToTheLastBit)
{
    const auto document = meadow();
    painted(*document, BrushTool::Paint, 1, {0, 0}, 90, 0.7f);
    painted(*document, BrushTool::Paint, 2, {40, 10}, 60, 0.4f);
    const io::CoverMap& cover = *document->scene().cover();
    const auto bytes = io::encodeCoverMap(cover);
    ASSERT_TRUE(bytes);
    const auto file = std::filesystem::temp_directory_path() / ("wold_cover_" + std::to_string(getpid()) + ".png");
    ASSERT_TRUE(io::writeFile(file, *bytes));
    const auto read = io::readCoverMap(file, cover.size());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, cover);
    const auto other = io::readCoverMap(file, {128, 128});
    ASSERT_FALSE(other);
    EXPECT_NE(other.error().what.find("do not fit"), std::string::npos);
    std::filesystem::remove(file);
}

TEST(Painting, AStrokeWithTheBrushPaintsAndCtrlErases)
{
    const auto document = meadow();
    for (const bool erase : {false, true}) {
        Stroke stroke{*document, {.tool = BrushTool::Paint, .radius = 20, .strength = 1, .layer = 2}, {.inverted = erase}, "Paint"};
        stroke.to({-40, 0, 0});
        stroke.to({40, 0, 0});
        stroke.end();
        EXPECT_EQ(coverAt(*document, {0, 0}).painted, erase ? 0 : 1);
    }
    document->undo();
    EXPECT_EQ(coverAt(*document, {0, 0}), (io::Cover{2, 2, 0, 1}));
}

TEST(Painting, HolesAreShotThroughAndClosedAgain)
{
    const auto document = meadow();
    Picker picker;
    test::followed(picker, *document).prepare();
    const io::Ray down{.origin = {10.3, 200, 4.1}, .direction = {0, -1, 0}};
    const auto drawn = [&](bool closes) {
        Stroke stroke{*document, {.tool = BrushTool::Hole, .radius = 12}, {.inverted = closes}, "Hole"};
        stroke.to({10, 0, 4});
        stroke.end();
        test::followed(picker, *document);
    };
    EXPECT_EQ(picker.pick(down).surface, Surface::Terrain);
    painted(*document, BrushTool::Paint, 1, {10, 4}, 40);
    drawn(false);
    EXPECT_EQ(picker.pick(down).surface, Surface::None);
    EXPECT_FALSE(io::groundHeight(document->scene(), 10.3, 4.1));
    EXPECT_TRUE(io::groundHeight(document->scene(), 40, 4.1));
    EXPECT_EQ(coverAt(*document, {10, 4}), (io::Cover{1, 1, 0, 1, true})); // the paint stays
    painted(*document, BrushTool::Erase, 0, {10, 4}, 40);
    EXPECT_EQ(coverAt(*document, {10, 4}), io::Cover{.hole = true});       // and goes without the hole
    drawn(true);
    EXPECT_EQ(picker.pick(down).surface, Surface::Terrain);
    document->undo();
    test::followed(picker, *document);
    EXPECT_EQ(picker.pick(down).surface, Surface::None);
}

} // namespace
