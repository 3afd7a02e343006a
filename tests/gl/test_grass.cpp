// Grass: what grows follows from the place alone, stands on the ground, and is as dense as it was painted.
#include "tests/gl/support/meadow.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace {

using test::groundAt;
using test::Key;
using test::Meadow;
using test::over;
using test::Plant;
using test::standingIn;

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
    Meadow meadow{{{0, 1}, {1, 0.5f}, 1}, {test::meadow(), flowers}};
    const std::vector<Plant> plants = meadow.look(over(meadow, {0, 0}));
    const auto near = [&](int kind) {
        return double(std::ranges::count_if(plants, [&](const Plant& p) { return p.kind == kind && glm::length(glm::dvec2{p.root.x, p.root.z}) < 7; })) / (3.14159265 * 49);
    };
    EXPECT_NEAR(near(0), 32, 1.6);
    EXPECT_NEAR(near(1), 2, 0.3);
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
    Meadow meadow{{{0, 1}, {0.5f, 1}, 1}, {test::meadow(), flowers}};
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
    world.scene.exchange(io::Grass{.map = "terrain/grass.png", .metresPerTexel = 1, .origin = corner, .kinds = {test::meadow()}});
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
