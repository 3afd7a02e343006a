// The ground in other texels, and other ground: what becomes of heights, paint and objects, and that undo gives all of it back.
#include "editor/ground_edits.h"
#include "editor/painting.h"
#include "io/scene/resampling.h"
#include "tests/unit/editor/worlds.h"

#include <gtest/gtest.h>
#include <limits>

using namespace editor;

namespace {

io::HeightGrid plane(glm::ivec2 size, double metres, glm::dvec2 origin)
{
    io::HeightGrid grid{.size = size, .metresPerTexel = metres, .origin = origin};
    for (int z = 0; z < size.y; ++z)
        for (int x = 0; x < size.x; ++x)
            grid.metres.push_back(float(7 + 0.25 * (origin.x + x * metres) - 0.5 * (origin.y + z * metres)));
    return grid;
}

std::uint64_t hashOf(const io::Scene& scene) // of the ground, the paint and where they lie
{
    std::uint64_t hash = 14695981039346656037ull;
    const auto add = [&](const void* bytes, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 1099511628211ull;
    };
    const io::HeightMap& map = *scene.heights();
    const io::HeightGrid grid = map.read(map.texels());
    add(grid.metres.data(), grid.metres.size() * sizeof(float));
    add(&map.metresPerTexel, sizeof map.metresPerTexel);
    add(&map.origin, sizeof map.origin);
    if (const auto& cover = scene.cover()) {
        const auto texels = cover->read(cover->rect());
        add(texels.data(), texels.size() * sizeof texels[0]);
    }
    const std::string text = test::text(scene);
    add(text.data(), text.size());
    return hash;
}

struct GroundEdits : ::testing::Test {
    std::unique_ptr<Document> document = test::forest(40, 3);
    const io::Scene& scene = document->scene();
    void SetUp() override
    {
        io::Terrain terrain = scene.terrain(); // which lies where its heights do
        terrain.metresPerTexel = scene.heights()->metresPerTexel;
        terrain.origin = scene.heights()->origin;
        ASSERT_TRUE(setTerrain(*document, "Place", std::move(terrain)));
        const glm::ivec2 size = scene.heights()->size;
        const std::vector<std::uint32_t> paint(20 * 30, io::packed({.base = 1, .over = 1, .painted = 1}));
        changeCover(*document, "Paint", {.at = size / 2, .size = {20, 30}, .texels = paint});
    }
    NewGround after(const Reshaping& r)
    {
        io::Result<NewGround> ground = reshaped(scene, r);
        EXPECT_TRUE(ground) << ground.error().text();
        return *std::move(ground);
    }
    void apply(const Reshaping& r, bool follow = true) { replaceGround(*document, "Reshape", after(r), follow); }
};

TEST(Resampling, APlaneStaysThatPlane)
{
    const io::HeightGrid from = plane({33, 21}, 2, {-10, 30});
    for (const double metres : {0.5, 0.7, 2.0, 3.0, 8.0}) {
        const glm::ivec2 size = glm::ivec2{glm::dvec2{from.size - 1} * 2.0 / metres} + 1;
        const io::HeightGrid to = io::resampled(from, size, metres, from.origin), exact = plane(size, metres, from.origin);
        for (std::size_t i = 0; i < to.metres.size(); ++i)
            ASSERT_NEAR(to.metres[i], exact.metres[i], 2e-5) << metres;
    }
}

TEST(Resampling, TheSameTexelsAreTheSameBits)
{
    const auto map = test::hills(65, 2, 4);
    const io::HeightGrid from = map->read(map->texels());
    EXPECT_EQ(io::resampled(from, from.size, from.metresPerTexel, from.origin).metres, from.metres);
}

TEST(Resampling, FinerGroundGoesThroughTheOldPointsAndCoarserKeepsTheMean)
{
    const auto map = test::hills(65, 2, 4);
    const io::HeightGrid from = map->read(map->texels());
    const io::HeightGrid fine = io::resampled(from, {129, 129}, 1, from.origin);
    for (int z = 0; z < 65; ++z)
        for (int x = 0; x < 65; ++x)
            ASSERT_EQ(fine.at(2 * x, 2 * z), from.at(x, z));
    const io::HeightGrid coarse = io::resampled(from, {17, 17}, 8, from.origin);
    double mean = 0;
    for (int z = 14; z <= 18; ++z)
        for (int x = 14; x <= 18; ++x)
            mean += double(from.at(x, z)) * (x == 14 || x == 18 ? 0.125 : 0.25) * (z == 14 || z == 18 ? 0.125 : 0.25);
    EXPECT_NEAR(coarse.at(4, 4), mean, 1e-4);
}

TEST_F(GroundEdits, ResamplingKeepsPlaceHeightsAndPaint)
{
    const std::shared_ptr<const io::HeightMap> before = scene.heights();
    const io::CoverMap painted = *scene.cover();
    apply({.kind = Reshape::Resample, .width = 2 * before->size.x - 1});
    const io::HeightMap& now = *scene.heights();
    EXPECT_EQ(now.size, 2 * before->size - 1);
    EXPECT_EQ(now.metresPerTexel, before->metresPerTexel / 2);
    EXPECT_EQ(scene.terrain().metresPerTexel, now.metresPerTexel);
    EXPECT_EQ(now.origin, before->origin);
    ASSERT_EQ(scene.cover()->size(), now.size);
    for (int i = 0; i < before->size.x; ++i) {
        EXPECT_EQ(now.at(2 * i, 2 * i), before->at(i, i));
        EXPECT_EQ(scene.cover()->at(2 * i, 2 * i), painted.at(i, i));
    }
}

TEST_F(GroundEdits, CroppingIsExact)
{
    const std::shared_ptr<const io::HeightMap> before = scene.heights();
    const io::CoverMap painted = *scene.cover();
    const glm::ivec2 low = before->size / 4, high = before->size - before->size / 5;
    const auto placeOf = [&](glm::ivec2 texel) { return before->origin + glm::dvec2{texel} * before->metresPerTexel; };
    const NewGround inTexels = after({.kind = Reshape::Crop, .texels = true, .from = high, .to = low});
    apply({.kind = Reshape::Crop, .from = placeOf(low), .to = placeOf(high)});
    const io::HeightMap& now = *scene.heights();
    EXPECT_EQ(inTexels.heights.metres, now.read(now.texels()).metres);
    EXPECT_EQ(now.size, high - low + 1);
    EXPECT_EQ(now.origin, placeOf(low));
    for (int z = 0; z < now.size.y; ++z)
        for (int x = 0; x < now.size.x; ++x) {
            ASSERT_EQ(now.at(x, z), before->at(x + low.x, z + low.y));
            ASSERT_EQ(scene.cover()->at(x, z), painted.at(x + low.x, z + low.y));
        }
}

TEST_F(GroundEdits, CroppingWiderGoesOnBeyondTheEdges)
{
    const io::HeightGrid old = scene.heights()->read(scene.heights()->texels());
    for (const GroundEdge edge : {GroundEdge::Extend, GroundEdge::Wrap}) {
        const NewGround wider = after({.kind = Reshape::Crop, .texels = true, .from = {-10, 5}, .to = glm::dvec2{old.size} + 20.0, .edge = edge});
        ASSERT_EQ(wider.heights.size, old.size + glm::ivec2(31, 16));
        EXPECT_EQ(wider.heights.origin, old.origin + glm::dvec2(-10, 5) * old.metresPerTexel);
        for (int z = 0; z < wider.heights.size.y; ++z)
            for (int x = 0; x < wider.heights.size.x; ++x) {
                const int ox = x - 10, oz = z + 5;
                const float expected = edge == GroundEdge::Extend ? old.clampedAt(ox, oz) : old.at((ox + old.size.x) % old.size.x, oz % old.size.y);
                ASSERT_EQ(wider.heights.at(x, z), expected);
            }
    }
    EXPECT_FALSE(reshaped(scene, {.kind = Reshape::Crop, .texels = true, .from = {-1e6, 0}, .to = {1e6, 10}}));
    EXPECT_FALSE(reshaped(scene, {.kind = Reshape::Crop, .texels = true, .from = {-50, -50}, .to = {-10, -10}}));
}

TEST_F(GroundEdits, GrassGoesAlongWithGroundThatIsMoved)
{
    const glm::dvec2 corner = scene.heights()->origin;
    setGrass(*document, "Grass", io::Grass{.map = {}, .metresPerTexel = 2, .origin = corner, .kinds = {{.name = "meadow"}}});
    io::TexelTiles<std::uint32_t> field{glm::ivec2{40, 40}};
    const std::vector<std::uint32_t> one{io::packed(io::GrassCover{{0, 0}, {1, 0}, 1})};
    setGrassMap(*document, "Grow", std::make_shared<const io::GrassMap>(field.with(one, {1, 1}, {10, 12}), 2, corner), field.rect());
    ASSERT_EQ(scene.grassMap()->at(corner + glm::dvec2(20, 24)).density[0], 1);
    apply({.kind = Reshape::Offset, .by = {8, -6}});
    const glm::dvec2 moved = glm::round(glm::dvec2{8, -6} / scene.heights()->metresPerTexel) * scene.heights()->metresPerTexel;
    EXPECT_EQ(scene.grassMap()->at(corner + glm::dvec2(20, 24) + moved).density[0], 1);
    EXPECT_EQ(scene.grassMap()->at(corner + glm::dvec2(20, 24)).density[0], 0);
    document->undo();
    EXPECT_EQ(scene.grassMap()->at(corner + glm::dvec2(20, 24)).density[0], 1);
}

TEST_F(GroundEdits, OffsetWrapsOrExtendsAndRaises)
{
    const std::shared_ptr<const io::HeightMap> before = scene.heights();
    const io::HeightGrid old = before->read(before->texels());
    const NewGround wrapped = after({.kind = Reshape::Offset, .texels = true, .by = {7, -3}, .edge = GroundEdge::Wrap});
    const NewGround extended = after({.kind = Reshape::Offset, .by = glm::dvec2{7, -3} * old.metresPerTexel, .raise = 2, .edge = GroundEdge::Extend});
    for (int z = 0; z < old.size.y; ++z)
        for (int x = 0; x < old.size.x; ++x) {
            ASSERT_EQ(wrapped.heights.at(x, z), old.at((x - 7 + old.size.x) % old.size.x, (z + 3) % old.size.y));
            ASSERT_EQ(extended.heights.at(x, z), old.clampedAt(x - 7, z + 3) + 2);
        }
    apply({.kind = Reshape::Offset, .texels = true, .by = {1e6, 12345}, .edge = GroundEdge::Wrap});
    apply({.kind = Reshape::Offset, .texels = true, .by = {-1e6, -12345}, .edge = GroundEdge::Wrap});
    EXPECT_EQ(scene.heights()->read(before->texels()).metres, old.metres);
}

TEST_F(GroundEdits, ObjectsKeepTheirHeightAboveTheGroundIfTheyFollow)
{
    const io::HeightMap before = *scene.heights();
    const std::vector<io::Object> objects{scene.objects().begin(), scene.objects().end()};
    apply({.kind = Reshape::Offset, .raise = 12.5});
    for (const io::Object& object : objects) {
        const glm::dvec3 &was = object.transform.position, &is = scene.at(object.id).transform.position;
        const bool over = before.contains(was.x, was.z);
        EXPECT_NEAR(is.y, was.y + (over ? 12.5 : 0), 1e-4);
        EXPECT_EQ(glm::dvec2(is.x, is.z), glm::dvec2(was.x, was.z));
    }
    document->undo();
    apply({.kind = Reshape::Offset, .raise = 12.5}, false);
    for (const io::Object& object : objects)
        EXPECT_EQ(scene.at(object.id), object);
}

TEST_F(GroundEdits, EachIsOneStepAndUndoGivesBackEveryBit)
{
    const auto steps = document->history().position();
    const std::uint64_t before = hashOf(scene);
    const std::shared_ptr<const io::HeightMap> old = scene.heights();
    for (const Reshaping& r : {Reshaping{.kind = Reshape::Resample, .width = 50}, Reshaping{.kind = Reshape::Resample, .metresPerTexel = old->metresPerTexel * 0.8},
                               Reshaping{.kind = Reshape::Crop, .texels = true, .from = {3, 4}, .to = {40, 60}},
                               Reshaping{.kind = Reshape::Offset, .texels = true, .by = {5, 9}, .raise = -3, .edge = GroundEdge::Wrap}}) {
        apply(r);
        EXPECT_EQ(document->history().position(), steps + 1);
        const std::uint64_t changed = hashOf(scene);
        EXPECT_NE(changed, before);
        document->undo();
        EXPECT_EQ(hashOf(scene), before);
        document->redo();
        EXPECT_EQ(hashOf(scene), changed);
        document->undo();
        EXPECT_EQ(hashOf(scene), before);
    }
}

TEST_F(GroundEdits, NewGroundTakesThePlaceOfTheOldOne)
{
    const std::uint64_t before = hashOf(scene);
    replaceGround(*document, "New", {.heights = plane({40, 70}, 3, {-60, -90}), .range = glm::dvec2{-5, 300}}, true);
    EXPECT_EQ(scene.heights()->size, glm::ivec2(40, 70));
    EXPECT_EQ(scene.terrain().origin, glm::dvec2(-60, -90));
    EXPECT_EQ(scene.terrain().minHeight, -5);
    EXPECT_EQ(scene.terrain().maxHeight, 300);
    EXPECT_EQ(scene.cover(), nullptr);
    EXPECT_TRUE(scene.terrain().coverMap.empty());
    EXPECT_FALSE(scene.terrain().heightMap.empty());
    document->undo();
    EXPECT_EQ(hashOf(scene), before);
}

TEST_F(GroundEdits, BadValuesSayWhyAndChangeNothing)
{
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN(), kEndless = std::numeric_limits<double>::infinity();
    const Reshaping bad[] = {{.kind = Reshape::Resample},
                             {.kind = Reshape::Resample, .width = 1},
                             {.kind = Reshape::Resample, .width = -3},
                             {.kind = Reshape::Resample, .width = 9000},
                             {.kind = Reshape::Resample, .width = 33, .metresPerTexel = 1},
                             {.kind = Reshape::Resample, .metresPerTexel = -1},
                             {.kind = Reshape::Resample, .metresPerTexel = 1e-4},
                             {.kind = Reshape::Resample, .metresPerTexel = kNothing},
                             {.kind = Reshape::Resample, .metresPerTexel = 1e6},
                             {.kind = Reshape::Crop, .from = {9e6, 0}, .to = {9.1e6, 10}},
                             {.kind = Reshape::Crop, .texels = true, .from = {5, 5}, .to = {5, 50}},
                             {.kind = Reshape::Crop, .from = {kNothing, 0}, .to = {10, 10}},
                             {.kind = Reshape::Offset, .by = {kEndless, 0}},
                             {.kind = Reshape::Offset, .raise = kNothing}};
    const std::uint64_t before = hashOf(scene);
    for (const Reshaping& r : bad) {
        const auto ground = reshaped(scene, r);
        ASSERT_FALSE(ground);
        EXPECT_GT(ground.error().text().size(), 10u);
    }
    EXPECT_EQ(hashOf(scene), before);
    const auto bare = test::forest(3, 1, false);
    EXPECT_FALSE(reshaped(bare->scene(), {.width = 33}));
}

} // namespace
