// Grass keeps out of things, and leans away from what presses it.
#include "tests/gl/support/meadow.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace {

using test::groundAt;
using test::Meadow;
using test::over;
using test::Plant;
using test::standingIn;

TEST(Grass, DoesNotGrowThroughAThousandThings)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    test::TestWorld& world = meadow.world();
    const io::TemplateId crate = test::addTemplate(world, "crate", test::box({1.3f, 1, 0.7f}, {0.5f, 0.4f, 0.3f, 1}));
    const io::TemplateId post = test::addTemplate(world, "post", test::box({0.2f, 1, 0.2f}, {0.5f, 0.4f, 0.3f, 1}));
    io::Template round = *world.scene.find(post);
    round.model = "models/post.glb";
    round.footprintShape = io::Footprint::Radius;
    round.footprint = 0.5f;
    world.scene.exchange(post, round);
    io::Template box = *world.scene.find(crate);
    box.model = "models/crate.glb";
    world.scene.exchange(crate, box);
    std::mt19937 random{9};
    std::uniform_real_distribution<double> across{-28, 28}, turn{-180, 180}, size{0.6, 1.6};
    struct Thing {
        glm::dvec2 at;
        double turn, scale;
        bool round;
    };
    std::vector<Thing> things;
    for (int i = 0; i < 1000; ++i) {
        const Thing thing{{across(random), across(random)}, turn(random), size(random), i % 2 == 1};
        test::addObject(world, thing.round ? post : crate, {.position = {thing.at.x, groundAt(meadow, thing.at), thing.at.y}, .rotation = {0, thing.turn, 0}, .scale = glm::vec3(float(thing.scale))});
        things.push_back(thing);
    }
    meadow.follow({.everything = true});
    const std::vector<Plant> plants = meadow.look({.eye = {0, groundAt(meadow, {0, 0}) + 45, 0}, .pitch = -89, .fov = 80}, {320, 320});
    ASSERT_GT(plants.size(), 5000u);
    int inside = 0;
    for (const Plant& plant : plants)
        for (const Thing& thing : things) {
            const glm::dvec2 away = glm::dvec2{plant.root.x, plant.root.z} - thing.at;
            if (thing.round) {
                inside += glm::length(away) < (0.5) * thing.scale;
                continue;
            }
            const double a = glm::radians(thing.turn);
            const glm::dvec2 own{away.x * std::cos(a) - away.y * std::sin(a), away.x * std::sin(a) + away.y * std::cos(a)};
            inside += std::abs(own.x) < 0.65 * thing.scale && std::abs(own.y) < 0.35 * thing.scale;
        }
    EXPECT_EQ(inside, 0);
}

TEST(Grass, KeepsOutOfThingsAsFarAsItIsDrawn)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    meadow.settings.grassDistance = 240;
    test::TestWorld& world = meadow.world();
    const io::TemplateId house = test::addTemplate(world, "house", test::box({12, 3, 12}, {0.5f, 0.4f, 0.3f, 1}));
    io::Template box = *world.scene.find(house);
    box.model = "models/house.glb";
    world.scene.exchange(house, box);
    const glm::dvec2 far{80, 0}, eye{-120, 0}, behind{far - glm::dvec2{256, 0}}; // the last is not on the ground
    test::addObject(world, house, {.position = {far.x, groundAt(meadow, far), far.y}});
    const auto near = [&](const std::vector<Plant>& plants, const glm::dvec2& at) {
        return std::ranges::count_if(plants, [&](const Plant& plant) { return std::max(std::abs(plant.root.x - at.x), std::abs(plant.root.z - at.y)) < 6; });
    };
    meadow.settings.culling = false;
    const io::Camera camera{.eye = {eye.x, groundAt(meadow, eye) + 30, eye.y}, .yaw = -90, .pitch = -10};
    EXPECT_GT(near(meadow.look(camera), far), 10);
    meadow.follow({.everything = true});
    const std::vector<Plant> plants = meadow.look(camera);
    EXPECT_EQ(near(plants, far), 0);
    EXPECT_GT(near(plants, {far.x - 128, 0}), 10); // where a mask half as wide would have it again
    EXPECT_FALSE(meadow.scenery().footprints.covers(behind));
}

TEST(Grass, LeansAwayFromWhatPressesIt)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    const std::vector<Plant> free = meadow.look(over(meadow, {0, 0}));
    meadow.pressers = {{.position = {0, groundAt(meadow, {0, 0}), 0}, .radius = 1}};
    const std::vector<Plant> pressed = meadow.look(over(meadow, {0, 0}));
    std::map<std::pair<double, double>, glm::vec2> before;
    for (const Plant& plant : free)
        before[{std::round(plant.root.x * 1000), std::round(plant.root.z * 1000)}] = plant.bend;
    int near = 0, away = 0, changed = 0;
    for (const Plant& plant : pressed) {
        const glm::dvec2 at{plant.root.x, plant.root.z};
        const glm::vec2 turned = plant.bend - before.at({std::round(plant.root.x * 1000), std::round(plant.root.z * 1000)});
        if (glm::length(at) > 1.2) changed += glm::length(turned) > 0.01f;
        if (glm::length(at) > 0.6 || glm::length(at) < 0.1) continue;
        ++near;
        away += glm::dot(glm::dvec2{turned}, glm::normalize(at)) > 0.5;
    }
    EXPECT_GT(near, 20);
    EXPECT_GT(away, near * 9 / 10);
    EXPECT_EQ(changed, 0);
}

TEST(Grass, ComesBackWhereAThingWas)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    const std::vector<Plant> before = meadow.look(over(meadow, {0, 0}));
    test::TestWorld& world = meadow.world();
    const io::TemplateId crate = test::addTemplate(world, "crate", test::box({2, 1, 2}, {0.5f, 0.4f, 0.3f, 1}));
    io::Template box = *world.scene.find(crate);
    box.model = "models/crate.glb";
    world.scene.exchange(crate, box);
    const io::ObjectId id = test::addObject(world, crate, {.position = {0, groundAt(meadow, {0, 0}), 0}});
    meadow.follow({.objects = {id}, .templates = {crate}});
    const std::vector<Plant> with = meadow.look(over(meadow, {0, 0}));
    EXPECT_LT(with.size(), before.size() - 60);
    world.scene.exchange(id, std::nullopt);
    meadow.follow({.objects = {id}});
    EXPECT_EQ(meadow.look(over(meadow, {0, 0})).size(), before.size());
}

TEST(Grass, KeepsOutOfInstancesOfScatterLayersToo)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    test::TestWorld& world = meadow.world();
    const io::TemplateId crate = test::addTemplate(world, "crate", test::box({1, 1, 1}, {0.5f, 0.4f, 0.3f, 1}));
    io::Template box = *world.scene.find(crate);
    box.model = "models/crate.glb";
    world.scene.exchange(crate, box);
    const io::ScatterId layer = world.scene.freshScatterId();
    world.scene.exchange(std::vector{io::ScatterLayer{.id = layer, .name = "crates", .species = {{.templateName = "crate"}}}});
    std::map<glm::ivec2, io::InstanceTile, io::TileOrder> tiles;
    std::vector<glm::dvec2> places;
    for (double z = -20; z < 20; z += 2.3)
        for (double x = -20; x < 20; x += 2.3) {
            const io::PlacedInstance one = io::instanceAt({.position = {x, groundAt(meadow, {x, z}), z}}, 0);
            tiles[one.tile].instances.push_back(one.instance);
            places.emplace_back(x, z);
        }
    io::InstanceTiles shared;
    for (auto& [tile, content] : tiles)
        shared[tile] = std::make_shared<const io::InstanceTile>(std::move(content));
    world.scene.exchange(layer, std::move(shared));
    meadow.follow({.everything = true});
    const std::vector<Plant> plants = meadow.look(over(meadow, {0, 0}));
    ASSERT_GT(plants.size(), 2000u);
    EXPECT_TRUE(std::ranges::none_of(plants, [&](const Plant& plant) {
        return std::ranges::any_of(places, [&](const glm::dvec2& at) {
            const glm::dvec2 away = glm::abs(glm::dvec2{plant.root.x, plant.root.z} - at);
            return std::max(away.x, away.y) < 0.5;
        });
    }));
}

TEST(Grass, WhatCameIntoTheWindowIsKeptOutOfToo)
{
    if (!test::haveContext()) GTEST_SKIP();
    const auto crowded = [](Meadow& meadow) {
        test::TestWorld& world = meadow.world();
        const io::TemplateId crate = test::addTemplate(world, "crate", test::box({2, 1, 2}, {0.5f, 0.4f, 0.3f, 1}));
        io::Template box = *world.scene.find(crate);
        box.model = "models/crate.glb";
        world.scene.exchange(crate, box);
        for (double z = -120; z < 120; z += 7)
            for (double x = -120; x < 120; x += 7)
                test::addObject(world, crate, {.position = {x, groundAt(meadow, {x, z}), z}});
        meadow.follow({.everything = true});
    };
    Meadow walked, there;
    crowded(walked);
    crowded(there);
    for (double x = -110; x < 100; x += 30)
        walked.look(over(walked, {x, x * 0.8}));
    const std::vector<Plant> after = walked.look(over(walked, {97, -92})), fresh = there.look(over(there, {97, -92}));
    EXPECT_GT(fresh.size(), 1000u);
    EXPECT_EQ(standingIn(after, {95, -94}), standingIn(fresh, {95, -94}));
    EXPECT_EQ(after.size(), fresh.size());
}

} // namespace
