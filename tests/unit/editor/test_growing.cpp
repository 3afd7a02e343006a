// Growing grass: what a brush makes of a texel, and that steps, files and lists of kinds keep it.
#include "editor/painting.h"
#include "editor/stroke.h"
#include "io/files/grass_map_file.h"
#include "tests/unit/editor/worlds.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace editor;

namespace {

std::unique_ptr<Document> meadow()
{
    auto document = test::forest(0, 4);
    io::Grass grass;
    grass.kinds = {{.name = "meadow"}, {.name = "reeds"}, {.name = "flowers"}};
    setGrass(*document, "Kinds", grass);
    return document;
}

void dab(Document& document, const Brush& brush, float amount = 1)
{
    const io::Scene& scene = document.scene();
    const auto patch = growOn(*scene.heights(), grassMapOf(scene), brush, {.amount = amount});
    ASSERT_TRUE(patch);
    changeGrassMap(document, "Grass", *patch);
}

io::TexelTiles<std::uint32_t> nothing(const Document& document)
{
    return io::TexelTiles<std::uint32_t>{document.scene().grassMap()->size()};
}

TEST(Grass, BitsComeBack)
{
    for (int kind = 0; kind < 16; ++kind)
        for (int byte = 1; byte < 255; byte += 2) {
            const io::GrassCover cover{{kind, 15 - kind}, {float(byte) / 255, float(255 - byte) / 255}, float(byte) / 128};
            EXPECT_EQ(io::unpackedGrass(io::packed(cover)), cover);
        }
    EXPECT_EQ(io::packed(io::GrassCover{}), 0u);
    EXPECT_EQ(io::packed(io::GrassCover{{3, 4}, {0, 0}, 1}), 0u);
}

TEST(Grass, AThirdKindTakesThePlaceOfTheSparser)
{
    const io::GrassCover both{{0, 1}, {0.8f, 0.2f}, 1};
    const io::GrassCover after = grown(both, {.tool = BrushTool::Grow, .kind = 2, .density = 0.5f}, 1);
    EXPECT_EQ(after.kind[0], 0);
    EXPECT_EQ(after.kind[1], 2);
    EXPECT_FLOAT_EQ(after.density[0], 0.8f);
    EXPECT_FLOAT_EQ(after.density[1], 0.5f);
}

TEST(Grass, MowingOneKindLeavesTheOther)
{
    const io::GrassCover both{{0, 1}, {0.8f, 0.2f}, 1};
    EXPECT_FLOAT_EQ(grown(both, {.tool = BrushTool::Mow, .kind = 1}, 1).density[1], 0);
    EXPECT_FLOAT_EQ(grown(both, {.tool = BrushTool::Mow, .kind = 1}, 1).density[0], 0.8f);
    EXPECT_EQ(io::packed(grown(both, {.tool = BrushTool::Mow, .everyKind = true}, 1)), 0u);
}

TEST(Grass, GrownThenMownIsNothing)
{
    auto document = meadow();
    dab(*document, {.tool = BrushTool::Grow, .radius = 6, .kind = 1});
    EXPECT_FALSE(document->scene().grassMap()->field() == nothing(*document));
    dab(*document, {.tool = BrushTool::Mow, .radius = 9, .falloff = 0, .kind = 1});
    EXPECT_TRUE(document->scene().grassMap()->field() == nothing(*document));
}

TEST(Grass, AStrokeIsOneStepThatComesBackToTheBit)
{
    auto document = meadow();
    dab(*document, {.tool = BrushTool::Grow, .radius = 3, .kind = 0});
    const io::GrassMap before = *document->scene().grassMap();
    const std::size_t steps = document->history().position();
    {
        Stroke stroke{*document, {.tool = BrushTool::Grow, .radius = 4, .kind = 1}, {}, "Grow grass"};
        stroke.to({-6, 0, 0});
        stroke.to({6, 0, 2});
        stroke.end();
    }
    EXPECT_EQ(document->history().position(), steps + 1);
    const io::GrassMap after = *document->scene().grassMap();
    EXPECT_FALSE(after == before);
    document->undo();
    EXPECT_TRUE(*document->scene().grassMap() == before);
    document->redo();
    EXPECT_TRUE(*document->scene().grassMap() == after);
}

TEST(Grass, SlopesAndHeightsLimitTheBrush)
{
    auto document = meadow();
    dab(*document, {.tool = BrushTool::Grow, .radius = 6, .altitude = {1000, 2000}, .kind = 1});
    EXPECT_TRUE(document->scene().grassMap()->field() == nothing(*document));
}

TEST(Grass, ARemovedKindIsGoneAndTheOthersKeepTheirNumbers)
{
    auto document = meadow();
    dab(*document, {.tool = BrushTool::Grow, .radius = 6, .falloff = 0, .kind = 1});
    dab(*document, {.tool = BrushTool::Grow, .radius = 6, .falloff = 0, .kind = 2});
    auto kinds = document->scene().grass().kinds;
    kinds.erase(kinds.begin() + 1);
    const int numbers[] = {0, -1, 1};
    setGrassKinds(*document, "Remove", kinds, numbers);
    const io::GrassCover cover = document->scene().grassMap()->at({0, 0});
    EXPECT_FLOAT_EQ(cover.density[0] + cover.density[1], 1);
    EXPECT_EQ(cover.kind[cover.density[0] > 0 ? 0 : 1], 1);
    document->undo();
    EXPECT_EQ(document->scene().grass().kinds.size(), 3u);
}

TEST(Grass, AFileHoldsItToTheBit)
{
    auto document = meadow();
    dab(*document, {.tool = BrushTool::Grow, .radius = 6, .kind = 1, .density = 0.7f, .height = 1.4f});
    const auto bytes = io::encodeGrassMap(*document->scene().grassMap());
    ASSERT_TRUE(bytes);
    const std::filesystem::path file = std::filesystem::temp_directory_path() / ("wold_grass_" + std::to_string(::getpid()) + ".png");
    ASSERT_TRUE(io::writeFile(file, *bytes));
    const auto read = io::readGrassTexels(file);
    std::filesystem::remove(file);
    ASSERT_TRUE(read);
    EXPECT_TRUE(*read == document->scene().grassMap()->field());
}

} // namespace
