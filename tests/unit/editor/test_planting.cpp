// Where plants stand: patterns of the plane, what rules leave of them, objects and instances that come of it.
#include "tests/unit/editor/worlds.h"

#include "editor/placement.h"
#include "editor/scatter.h"
#include "editor/scatter_brush.h"
#include "editor/scatter_edits.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

using namespace editor;

namespace {

std::vector<PatternPoint> sorted(std::vector<PatternPoint> points)
{
    std::ranges::sort(points, [](const PatternPoint& a, const PatternPoint& b) { return std::tie(a.at.x, a.at.y) < std::tie(b.at.x, b.at.y); });
    return points;
}

double nearest(const std::vector<PatternPoint>& points, auto&& counts)
{
    const std::vector<PatternPoint> all = sorted(points);
    double least = 1e9;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size() && all[j].at.x - all[i].at.x < least; ++j)
            if (counts(all[i], all[j])) least = std::min(least, glm::distance(all[i].at, all[j].at));
    return least;
}

constexpr auto kAny = [](const PatternPoint&, const PatternPoint&) { return true; };

// Flat ground of 1024 m with templates of a forest, and a layer of two species.
struct Field {
    std::unique_ptr<Document> document = test::forest(0, 1);
    io::ScatterLayer layer{.id = io::ScatterId{1}, .name = "wood", .species = {{.templateName = "blob"}, {.templateName = "leaf", .weight = 3}}};

    Field()
    {
        setHeights(*document, "Flat", test::flat(513, 0), {{0, 0}, {513, 513}});
        document->takeChanges();
    }
    const io::Scene& scene() const { return document->scene(); }
    Planting planting() const { return {plantRules(scene(), document->assets(), layer), scene()}; }
    LayerTiles tiles() const { return layerTiles(scene(), layer); }
    void run(InstanceSlots slots) { setInstances(*document, "Edit", std::move(slots)); }
    std::size_t count(const PlantRegion& region = PlantRegion::everywhere()) const { return countIn(scene().instances(layer.id), region); }
    std::uint64_t hash() const { return io::instanceHash(scene().instances(layer.id)); }
    glm::dvec2 middle() const { return scene().heights()->origin + glm::dvec2{scene().heights()->size} * scene().heights()->metresPerTexel / 2.0; }
};

} // namespace

TEST(PlantPattern, IsAsDenseAsAskedWhereTheSpacingAllows)
{
    for (const double spacing : {0.0, 1.0, 2.0})
        for (const double density : {0.02, 0.1, 0.12}) {
            const PlantPattern pattern{{.kinds = {{}}, .density = density, .spacing = spacing, .seed = 5}};
            const PlaneRect part{{-311, 97}, {489, 897}};
            EXPECT_NEAR(double(pattern.points(part).size()), density * 640'000, density * 640'000 * 0.05) << spacing << " " << density;
        }
}

TEST(PlantPattern, KeepsEachSpacing)
{
    const PlantPattern pattern{{.kinds = {{.weight = 1, .spacing = 5}, {.weight = 4, .room = 0.8f}}, .density = 0.3, .spacing = 1.2, .seed = 9}};
    const auto points = pattern.points({{-200, -200}, {200, 200}});
    ASSERT_GT(points.size(), 10'000u);
    EXPECT_GE(nearest(points, kAny), 1.2);
    EXPECT_LT(nearest(points, kAny), 1.3);
    EXPECT_GE(nearest(points, [](auto& a, auto& b) { return a.kind == 0 && b.kind == 0; }), 5);
    EXPECT_GE(nearest(points, [](auto& a, auto& b) { return a.kind == 1 && b.kind == 1; }), 1.6f);
}

TEST(PlantPattern, PartsAreTheWholeAndSoAgreeAtTheirBorders)
{
    const PlantPattern pattern{{.kinds = {{}, {}}, .density = 0.16, .spacing = 2, .seed = 77}};
    const auto whole = sorted(pattern.points({{-128, -128}, {128, 128}}));
    std::vector<PatternPoint> parts;
    for (const int x : {64, -128, 0, -64})
        for (const int z : {-64, 64, -128, 0}) {
            const auto some = pattern.points({{x, z}, {x + 64, z + 64}});
            parts.insert(parts.end(), some.begin(), some.end());
        }
    parts = sorted(parts);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(parts[i].at, whole[i].at);
        EXPECT_EQ(parts[i].seed, whole[i].seed);
        EXPECT_EQ(parts[i].kind, whole[i].kind);
    }
    EXPECT_GE(nearest(parts, kAny), 2);
}

TEST(PlantPattern, WeightsAreSharesAndSeedsOtherPatterns)
{
    const auto points = PlantPattern{{.kinds = {{.weight = 1}, {.weight = 3}, {.weight = 0}}, .density = 0.1, .seed = 3}}.points({{0, 0}, {400, 400}});
    const auto share = [&](std::uint32_t kind) { return double(std::ranges::count(points, kind, &PatternPoint::kind)) / double(points.size()); };
    EXPECT_NEAR(share(0), 0.25, 0.02);
    EXPECT_EQ(share(2), 0);
    const auto other = PlantPattern{{.kinds = {{.weight = 1}, {.weight = 3}, {.weight = 0}}, .density = 0.1, .seed = 4}}.points({{0, 0}, {400, 400}});
    EXPECT_NE(points.front().at, other.front().at);
}

TEST(PlantRegion, LinesAroundAreFilledEvenOdd)
{
    const PlantRegion corner = PlantRegion::polygon({{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}});
    EXPECT_TRUE(corner.contains({5, 4}));
    EXPECT_FALSE(corner.contains({5, 8}));
    EXPECT_TRUE(corner.contains({1, 8}));
    EXPECT_FALSE(corner.contains({-1, 5}));
    EXPECT_TRUE(PlantRegion::disc({3, 3}, 2).contains({4, 4}));
    EXPECT_FALSE(PlantRegion::disc({3, 3}, 2).contains({4.5, 4.5}));
}

TEST(Planting, TwoPassesAreAsOneAndErasingLeavesNothing)
{
    Field field;
    const std::uint64_t before = field.hash();
    const PlantRegion disc = PlantRegion::disc(field.middle(), 40);
    field.run(planted(field.tiles(), field.planting(), disc));
    const double wanted = double(field.layer.density) * std::numbers::pi * 1600;
    EXPECT_NEAR(double(field.count()), wanted, wanted * 0.05);
    const std::uint64_t once = field.hash();
    field.run(planted(field.tiles(), field.planting(), disc));
    EXPECT_EQ(field.hash(), once);
    EXPECT_EQ(field.document->history().position(), 2u); // the ground and one pass: the second changed nothing

    field.layer.seed = 8; // another pattern fills only what the first left free
    field.run(planted(field.tiles(), field.planting(), disc));
    EXPECT_LT(double(field.count()), wanted * 1.08);
    field.run(erased(field.tiles(), disc));
    EXPECT_EQ(field.count(), 0u);
    EXPECT_EQ(field.hash(), before);
    field.document->undo();
    field.document->undo();
    EXPECT_EQ(field.hash(), once);
}

TEST(Planting, ThinsToAShareOnceAndTakesOnlySpeciesThatAreMeant)
{
    Field field;
    const PlantRegion all = PlantRegion::everywhere();
    field.run(planted(field.tiles(), field.planting(), all));
    const auto full = double(field.count());
    EXPECT_NEAR(full, 0.1 * 1024 * 1024, 0.1 * 1024 * 1024 * 0.05);
    field.run(thinned(field.tiles(), all, 0.4));
    EXPECT_NEAR(double(field.count()), full * 0.4, full * 0.02);
    const std::uint64_t once = field.hash();
    field.run(thinned(field.tiles(), all, 0.4));
    EXPECT_EQ(field.hash(), once);

    const auto countOf = [&](int species) {
        std::size_t count = 0;
        for (const auto& [place, tile] : field.scene().instances(field.layer.id))
            count += std::size_t(std::ranges::count(tile->instances, species, &io::Instance::species));
        return count;
    };
    const std::size_t blobs = countOf(0), leaves = countOf(1);
    EXPECT_NEAR(double(blobs) * 3, double(leaves), double(leaves) * 0.1);
    LayerTiles only = field.tiles();
    only.species = {true, false};
    field.run(erased(only, all));
    EXPECT_EQ(countOf(0), 0u);
    EXPECT_EQ(countOf(1), leaves);
    field.run(replaced(field.tiles(), field.planting().rules(), all, 1, 0));
    EXPECT_EQ(countOf(0), leaves);
    EXPECT_EQ(countOf(1), 0u);
}

TEST(Planting, RulesHold)
{
    Field field;
    setHeights(*field.document, "Hills", test::hills(513, 1, 4), {{0, 0}, {513, 513}});
    io::Terrain terrain = field.scene().terrain();
    terrain.layers = {{.name = "grass"}, {.name = "rock", .slope = {25, 90}, .blend = 0.01f}};
    ASSERT_TRUE(setTerrain(*field.document, "Layers", terrain));
    field.layer.slope = {5, 40};
    field.layer.altitude = {field.scene().heights()->min + 2, field.scene().heights()->max - 2};
    field.layer.ground = "grass";
    field.layer.align = 0.5f;
    const auto all = [](const glm::dvec2&) { return true; };
    const Planting planting = field.planting();
    const auto plants = planting.plants(planting.reach(), all);
    ASSERT_GT(plants.size(), 100u);
    const io::HeightMap& map = *field.scene().heights();
    for (const Plant& plant : plants) {
        const glm::dvec3& at = plant.transform.position;
        const glm::dvec3 normal = *map.normal(at.x, at.z);
        const double slope = glm::degrees(std::acos(normal.y)), height = *map.height(at.x, at.z);
        EXPECT_GE(slope, 5);
        EXPECT_LE(slope, 25.2); // steeper ground is rock
        EXPECT_GE(height, double(field.layer.altitude.x));
        EXPECT_LE(height, double(field.layer.altitude.y));
        const glm::dvec3 up = io::orientation(plant.transform.rotation) * glm::dvec3{0, 1, 0};
        EXPECT_NEAR(glm::dot(up, glm::normalize(normal + glm::dvec3{0, 1, 0})), 1, 1e-4);
        EXPECT_GE(plant.transform.scale.x, 0.8f);
        EXPECT_LE(plant.transform.scale.x, 1.2f);
    }
    field.layer.ground = "no such layer";
    EXPECT_TRUE(field.planting().plants(planting.reach()).empty());
}

TEST(Planting, KeepsClearOfObjects)
{
    Field field;
    io::Template rock = *field.scene().find(field.scene().findTemplate("pyramid"));
    rock.footprint = 4;
    setTemplate(*field.document, "Footprint", field.scene().findTemplate("pyramid"), rock);
    const glm::dvec2 middle = field.middle();
    addObjects(*field.document, "Rock", {{.id = field.document->freshId(), .templateId = field.scene().findTemplate("pyramid"), .transform = {.position = {middle.x, 0, middle.y}}}});
    field.layer.clearance = 3;
    field.run(planted(field.tiles(), field.planting(), PlantRegion::everywhere()));
    EXPECT_EQ(field.count(PlantRegion::disc(middle, 6.9)), 0u);
    EXPECT_GT(field.count(PlantRegion::disc(middle, 12)), 10u);
}

TEST(Planting, RuleLayersFollowTheGroundAndKeepWhatWasDoneByHand)
{
    Field field;
    field.layer.rule = true;
    const PlaneRect all = PlantRegion::everywhere().bounds();
    field.run(*evaluated(field.tiles(), field.planting(), all));
    const std::uint64_t first = field.hash();
    const auto full = double(field.count());
    EXPECT_NEAR(full, 0.1 * 1024 * 1024, 0.1 * 1024 * 1024 * 0.05);
    field.run(*evaluated(field.tiles(), field.planting(), all));
    EXPECT_EQ(field.hash(), first);

    const glm::dvec2 middle = field.middle();
    field.run(erased(field.tiles(), PlantRegion::disc(middle, 20)));
    field.run(*evaluated(field.tiles(), field.planting(), all));
    EXPECT_EQ(field.count(PlantRegion::disc(middle, 19)), 0u); // nothing came back
    Field other;
    field.layer.seed = 99;
    field.run(planted(field.tiles(), field.planting(), PlantRegion::disc(middle, 10)));
    const std::size_t byHand = field.count(PlantRegion::disc(middle, 10));
    EXPECT_GT(byHand, 20u);
    field.layer.seed = 1;
    field.layer.altitude = {50, 100}; // now no ground is high enough
    field.run(*evaluated(field.tiles(), field.planting(), all));
    EXPECT_EQ(field.count(), byHand);

    field.layer.altitude = {-100, 100};
    field.run(*evaluated(field.tiles(), field.planting(), {middle, middle + 1.0})); // one tile alone
    const std::size_t some = field.count();
    EXPECT_GT(some, byHand);
    EXPECT_LT(double(some), full / 10);
    field.run(*evaluated(field.tiles(), field.planting(), all));
    const std::uint64_t again = field.hash();
    LayerTiles tiles = field.tiles();
    for (int z = -8; z < 16; ++z) // tile by tile it is the same
        for (int x = -8; x < 16; ++x)
            applySlots(tiles.tiles, *evaluated(tiles, field.planting(), {glm::dvec2{x, z} * 64.0 + 1.0, glm::dvec2{x, z} * 64.0 + 2.0}));
    EXPECT_EQ(io::instanceHash(tiles.tiles), again);
    EXPECT_FALSE(evaluated(field.tiles(), field.planting(), all, [](float, std::string_view) { return false; }));
}

TEST(Planting, RulesKeepAwayFromWhatWasPlantedByHand)
{
    Field field;
    field.layer.rule = true;
    const PlantRegion disc = PlantRegion::disc(field.middle(), 60);
    field.layer.seed = 99;
    field.run(planted(field.tiles(), field.planting(), disc));
    field.layer.seed = 1;
    field.run(*evaluated(field.tiles(), field.planting(), PlantRegion::everywhere().bounds()));
    const double wanted = 0.1 * std::numbers::pi * 3600;
    EXPECT_NEAR(double(field.count(disc)), wanted, wanted * 0.05); // those by hand count
    std::vector<PatternPoint> all;
    for (const auto& [place, tile] : field.scene().instances(field.layer.id))
        for (const io::Instance& instance : tile->instances) {
            const glm::dvec3 at = transformOf(place, instance).position;
            if (disc.contains({at.x, at.z})) all.push_back({.at = {at.x, at.z}});
        }
    EXPECT_GE(nearest(all, kAny), double(field.layer.spacing));
}

TEST(Planting, GrowsOnWhatLiesOnTopWhereAsked)
{
    Field field;
    const Planting planting{field.planting().rules(), field.scene(), [](double x, double z) -> std::optional<PlantSpot> {
                                if (x < 10) return std::nullopt;
                                return PlantSpot{{x, 7, z}, {0, 1, 0}};
                            }};
    const auto plants = planting.plants({{0, 0}, {40, 40}});
    ASSERT_FALSE(plants.empty());
    for (const Plant& plant : plants) {
        EXPECT_GE(plant.transform.position.x, 10);
        EXPECT_GT(plant.transform.position.y, 6.9); // of the model's foot
    }
}

TEST(Planting, LayersThatAreNotShownAreNotPicked)
{
    Field field;
    setScatterLayers(*field.document, "Layer", {field.layer});
    const ScatterBrush brush{.mode = ScatterMode::Single};
    Picker picker;
    test::followed(picker, *field.document);
    ScatterStroke stroke{*field.document, picker, brush, field.layer.id, "One"};
    stroke.to({field.middle().x, 0, field.middle().y});
    stroke.end();
    ASSERT_EQ(field.count(), 1u);
    const io::Ray down{.origin = {field.middle().x, 50, field.middle().y}, .direction = {0, -1, 0}};
    EXPECT_EQ(test::followed(picker, *field.document).pick(down).surface, Surface::Instance);
    field.layer.shown = false;
    setScatterLayers(*field.document, "Hide", {field.layer});
    EXPECT_EQ(test::followed(picker, *field.document).pick(down).surface, Surface::Terrain);
    field.document->undo();
    EXPECT_EQ(test::followed(picker, *field.document).pick(down).surface, Surface::Instance);
}

TEST(Scatter, CopiesKeepTheirDistanceAndRepeatBySeed)
{
    const auto make = [] {
        auto document = test::forest(30, 1);
        io::Template what = *document->scene().find(io::TemplateId{2});
        what.footprint = 1.5f;
        setTemplate(*document, "Footprint", io::TemplateId{2}, what);
        return document;
    };
    constexpr double kDensity = 0.05, kRadius = 60;
    const auto strew = [](Document& document, glm::dvec2 slope = {0, 90}) {
        PlantRules rules = plantRules(document.scene(), document.assets(), std::vector{io::TemplateId{1}, io::TemplateId{2}});
        rules.density = kDensity;
        rules.seed = 11;
        rules.slope = slope;
        return scatter(document, "Scatter", {rules, document.scene()}, PlantRegion::disc({0, 0}, kRadius));
    };
    const auto document = make();
    const auto ids = strew(*document);
    const double wanted = kDensity * std::numbers::pi * kRadius * kRadius;
    EXPECT_NEAR(double(ids.size()), wanted, wanted * 0.05);

    const auto footprint = [&](const io::Object& o) { return o.templateId == io::TemplateId{2} ? 1.5 : 0.0; };
    const auto flat = [](const io::Object& o) { return glm::dvec2{o.transform.position.x, o.transform.position.z}; };
    for (const io::ObjectId id : ids) {
        const io::Object& one = document->scene().at(id);
        EXPECT_LE(glm::length(flat(one)), kRadius);
        EXPECT_NEAR(boundsOf(*document, std::vector{id}).min.y, *document->scene().heights()->height(flat(one).x, flat(one).y), 0.01);
        for (const io::Object& other : document->scene().objects())
            if (other.id != id && glm::distance(flat(one), flat(other)) + 1e-9 < footprint(one) + footprint(other))
                FAIL() << io::number(id) << " stands in " << io::number(other.id);
    }
    const auto again = make();
    strew(*again);
    EXPECT_EQ(test::text(again->scene()), test::text(document->scene()));
    EXPECT_TRUE(strew(*document).empty()); // a second time there is no room
    EXPECT_EQ(document->history().position(), 2u);
    document->undo();
    EXPECT_EQ(document->scene().objects().size(), 30u);

    for (const io::ObjectId id : strew(*document, {0, 15})) {
        const io::Object& one = document->scene().at(id);
        EXPECT_GE(document->scene().heights()->normal(flat(one).x, flat(one).y)->y, std::cos(glm::radians(15.001)));
    }
}
