#include "tests/unit/editor/worlds.h"

#include "editor/instance_edits.h"
#include "editor/script.h"
#include "editor/selection.h"
#include "io/base/random.h"
#include "io/files/json.h"

#include <gtest/gtest.h>

using namespace editor;

namespace {

const io::ScatterId kLayer{1};

// A forest of `count` instances of "pyramid" and "blob" and no objects.
std::unique_ptr<Document> planted(int count, bool rule = false)
{
    auto document = test::forest(0, 5);
    setScatterLayers(*document, "Layer", {io::ScatterLayer{.id = kLayer, .name = "wood", .rule = rule, .species = {{.templateName = "pyramid"}, {.templateName = "blob"}}}});
    io::Random random{17};
    std::map<glm::ivec2, io::InstanceTile, io::TileOrder> tiles;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 at{random.range(-200, 200), random.range(0, 20), random.range(-200, 200)};
        const io::PlacedInstance placed = io::instanceAt({.position = at, .rotation = {0, random.range(0, 360), 3}, .scale = glm::vec3{random.range(0.5f, 2)}}, random.below(2));
        tiles[placed.tile].instances.push_back(placed.instance);
    }
    std::vector<SwapInstances::Slot> slots;
    for (auto& [place, tile] : tiles)
        slots.emplace_back(io::LayerTile{kLayer, place}, std::make_shared<const io::InstanceTile>(std::move(tile)));
    setInstances(*document, "Plant", std::move(slots));
    return document;
}

std::uint64_t hashOf(const Document& document)
{
    return io::instanceHash(document.scene().instances(kLayer));
}

std::vector<io::ObjectId> someInstances(const Document& document, std::size_t count)
{
    std::vector<io::ObjectId> ids;
    for (const auto& [place, tile] : document.scene().instances(kLayer))
        for (std::uint32_t i = 0; i < tile->instances.size() && ids.size() < count; i += 3)
            ids.push_back(document.scene().idOf({{kLayer, place}, i}));
    return ids;
}

io::Ray randomRay(io::Random& random)
{
    const glm::dvec3 from{random.range(-260, 260), random.range(5, 80), random.range(-260, 260)};
    const glm::dvec3 to{random.range(-200, 200), random.range(0, 25), random.range(-200, 200)};
    return {.origin = from, .direction = glm::normalize(to - from)};
}

} // namespace

TEST(EditedInstances, AGestureIsOneStepThatCostsItsTiles)
{
    const auto document = planted(20'000);
    const std::uint64_t before = hashOf(*document);
    const std::size_t bytes = document->history().bytes(), steps = document->history().position();
    const io::LayerTile at{kLayer, {0, 0}};
    {
        const Gesture gesture{*document, "Stroke"};
        for (int i = 0; i < 30; ++i) {
            io::InstanceTile tile = *document->scene().find(at);
            tile.instances.push_back({.x = std::uint16_t(i * 100)});
            setInstances(*document, "Stroke", {{at, std::make_shared<const io::InstanceTile>(std::move(tile))}});
        }
    }
    EXPECT_EQ(document->history().position(), steps + 1);
    EXPECT_LT(document->history().bytes() - bytes, 2 * document->scene().find(at)->bytes() + 1000);
    EXPECT_NE(hashOf(*document), before);
    const std::uint64_t after = hashOf(*document);
    document->undo();
    EXPECT_EQ(hashOf(*document), before);
    document->redo();
    EXPECT_EQ(hashOf(*document), after);
}

TEST(EditedInstances, ALayerGoesWithItsInstancesAndComesBack)
{
    const auto document = planted(500);
    const std::uint64_t before = hashOf(*document);
    removeScatterLayer(*document, "Delete layer", kLayer);
    EXPECT_TRUE(document->scene().scatterLayers().empty());
    EXPECT_TRUE(document->scene().instances(kLayer).empty());
    document->undo();
    EXPECT_EQ(document->scene().scatterLayers().size(), 1u);
    EXPECT_EQ(hashOf(*document), before);
}

TEST(EditedInstances, PromotedTheyStandWhereTheyStoodAndGoBackTheSame)
{
    const auto document = planted(800);
    const std::vector<io::ObjectId> ids = someInstances(*document, 40);
    std::vector<io::Object> expected;
    for (const io::ObjectId id : ids)
        expected.push_back(objectOf(document->scene(), *document->scene().findInstance(id)));
    const std::uint64_t before = hashOf(*document);
    const std::size_t steps = document->history().position();

    const std::vector<io::ObjectId> made = promote(*document, "Promote", ids);
    ASSERT_EQ(made.size(), 40u);
    EXPECT_EQ(document->history().position(), steps + 1);
    EXPECT_EQ(document->scene().instanceCount(), 760u);
    for (std::size_t i = 0; i < made.size(); ++i) {
        EXPECT_EQ(document->scene().at(made[i]).transform, expected[i].transform);
        EXPECT_EQ(document->scene().at(made[i]).templateId, expected[i].templateId);
    }
    const Demoted back = demote(*document, "Demote", made);
    EXPECT_EQ(back.left, 0u);
    ASSERT_EQ(back.instances.size(), 40u);
    EXPECT_TRUE(document->scene().objects().empty());
    for (std::size_t i = 0; i < made.size(); ++i) {
        EXPECT_EQ(objectOf(document->scene(), back.instances[i]).transform, expected[i].transform);
        EXPECT_EQ(document->scene().at(back.instances[i]).flags, io::kPaintedInstance);
    }
    document->undo();
    document->undo();
    EXPECT_EQ(hashOf(*document), before);
    EXPECT_TRUE(document->scene().objects().empty());
}

TEST(EditedInstances, WhatCannotBeAnInstanceStaysAnObject)
{
    const auto document = planted(10);
    const auto object = [&](const char* name, glm::vec3 scale) {
        return io::Object{.id = document->freshId(), .templateId = document->scene().findTemplate(name), .transform = {.scale = scale}};
    };
    std::vector<io::Object> objects{object("pyramid", {1, 2, 1}), object("pyramid", glm::vec3{-1}), object("leaf", glm::vec3{1}), object("blob", glm::vec3{2})};
    std::vector<io::ObjectId> ids;
    for (const io::Object& o : objects)
        ids.push_back(o.id);
    addObjects(*document, "Add", objects);
    const Demoted done = demote(*document, "Demote", ids);
    EXPECT_EQ(done.left, 3u);
    EXPECT_EQ(done.instances.size(), 1u);
    EXPECT_EQ(document->scene().objects().size(), 3u);
}

TEST(EditedInstances, RulesRememberWhereOneWasTakenAway)
{
    for (const bool rule : {false, true}) {
        const auto document = planted(300, rule);
        const std::vector<io::ObjectId> ids = someInstances(*document, 5);
        std::vector<std::pair<io::LayerTile, io::Instance>> gone;
        for (const io::ObjectId id : ids) {
            const io::InstanceRef instance = *document->scene().findInstance(id);
            gone.emplace_back(instance.at, document->scene().at(instance));
        }
        removeInstances(*document, "Delete", ids);
        EXPECT_EQ(document->scene().instanceCount(), 295u);
        for (const auto& [at, instance] : gone) {
            const io::InstanceTile* tile = document->scene().find(at);
            EXPECT_EQ(tile && io::isErased(*tile, instance), rule);
            EXPECT_FALSE(tile && std::ranges::find(tile->instances, instance) != tile->instances.end());
        }
    }
}

TEST(EditedInstances, RaysMeetThemAsTheyMeetObjects)
{
    const auto document = planted(900);
    Picker picker;
    test::followed(picker, *document);
    std::vector<PickHit> hits;
    io::Random random{4};
    int met = 0;
    for (int i = 0; i < 600; ++i) {
        hits.push_back(picker.pick(randomRay(random), {.terrain = false}));
        if (hits.back().surface != Surface::Instance) continue;
        ++met;
        const auto instance = document->scene().findInstance(hits.back().id);
        ASSERT_TRUE(instance);
        EXPECT_EQ(document->scene().templateOf(*instance), hits.back().templateId);
    }
    EXPECT_GT(met, 100);
    promote(*document, "Promote", someInstances(*document, 100'000)); // a third of them
    test::followed(picker, *document);
    io::Random again{4};
    for (const PickHit& before : hits) {
        const PickHit now = picker.pick(randomRay(again), {.terrain = false});
        ASSERT_EQ(bool(now), bool(before));
        if (now) {
            ASSERT_NEAR(now.distance, before.distance, 1e-6);
        }
        if (now.surface == Surface::Instance) {
            ASSERT_TRUE(document->scene().findInstance(now.id));
        }
    }
    document->undo();
    test::followed(picker, *document);
    io::Random third{4};
    for (const PickHit& before : hits)
        ASSERT_EQ(picker.pick(randomRay(third), {.terrain = false}).surface, before.surface);
    removeScatterLayer(*document, "Delete layer", kLayer);
    test::followed(picker, *document);
    io::Random fourth{4};
    for (int i = 0; i < 600; ++i)
        ASSERT_NE(picker.pick(randomRay(fourth), {.terrain = false}).surface, Surface::Instance);
}

TEST(EditedInstances, ASelectionDropsThoseWhoseTileChanged)
{
    const auto document = planted(300);
    document->takeChanges();
    const auto& tiles = document->scene().instances(kLayer);
    const io::LayerTile one{kLayer, tiles.begin()->first}, other{kLayer, std::prev(tiles.end())->first};
    Selection selection;
    selection.add(document->scene().idOf({one, 0}));
    selection.add(document->scene().idOf({other, 0}));
    setInstances(*document, "Erase", {{one, nullptr}});
    selection.follow(document->scene(), document->takeChanges());
    ASSERT_EQ(selection.size(), 1u);
    EXPECT_EQ(selection.primary(), document->scene().idOf({other, 0}));
}

TEST(EditedInstances, ScriptsListPromoteAndDemoteThem)
{
    const auto document = planted(50);
    Selection selection;
    Picker picker;
    View view{.camera = {.eye = {0, 60, 250}, .pitch = -12}, .size = {640, 360}};
    Script script{*document, selection, picker, view};
    const auto run = [&](const std::string& line) { return io::writeJson(script.execute(*io::parseJson(line, "script"))); };
    EXPECT_NE(run(R"({"do":"instances","limit":2})").find(R"("count":50)"), std::string::npos);
    EXPECT_NE(run(R"({"do":"instances","layer":"no"})").find("no scatter layer"), std::string::npos);
    EXPECT_NE(run(R"({"do":"promote"})").find("no instance is selected"), std::string::npos);
    EXPECT_NE(run(R"({"do":"promote","ids":[3]})").find("must be those of instances"), std::string::npos);
    const auto id = std::to_string(io::number(someInstances(*document, 1)[0]));
    EXPECT_NE(run(R"({"do":"promote","ids":[)" + id + "]}").find(R"("ok":true)"), std::string::npos);
    EXPECT_EQ(document->scene().objects().size(), 1u);
    EXPECT_EQ(selection.size(), 1u);
    EXPECT_NE(run(R"({"do":"demote","layer":"wood"})").find(R"("left":0)"), std::string::npos);
    EXPECT_EQ(document->scene().instanceCount(), 50u);
    EXPECT_TRUE(io::isInstance(selection.primary()));
    EXPECT_NE(run(R"({"do":"move","by":[1,0,0]})").find("nothing is selected"), std::string::npos);
    EXPECT_NE(run(R"({"do":"stats"})").find(R"("instances":50)"), std::string::npos);
}
