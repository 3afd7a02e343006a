// Grass: what grows follows from the place alone, stands on the ground, keeps out of things, and is as dense as it was painted.
#include "renderer/passes/grass.h"
#include "renderer/wind.h"
#include "tests/gl/support/pass_bench.h"
#include "tests/gl/support/shared_renderer.h"
#include "tests/gl/support/test_world.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace {

struct Plant {
    glm::dvec3 root{0}; // m, world
    float height = 0, width = 0; // m
    int kind = 0;
    std::uint32_t ground = 0; // its colour there
    glm::vec2 bend{0};        // rad, along x and z
};

io::GrassKind meadow()
{
    return {.name = "meadow", .density = 32, .height = {0.2f, 0.4f}};
}

// A world with grass all over it, and the pass that places it.
class Meadow {
public:
    explicit Meadow(io::GrassCover cover = {{0, 0}, {1, 0}, 1}, std::vector<io::GrassKind> kinds = {meadow()})
        : m_world{test::makeWorld({.heightMap = {257, 257}, .metresPerTexel = 1, .trees = 0, .boxes = 0})}, m_pass{m_bench.shaders}, m_geometry{m_bench.shaders}
    {
        const glm::dvec2 corner = m_world.scene.heights()->origin;
        io::TexelTiles<std::uint32_t> field{glm::ivec2{513, 513}};
        const std::vector<std::uint32_t> all(513u * 513u, io::packed(cover));
        m_world.scene.exchange(io::Grass{.map = "terrain/grass.png", .metresPerTexel = 0.5, .origin = corner, .kinds = std::move(kinds)});
        m_world.scene.exchange(std::make_shared<const io::GrassMap>(field.with(all, {513, 513}, {0, 0}), 0.5, corner));
        follow({.everything = true});
        settings.mostBlades = 300'000;
        settings.grassDistance = 60;
    }

    test::TestWorld& world() { return m_world; }
    renderer::Scenery& scenery() { return m_scenery; }
    void follow(const io::Changes& changes)
    {
        m_scenery.terrain.update(m_world.scene, m_world.assets, changes);
        m_scenery.world.update(m_world.scene, m_world.assets, changes);
        m_scenery.grass.update(m_world.scene, changes);
    }

    std::vector<Plant> look(const io::Camera& camera, glm::ivec2 size = {160, 90}, double seconds = 0)
    {
        renderer::Viewpoint v;
        v.eye = v.culledFor = renderer::eyeOf(camera, size);
        v.wind = renderer::windOf(io::Wind{}, true, v.eye.position, seconds);
        v.view = renderer::viewBlock(v.eye, v.eye.clipFromRelative, seconds, 0);
        m_bench.frame(v.view, [&](renderer::GpuFrame& gpu) {
            m_scenery.terrain.aim(v.eye, v.eye);
            m_scenery.footprints.update(m_scenery.world, m_scenery.terrain, v.eye.position, double(settings.grassDistance));
            m_scenery.world.forgetTouched();
            m_scenery.terrain.forgetTouched();
            m_geometry.begin(v, true);
            m_pass.render(gpu, m_geometry, {}, m_scenery, v, io::Environment{}, pressers, settings);
        });
        std::vector<Plant> plants;
        for (const glsl::GrassBlade& blade : m_pass.readBlades())
            plants.push_back({glm::dvec3{blade.root} + v.eye.position, glm::unpackHalf2x16(blade.size).x, glm::unpackHalf2x16(blade.size).y, int(blade.look >> 8 & 15), blade.ground, glm::unpackHalf2x16(blade.bend)});
        return plants;
    }

    std::vector<glsl::Instance> models(int kind) const { return m_pass.readPlants(kind); } // of the last look

    renderer::Settings settings;
    std::vector<renderer::Presser> pressers;

private:
    test::PassBench m_bench;
    test::TestWorld m_world;
    renderer::Scenery m_scenery;
    renderer::GrassPass m_pass;
    renderer::GeometryPass m_geometry;
};

double groundAt(Meadow& meadow, glm::dvec2 place)
{
    return *meadow.world().scene.heights()->height(place.x, place.y);
}

// From above, so that all around the place is in view.
io::Camera over(Meadow& meadow, glm::dvec2 place, double height = 14, float yaw = 0)
{
    return {.eye = {place.x, groundAt(meadow, place) + height, place.y}, .yaw = yaw, .pitch = -89, .fov = 60};
}

using Key = std::tuple<long, long, int, long>; // cell, kind, hundredths of a millimetre

// What stands in a square of 4 m.
std::set<Key> standingIn(const std::vector<Plant>& plants, glm::dvec2 corner)
{
    std::set<Key> found;
    for (const Plant& plant : plants)
        if (plant.root.x >= corner.x && plant.root.z >= corner.y && plant.root.x < corner.x + 4 && plant.root.z < corner.y + 4)
            found.insert({long(std::floor(plant.root.x / double(GRASS_CELL))), long(std::floor(plant.root.z / double(GRASS_CELL))), plant.kind, std::lround(plant.height * 1e5f)});
    return found;
}

TEST(Grass, IsTheSameFromEveryCameraAtEveryResolution)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    const glm::dvec2 corner{12.25, -8.25};
    const std::set<Key> first = standingIn(meadow.look(over(meadow, corner + 2.0)), corner);
    EXPECT_GT(first.size(), 400u);
    std::mt19937 random{5};
    std::uniform_real_distribution<double> away{-1, 1}, height{11, 13}, turn{-180, 180};
    for (int i = 0; i < 50; ++i) {
        const glm::dvec2 place = corner + 2.0 + glm::dvec2{away(random), away(random)};
        const glm::ivec2 size = i % 3 == 0 ? glm::ivec2{320, 180} : i % 3 == 1 ? glm::ivec2{97, 131} : glm::ivec2{640, 360};
        const std::set<Key> seen = standingIn(meadow.look(over(meadow, place, height(random), float(turn(random))), size), corner);
        EXPECT_TRUE(seen == first) << "camera " << i << ": " << seen.size() << " of " << first.size();
    }
}

TEST(Grass, RootsLieOnTheGround)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    const std::vector<Plant> plants = meadow.look(over(meadow, {20.3, 31.7}));
    ASSERT_GT(plants.size(), 1000u);
    double worst = 0;
    for (const Plant& plant : plants)
        worst = std::max(worst, std::abs(plant.root.y - groundAt(meadow, {plant.root.x, plant.root.z})));
    EXPECT_LE(worst, 0.01); // m
}

TEST(Grass, IsAsDenseAsItWasPainted)
{
    if (!test::haveContext()) GTEST_SKIP();
    for (const float share : {1.0f, 0.4f}) {
        Meadow meadow{{{0, 0}, {share, 0}, 1}};
        const glm::dvec2 middle{10, 10};
        const std::vector<Plant> plants = meadow.look(over(meadow, middle));
        const auto near = std::ranges::count_if(plants, [&](const Plant& p) { return glm::distance(glm::dvec2{p.root.x, p.root.z}, middle) < 6; });
        const double density = double(near) / (3.14159265 * 36);
        EXPECT_NEAR(density, 32 * double(share), 32 * double(share) * 0.05);
    }
}

TEST(Grass, ThinsOutWithDistanceAndEnds)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    const glm::dvec2 middle{0, 0};
    const std::vector<Plant> plants = meadow.look({.eye = {0, groundAt(meadow, middle) + 90, 0}, .pitch = -89, .fov = 80}, {320, 320});
    double before = 1e9;
    for (int ring = 0; ring < 6; ++ring) {
        const double from = ring * 10, to = from + 10;
        const auto count = std::ranges::count_if(plants, [&](const Plant& p) {
            const double away = glm::length(glm::dvec2{p.root.x, p.root.z});
            return away >= from && away < to;
        });
        const double density = double(count) / (3.14159265 * (to * to - from * from));
        EXPECT_LE(density, before * 1.05) << from;
        before = density;
    }
    EXPECT_TRUE(std::ranges::all_of(plants, [](const Plant& p) { return glm::length(glm::dvec2{p.root.x, p.root.z}) < 60; }));
}

TEST(Grass, TwoKindsStandInOneField)
{
    if (!test::haveContext()) GTEST_SKIP();
    io::GrassKind flowers{.name = "flowers", .density = 4};
    Meadow meadow{{{0, 1}, {1, 0.5f}, 1}, {::meadow(), flowers}};
    const std::vector<Plant> plants = meadow.look(over(meadow, {0, 0}));
    const auto near = [&](int kind) {
        return double(std::ranges::count_if(plants, [&](const Plant& p) { return p.kind == kind && glm::length(glm::dvec2{p.root.x, p.root.z}) < 7; })) / (3.14159265 * 49);
    };
    EXPECT_NEAR(near(0), 32, 1.6);
    EXPECT_NEAR(near(1), 2, 0.3);
}

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

// Fewer of them stand for more: what they cover of the ground does not fall with their number.
TEST(Grass, CoversAsMuchFarAwayAsNear)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    meadow.settings.grassDistance = 100;
    meadow.settings.culling = false;
    double covered[6] = {}; // m2 a m2, of rings up to where they begin to end
    for (const Plant& plant : meadow.look({.eye = {0, groundAt(meadow, {0, 0}) + 1.7, 0}}))
        if (const auto ring = int(glm::length(glm::dvec2{plant.root.x, plant.root.z}) / 12); ring < 6) covered[ring] += double(plant.width) * double(plant.height);
    for (int ring = 0; ring < 6; ++ring)
        covered[ring] /= 3.14159265 * 144 * (2 * ring + 1);
    for (int ring = 1; ring < 6; ++ring) {
        EXPECT_GT(covered[ring], covered[0] * 0.6) << ring;
        EXPECT_LT(covered[ring], covered[0] * 1.4) << ring;
    }
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

TEST(Grass, ColoursFollowThePartOfTheGroundThatChanged)
{
    if (!test::haveContext()) GTEST_SKIP();
    const auto paint = [](Meadow& meadow) {
        const io::CoverMap bare{meadow.world().scene.heights()->size};
        const std::vector<std::uint32_t> rock(40u * 40u, io::packed(io::Cover{3, 3, 0, 1}));
        meadow.world().scene.exchange(std::make_shared<const io::CoverMap>(bare.with(rock, {40, 40}, {108, 108})));
    };
    const auto colours = [](Meadow& meadow) {
        std::map<std::pair<long, long>, glm::vec4> found; // by cell
        for (const Plant& plant : meadow.look(over(meadow, {0, 0})))
            found[{std::lround(std::floor(plant.root.x * 8)), std::lround(std::floor(plant.root.z * 8))}] = glm::unpackUnorm4x8(plant.ground);
        return found;
    };
    const auto differ = [](const auto& a, const auto& b) { // plants
        return std::ranges::count_if(a, [&](const auto& one) { return glm::length(one.second - b.at(one.first)) > 0.02f; });
    };
    Meadow painted, fresh;
    painted.world().scene.exchange(std::make_shared<const io::CoverMap>(painted.world().scene.heights()->size));
    painted.follow({.everything = true});
    const auto before = colours(painted);
    paint(painted);
    painted.follow({.cover = {{{108, 108}, {148, 148}}}});
    paint(fresh);
    fresh.follow({.everything = true});
    const auto after = colours(painted);
    ASSERT_EQ(after.size(), before.size());
    EXPECT_GT(differ(after, before), long(after.size() / 2));
    EXPECT_EQ(differ(after, colours(fresh)), 0);
}

// The ground's layers are chosen by slope and altitude; a map that is held as windows around the eye shows the same.
TEST(Grass, ColoursAreTheGroundsWhereverTheEyeCameFrom)
{
    if (!test::haveContext()) GTEST_SKIP();
    const auto colours = [](Meadow& meadow, const glm::dvec2& from) {
        meadow.settings.grassDistance = 30;
        std::map<std::pair<long, long>, std::uint32_t> found; // by cell
        for (const Plant& plant : meadow.look(over(meadow, from)))
            found[{std::lround(std::floor(plant.root.x * 8)), std::lround(std::floor(plant.root.z * 8))}] = plant.ground;
        return found;
    };
    Meadow whole, walked, windows;
    windows.scenery().terrain = renderer::Terrain{{.whole = 128, .window = 224}};
    windows.follow({.everything = true});
    for (double x = -110; x < 90; x += 40) {
        colours(walked, {x, x * 0.8});
        colours(windows, {x, x * 0.8});
    }
    const auto expected = colours(whole, {90, -70});
    std::set<std::uint32_t> different;
    for (const auto& [cell, colour] : expected)
        different.insert(colour);
    ASSERT_GT(expected.size(), 1000u);
    EXPECT_GT(different.size(), 50u);
    EXPECT_EQ(colours(walked, {90, -70}), expected);
    ASSERT_TRUE(windows.scenery().terrain.windowed());
    const auto seen = colours(windows, {90, -70});
    EXPECT_NEAR(double(seen.size()), double(expected.size()), double(expected.size()) * 0.01); // normals there are those of the nearest texel
    const auto differ = std::ranges::count_if(seen, [&](const auto& plant) {
        const auto there = expected.find(plant.first);
        return there != expected.end() && glm::length(glm::unpackUnorm4x8(plant.second) - glm::unpackUnorm4x8(there->second)) > 0.02f;
    });
    EXPECT_EQ(differ, 0);
}

TEST(Grass, MoreThanThereIsRoomForIsLeftOut)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    const auto cells = [](const std::vector<Plant>& plants) {
        std::set<std::pair<double, double>> all;
        for (const Plant& plant : plants)
            all.insert({std::round(plant.root.x * 1000), std::round(plant.root.z * 1000)});
        return all;
    };
    const std::size_t whole = meadow.look(over(meadow, {0, 0})).size();
    meadow.settings.mostBlades = int(whole / 4);
    const std::vector<Plant> some = meadow.look(over(meadow, {0, 0}));
    EXPECT_LE(some.size(), whole / 4);
    EXPECT_GT(some.size(), whole / 8);
    for (int again = 0; again < 5; ++again) // the same ones each time
        EXPECT_EQ(cells(meadow.look(over(meadow, {0, 0}))), cells(some));
    meadow.settings.mostBlades = 500;
    const std::size_t few = meadow.look(over(meadow, {0, 0})).size();
    EXPECT_LE(few, 500u);
    EXPECT_GT(few, 200u);
    meadow.settings.mostBlades = 0;
    EXPECT_EQ(meadow.look(over(meadow, {0, 0})).size(), 0u);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// More grows around the eye than may be drawn: which plants stay does not ask where it looks.
TEST(Grass, ThoseThatStayAreTheSameWhereverOneLooks)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    meadow.settings.mostBlades = 6000;
    const auto cells = [&](float yaw, float fov) {
        std::set<std::pair<double, double>> all;
        for (const Plant& plant : meadow.look({.eye = {0, groundAt(meadow, {0, 0}) + 8, 0}, .yaw = yaw, .pitch = -35, .fov = fov}))
            if (plant.width > 0.001f) all.insert({std::round(plant.root.x * 1000), std::round(plant.root.z * 1000)});
        return all;
    };
    const auto wide = cells(0, 40), narrow = cells(0, 25), turned = cells(12, 25);
    EXPECT_LT(wide.size(), 6000u);
    EXPECT_GT(wide.size(), 400u);
    EXPECT_GT(narrow.size(), 150u);
    EXPECT_TRUE(std::ranges::includes(wide, narrow));
    EXPECT_TRUE(std::ranges::includes(wide, turned));
    EXPECT_NE(turned, narrow);
}

// Over 10 m no blade comes or goes but as a sliver, and what comes and goes is a small part of what is seen.
TEST(Grass, NothingJumpsAsTheEyeMovesTenMetres)
{
    if (!test::haveContext()) GTEST_SKIP();
    Meadow meadow;
    meadow.settings.culling = false; // so that no edge of the picture cuts blades off
    meadow.settings.grassDistance = 30;
    const double whole = 0.024 * 0.4; // m2, of the largest blade
    std::map<std::pair<long, long>, double> before;
    for (int step = 0; step <= 200; ++step) { // 5 cm each
        const glm::dvec3 eye{0.05 * step, groundAt(meadow, {0.05 * step, 0}) + 1.7, 0};
        std::map<std::pair<long, long>, double> now; // m2 by cell
        double all = 0, changed = 0, largest = 0;
        for (const Plant& plant : meadow.look({.eye = eye, .pitch = -20})) {
            const double area = double(plant.height) * double(plant.width);
            now[{long(std::floor(plant.root.x / double(GRASS_CELL))), long(std::floor(plant.root.z / double(GRASS_CELL)))}] = area;
            all += area;
        }
        for (const auto& [one, other] : {std::pair{&now, &before}, std::pair{&before, &now}})
            for (const auto& [cell, area] : *one)
                if (step > 0 && !other->contains(cell)) {
                    changed += area;
                    largest = std::max(largest, area);
                }
        EXPECT_LT(changed, all * 0.005) << step;
        EXPECT_LT(largest, whole * 0.1) << step;
        before = std::move(now);
    }
}

TEST(Grass, AKindCanBeAModelThatStandsOnTheGround)
{
    if (!test::haveContext()) GTEST_SKIP();
    io::GrassKind flowers{.name = "flowers", .plant = "flower", .density = 3, .height = {0.5f, 0.8f}};
    Meadow meadow{{{0, 1}, {0.5f, 1}, 1}, {::meadow(), flowers}};
    test::addTemplate(meadow.world(), "flower", test::box({0.1f, 2, 0.1f}, {0.8f, 0.2f, 0.3f, 1}));
    meadow.follow({.everything = true});
    const glm::dvec2 middle{0, 0};
    const std::vector<Plant> blades = meadow.look(over(meadow, middle));
    EXPECT_TRUE(std::ranges::all_of(blades, [](const Plant& p) { return p.kind == 0; }));
    const std::vector<glsl::Instance> plants = meadow.models(1);
    std::ptrdiff_t near = 0;
    for (const glsl::Instance& plant : plants) {
        const glm::dvec3 root = glm::dvec3{plant.positionHigh} + glm::dvec3{plant.positionLow};
        EXPECT_NEAR(root.y, groundAt(meadow, {root.x, root.z}), 0.01);
        if (glm::length(glm::dvec2{root.x, root.z}) >= 6) continue; // farther ones shrink
        ++near;
        EXPECT_GE(plant.axisY.y * 2, 0.5f * 0.99f); // m, of a model of 2 m
        EXPECT_LE(plant.axisY.y * 2, 0.8f * 1.01f);
    }
    EXPECT_NEAR(double(near) / (3.14159265 * 36), 3, 0.5);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// The same meadow as a whole picture, with a wall before the eye.
renderer::FrameInput behindAWall()
{
    test::TestWorld world = test::makeWorld({.heightMap = {257, 257}, .metresPerTexel = 1, .trees = 0, .boxes = 0});
    const glm::dvec2 corner = world.scene.heights()->origin;
    const std::vector<std::uint32_t> all(257u * 257u, io::packed(io::GrassCover{{0, 0}, {1, 0}, 1}));
    world.scene.exchange(io::Grass{.map = "terrain/grass.png", .metresPerTexel = 1, .origin = corner, .kinds = {meadow()}});
    world.scene.exchange(std::make_shared<const io::GrassMap>(io::TexelTiles<std::uint32_t>{glm::ivec2{257, 257}, all}, 1, corner));
    const io::TemplateId wall = test::addTemplate(world, "wall", test::box({30, 6, 0.5f}, {0.6f, 0.6f, 0.6f, 1}));
    const double ground = *world.scene.heights()->height(0, 0);
    test::addObject(world, wall, {.position = {0, ground - 2, -6}});
    test::load(world);
    renderer::FrameInput in = test::frame({320, 180}, {.eye = {0, ground + 1.7, 0}});
    in.settings.culler = renderer::Culler::Gpu;
    in.settings.grass = true;
    in.settings.mostBlades = 200'000;
    return in;
}

void renderTillCounted(const renderer::FrameInput& in)
{
    for (int i = 0; i < 6; ++i) // counts come some frames late
        test::shared().render(in);
}

TEST(Grass, WhatIsHiddenIsLeftOutAndNobodySees)
{
    if (!test::haveContext()) GTEST_SKIP();
    renderer::FrameInput in = behindAWall();
    renderTillCounted(in);
    const io::Image with = test::shared().readPicture();
    const std::uint64_t drawn = test::shared().stats().grassDrawn;
    in.settings.occlusion = false;
    renderTillCounted(in);
    const io::Image without = test::shared().readPicture();
    EXPECT_GT(drawn, 200u);
    EXPECT_LT(drawn, test::shared().stats().grassDrawn / 2);
    EXPECT_TRUE(with.bytes == without.bytes);
}

TEST(Grass, SeedsOfPixelsAreDrawnAndTheirCounterIsClamped)
{
    if (!test::haveContext()) GTEST_SKIP();
    renderer::FrameInput in = behindAWall();
    in.settings.grass = false;
    renderTillCounted(in);
    const io::Image bare = test::shared().readPicture();
    in.settings.grass = true;
    in.settings.grassMethod = renderer::GrassFrom::Seeds;
    renderTillCounted(in);
    EXPECT_GT(test::shared().stats().grassDrawn, 500u);
    EXPECT_FALSE(test::shared().readPicture().bytes == bare.bytes);
    in.settings.mostBlades = 300;
    renderTillCounted(in);
    EXPECT_EQ(test::shared().stats().grassDrawn, 300u);
    EXPECT_GT(test::shared().stats().grassLeftOut, 0u);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

} // namespace
