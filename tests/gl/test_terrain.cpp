// The ground has no holes, and near the eye it is the height map itself.
#include "renderer/ground_horizon.h"
#include "renderer/ground_shadow.h"
#include "renderer/terrain_choice.h"
#include "tests/gl/support/shared_renderer.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace {

constexpr glm::ivec2 kSize{320, 180};

double spikes(double x, double z)
{
    const int ix = int(std::floor(x / 6)), iz = int(std::floor(z / 6));
    return ((ix * 7 + iz * 13) % 11 == 0) ? 300.0 : std::sin(x * 0.9) * 3 + std::cos(z * 1.3) * 3;
}

int holes(const io::HeightMap& map, const io::Camera& camera)
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png"});
    world.scene.exchange(std::make_shared<const io::HeightMap>(map));
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings.shadows = false;
    test::shared().render(in);
    const auto ids = test::shared().readIds({0, 0}, kSize);
    return int(std::count(ids.begin(), ids.end(), 0u));
}

TEST(Terrain, HasNoCracks)
{
    const auto hills = test::heightMap({700, 1201}, 2, test::hills);
    const auto rough = test::heightMap({513, 513}, 1, spikes);
    for (const double x : {-90.0, 10.0, 130.0})
        for (const double height : {20.0, 90.0, 400.0}) {
            const io::Camera down{.eye = {x, hills->height(x, 40).value_or(0) + height, 40}, .yaw = float(x), .pitch = -88};
            EXPECT_EQ(holes(*hills, down), 0) << "hills, " << x << ", " << height;
            if (height > 100) continue; // further up one sees past its edge
            const io::Camera steep{.eye = {x * 0.5, 330 + height, 0}, .yaw = float(3 * x), .pitch = -87, .fov = 25};
            EXPECT_EQ(holes(*rough, steep), 0) << "spikes, " << x << ", " << height;
        }
}

TEST(Terrain, AnySizeIsDrawn)
{
    for (const glm::ivec2 size : {glm::ivec2{2, 2}, {257, 2}, {3, 500}, {33, 33}, {1024, 1024}, {1201, 77}}) {
        const auto map = test::heightMap(size, 1, [](double, double) { return 5.0; });
        const io::Camera down{.eye = {0, 5.4, 0}, .pitch = -90, .fov = 60};
        const int empty = holes(*map, down);
        const bool wide = size.x > 2 && size.y > 2;
        EXPECT_LT(empty, wide ? 1 : kSize.x * kSize.y) << size.x << " x " << size.y;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A stroke of a brush: heights, normals with their mips, shadow maps and the mountains' shadow follow, and nothing else does.
TEST(Terrain, APartThatChangedIsDrawnAsIfAllWereNew)
{
    const auto before = test::heightMap({700, 601}, 1, test::hills);
    io::HeightGrid hill{.size = {90, 70}};
    for (int z = 0; z < 70; ++z)
        for (int x = 0; x < 90; ++x)
            hill.metres.push_back(before->at(480 + x, 240 + z) + 25 * std::sin(x * 0.035f) * std::sin(z * 0.045f));
    const glm::ivec2 at{480, 240}; // across four tiles' corner
    const auto after = std::make_shared<const io::HeightMap>(before->with(hill, at));
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png", .origin = before->origin});
    // Near, where normals are those of the texels, and from afar, where their mips are.
    for (const io::Camera& camera : {io::Camera{.eye = {100, before->max + 30.0, 60}, .yaw = -70, .pitch = -25},
                                     io::Camera{.eye = {175, before->max + 900.0, -20}, .pitch = -90, .fov = 20}}) {
        renderer::FrameInput in = test::frame(kSize, camera);
        in.settings.clouds = in.settings.fog = false;
        const auto picture = [&] {
            test::shared().render(in);
            return test::shared().readPicture();
        };
        world.scene.exchange(before);
        test::load(world);
        const io::Image untouched = picture();
        world.scene.exchange(after);
        test::shared().update(world.scene, world.assets, {.heights = {{at, at + hill.size}}});
        const io::Image followed = picture();
        world.scene.exchange(std::make_shared<const io::HeightMap>(*after)); // another map, or nothing would be made anew
        test::load(world);
        const io::Image fresh = picture();
        EXPECT_NE(untouched.bytes, fresh.bytes);
        EXPECT_EQ(followed.bytes, fresh.bytes);
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Terrain, WhatWasPaintedIsShownAndFollowsInPart)
{
    const auto map = test::heightMap({600, 300}, 1, [](double, double) { return 0.0; });
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png",
                                     .origin = map->origin,
                                     .layers = {{.name = "green", .colour = {0, 0.5f, 0}}, {.name = "red", .colour = {0.5f, 0, 0}, .slope = {80, 90}}}});
    world.scene.exchange(map);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 60, 0}, .pitch = -90});
    in.show = renderer::Show::Albedo;
    const auto picture = [&] {
        test::shared().render(in);
        return test::shared().readPicture();
    };
    const auto red = [](const io::Image& image) {
        int count = 0;
        for (int y = 0; y < image.size.y; ++y)
            for (int x = 0; x < image.size.x; ++x)
                count += image.row<glm::u8vec4>(y)[x].x > image.row<glm::u8vec4>(y)[x].y;
        return count;
    };
    test::load(world);
    EXPECT_EQ(red(picture()), 0); // it is level: the rules show green alone

    const std::vector<std::uint32_t> whole(64 * 32, io::packed(io::Cover{1, 1, 0, 1})), half(64 * 32, io::packed(io::Cover{0, 1, 0.5f, 1}));
    world.scene.exchange(std::make_shared<const io::CoverMap>(io::CoverMap{map->size}.with(half, {64, 32}, {190, 130})));
    test::load(world);
    const io::Image mixed = picture();
    world.scene.exchange(std::make_shared<const io::CoverMap>(world.scene.cover()->with(whole, {64, 32}, {280, 134})));
    test::shared().update(world.scene, world.assets, {.cover = {{{280, 134}, {344, 166}}}});
    const io::Image followed = picture();
    world.scene.exchange(std::make_shared<const io::CoverMap>(*world.scene.cover())); // another one, or nothing would be made anew
    test::load(world);
    const io::Image fresh = picture();
    EXPECT_GT(red(fresh), red(mixed) + 1500);
    EXPECT_EQ(followed.bytes, fresh.bytes);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// Halves of an image, left and right.
std::shared_ptr<const io::Image> halves(std::uint8_t left, std::uint8_t right)
{
    io::Image image{.size = {64, 64}, .channels = 1};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            image.bytes.push_back(std::byte{x < 32 ? left : right});
    return std::make_shared<const io::Image>(std::move(image));
}

TEST(Terrain, LayersMayHaveMapsOfTheirRoughnessAndHeight)
{
    const auto map = test::heightMap({65, 65}, 1, [](double, double) { return 0.0; });
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png",
                                     .origin = map->origin,
                                     .layers = {{.name = "green", .texture = "a", .roughnessTexture = "r", .heightTexture = "h", .colour = {0, 0.5f, 0}, .roughness = 0.8f, .metres = 64},
                                                {.name = "red", .texture = "a", .colour = {0.5f, 0, 0}, .metres = 64}}});
    world.scene.exchange(map);
    world.scene.exchange(std::make_shared<const io::CoverMap>(io::CoverMap{map->size}.with(std::vector<std::uint32_t>(65 * 65, io::packed(io::Cover{0, 1, 0.5f, 1})), {65, 65}, {0, 0})));
    const auto grey = halves(128, 128);
    const auto shownOf = [&](renderer::Show show, io::LayerImages first) {
        world.assets.layers = {std::move(first), {.colour = grey}};
        world.scene.exchange(std::make_shared<const io::CoverMap>(*world.scene.cover())); // another world to look at
        test::load(world);
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 30, 0}, .pitch = -90});
        in.show = show;
        in.settings.groundDetail = true; // its program is built, too
        test::shared().render(in);
        const io::Image image = test::shared().readPicture();
        const auto at = [&](int x) { return glm::vec3{glm::u8vec3{image.row<glm::u8vec4>(kSize.y / 2)[x]}}; };
        return std::pair{at(kSize.x / 2 - 40), at(kSize.x / 2 + 40)};
    };
    const auto plain = shownOf(renderer::Show::Albedo, {.colour = grey});
    EXPECT_LT(glm::distance(plain.first, plain.second), 12); // large patches alone
    const auto high = shownOf(renderer::Show::Albedo, {.colour = grey, .height = halves(20, 235)});
    EXPECT_GT(std::abs((high.first.g - high.first.r) - (high.second.g - high.second.r)), 30); // the higher of the two shows
    const auto rough = shownOf(renderer::Show::Roughness, {.colour = grey, .roughness = halves(60, 255), .height = halves(255, 255)});
    EXPECT_GT(rough.second.r, rough.first.r + 60);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A valley that falls along z: a layer that asks for much water lies in its bed, and follows when the bed is moved.
TEST(Terrain, LayersMayAskWhereWaterGathers)
{
    const auto map = test::heightMap({401, 401}, 4, [](double x, double z) { return std::abs(x) * 0.3 + z * 0.1; });
    const auto moved = test::heightMap({401, 401}, 4, [](double x, double z) { return std::abs(x - 120) * 0.3 + z * 0.1; });
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png",
                                     .origin = map->origin,
                                     .layers = {{.name = "green", .colour = {0, 0.5f, 0}}, {.name = "red", .colour = {0.5f, 0, 0}, .flow = {0.45f, 1}, .blend = 0.05f}}});
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 500, 0}, .pitch = -90});
    in.show = renderer::Show::Albedo;
    const auto reddest = [&] { // column, of the picture's middle row
        test::shared().render(in);
        const io::Image image = test::shared().readPicture();
        std::vector<int> columns;
        for (int x = 0; x < kSize.x; ++x)
            if (image.row<glm::u8vec4>(kSize.y / 2)[x].x > image.row<glm::u8vec4>(kSize.y / 2)[x].y) columns.push_back(x);
        return columns;
    };
    world.scene.exchange(map);
    test::load(world);
    const std::vector<int> bed = reddest();
    ASSERT_FALSE(bed.empty());
    EXPECT_LT(bed.size(), 40u);
    EXPECT_NEAR(bed[bed.size() / 2], kSize.x / 2, 6);
    world.scene.exchange(std::make_shared<const io::HeightMap>(map->with(moved->read(moved->texels()), {0, 0})));
    test::shared().update(world.scene, world.assets, {.heights = {map->texels()}});
    const std::vector<int> other = reddest();
    ASSERT_FALSE(other.empty());
    EXPECT_GT(other[other.size() / 2], kSize.x / 2 + 20);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Terrain, HolesAreSeenThroughByTheCameraAndTheSun)
{
    const auto map = test::heightMap({201, 201}, 1, [](double, double) { return 0.0; });
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png", .origin = map->origin});
    world.scene.exchange(map);
    const io::TemplateId slab = test::addTemplate(world, "slab", test::box({160, 0.5f, 160}, glm::vec4{0.5f}));
    test::addObject(world, slab, {.position = {0, -8, 0}}); // a floor below the ground
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 40, 0}, .pitch = -90});
    const auto counts = [&] {
        test::shared().render(in);
        const auto ids = test::shared().readIds({0, 0}, kSize);
        return glm::ivec2{std::ranges::count(ids, 1u), std::ranges::count(ids, renderer::kTerrainId)};
    };
    const auto brightness = [&] { // of the middle, which the floor shows
        const io::Image image = test::shared().readPicture();
        return int(image.row<glm::u8vec4>(kSize.y / 2)[kSize.x / 2].y);
    };
    test::load(world);
    EXPECT_EQ(counts().x, 0);
    const std::vector<std::uint32_t> hole(40 * 40, io::packed({.hole = true}));
    world.scene.exchange(std::make_shared<const io::CoverMap>(io::CoverMap{map->size}));
    test::load(world);
    test::shared().render(in);
    world.scene.exchange(std::make_shared<const io::CoverMap>(world.scene.cover()->with(hole, {40, 40}, {80, 80})));
    test::shared().update(world.scene, world.assets, {.cover = {{{80, 80}, {120, 120}}}});
    const glm::ivec2 seen = counts();
    EXPECT_GT(seen.x, 2000);
    EXPECT_GT(seen.y, 2000);
    const int lit = brightness();
    world.scene.exchange(std::make_shared<const io::CoverMap>(*world.scene.cover()));
    test::load(world); // all made anew
    EXPECT_EQ(counts(), seen);
    EXPECT_NEAR(brightness(), lit, 1);
    in.settings.shadows = false;
    test::shared().render(in);
    EXPECT_NEAR(brightness(), lit, 6); // the sun reaches the floor
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A map of 16 m, so that the position buffer, which repeats each 16 m, says plainly where a pixel's ground lies.
TEST(Terrain, NearTheEyeItIsTheTrianglesOfTheMap)
{
    const auto centred = test::heightMap({17, 17}, 1, [](double x, double z) {
        const unsigned h = (unsigned(int(x) + 99) * 73856093u ^ unsigned(int(z) + 99) * 19349663u) * 2654435761u;
        return 5 + double(h >> 16) / 65536.0 * 2.5;
    });
    const auto map = std::make_shared<const io::HeightMap>(centred->placed(1, {0, 0}));
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/map.png"});
    world.scene.exchange(map);
    test::load(world);
    const io::Camera camera{.eye = {8.3, 19, 8.1}, .yaw = 20, .pitch = -84, .fov = 35};
    renderer::FrameInput in = test::frame(kSize, camera);
    in.show = renderer::Show::Position;
    test::shared().render(in);
    const io::Image image = test::shared().readPicture();
    const auto ids = test::shared().readIds({0, 0}, kSize);
    int compared = 0, off = 0;
    for (int y = 4; y < kSize.y; y += 3)
        for (int x = 4; x < kSize.x; x += 3) {
            if (ids[std::size_t(y * kSize.x + x)] != renderer::kTerrainId) continue;
            const glm::dvec3 shown = glm::dvec3{image.row<glm::u8vec4>(y)[x]} / 255.0 * 16.0;
            const io::Ray ray = renderer::rayThrough(camera, kSize, {x + 0.5, y + 0.5});
            const glm::dvec3 place = ray.origin + ray.direction * ((shown.y - ray.origin.y) / ray.direction.y);
            const auto height = map->height(place.x, place.z);
            if (!height) continue;
            ++compared;
            off += std::abs(*height - shown.y) > 0.2; // steps of 6 cm, slopes of up to 2.5
        }
    EXPECT_GT(compared, 3000);
    EXPECT_LE(off, compared / 50);
}

TEST(GroundShadow, AWallShadesAsFarAsTheSunIsLow)
{
    constexpr glm::ivec2 kCells{64, 8};
    std::vector<float> heights(64 * 8, 0);
    for (int z = 0; z < 8; ++z)
        heights[std::size_t(z) * 64 + 40] = 10;
    // The sun stands in +X, at 45 degrees: the wall of 10 m at column 40 shades 10 cells of 1 m before it.
    const auto shadow = renderer::shadowHeights(kCells, heights, 1, glm::normalize(glm::dvec3{1, 1, 0}));
    const auto at = [&](int x) { return shadow[std::size_t(4) * 64 + std::size_t(x)]; };
    EXPECT_NEAR(at(39), 9, 1e-4);
    EXPECT_NEAR(at(31), 1, 1e-4);
    EXPECT_LE(at(29), 0);
    EXPECT_LE(at(45), 0) << "towards the sun it is light";
    const auto other = renderer::shadowHeights(kCells, heights, 1, glm::normalize(glm::dvec3{-1, 1, 0}));
    EXPECT_NEAR(other[4 * 64 + 41], 9, 1e-4);
    EXPECT_LT(renderer::shadowHeights(kCells, heights, 1, {0, 1, 0})[4 * 64 + 39], -1000) << "overhead nothing is shaded";
}

// A ridge across the light of a sun that sets: each step moves a shadow by what the ray turns over the way from its crest.
TEST(GroundShadow, TheSunSetsBehindARidgeWithoutAJump)
{
    constexpr glm::ivec2 kCells{256, 8};
    constexpr double kCell = 20, kStep = 0.05;
    std::vector<float> heights(std::size_t(kCells.x * kCells.y));
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = 300 * std::exp(-float(std::pow(double(i % kCells.x) - 200, 2)) / 200);
    std::vector<float> before;
    for (double elevation = 0.5; elevation > -1; elevation -= kStep) {
        const double angle = glm::radians(elevation);
        const auto shadow = renderer::shadowHeights(kCells, heights, kCell, {std::cos(angle), std::sin(angle), 0});
        if (elevation < 0) {
            EXPECT_GT(shadow[std::size_t(4) * 256 + 20], 300) << elevation << ": who looks down on a set sun sees it past the crest";
        }
        for (std::size_t i = 0; i < before.size(); ++i)
            if (i % kCells.x < 200) {
                ASSERT_NEAR(shadow[i], before[i], 256 * kCell * glm::radians(kStep) * 1.01) << elevation;
            }
        before = shadow;
    }
}

renderer::TerrainChoice::Eye walker(double x, double z, double height)
{
    return {.place = {x, height, z}, .metresPerTexel = 1, .errorAngle = 1e-3, .smallestQuad = 5e-3};
}

std::vector<renderer::ChosenNode> chosen(const renderer::TerrainTree& tree, const renderer::TerrainChoice::Eye& eye)
{
    renderer::TerrainChoice choice;
    choice.choose(tree, eye);
    return choice.nodes(tree, [](const renderer::GroundNode&) { return true; });
}

TEST(TerrainChoice, CoversEachTexelOnceAndIsFineNearTheEye)
{
    const auto map = test::heightMap({300, 421}, 1, spikes);
    const renderer::TerrainTree tree{*map};
    std::vector<int> cover(300 * 421, 0);
    int finest = 0;
    for (const auto& [node, morph, edges] : chosen(tree, walker(120, 200, 2))) {
        const glm::ivec2 low = node.origin, high = low + (TERRAIN_QUADS << node.level);
        for (int z = low.y; z < std::min(high.y, 420); ++z)
            for (int x = low.x; x < std::min(high.x, 299); ++x) {
                ++cover[std::size_t(z) * 300 + std::size_t(x)];
                if (std::hypot(x - 120.0, z - 200.0) < 80 && node.level == 0) ++finest;
            }
    }
    int wrong = 0, near = 0;
    for (int z = 0; z < 420; ++z)
        for (int x = 0; x < 299; ++x) {
            wrong += cover[std::size_t(z) * 300 + std::size_t(x)] != 1;
            near += std::hypot(x - 120.0, z - 200.0) < 80;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(finest, near);
}

// What makes the ground tight: beside one another lie nodes of one level or of the next; on an edge both sides turn by as much, a
// finer one wholly and a coarser one not at all.
TEST(TerrainChoice, NodesAgreeOnTheirEdges)
{
    const auto rough = test::heightMap({1025, 900}, 1, spikes);
    const auto lone = test::heightMap({1025, 900}, 1, [](double x, double z) { return std::abs(x - 300) + std::abs(z - 70) < 6 ? 900.0 : 0.0; });
    for (const auto& map : {rough, lone}) {
        const renderer::TerrainTree tree{*map};
        int met = 0, turning = 0, levels = 0;
        for (const double x : {3.0, 290.0, 500.0, 777.0}) {
            const auto nodes = chosen(tree, walker(x, 400, 350));
            std::vector<const renderer::ChosenNode*> at(1024 * 1024, nullptr);
            for (const renderer::ChosenNode& one : nodes) {
                const int side = TERRAIN_QUADS << one.node.level;
                for (int z = one.node.origin.y; z < std::min(one.node.origin.y + side, 1024); ++z)
                    for (int tx = one.node.origin.x; tx < std::min(one.node.origin.x + side, 1024); ++tx)
                        at[std::size_t(z) * 1024 + std::size_t(tx)] = &one;
            }
            const auto compare = [&](const renderer::ChosenNode& a, const renderer::ChosenNode& b, int edge) { // edge: of b, towards a
                const float own = b.edges[edge], other = a.edges[edge + 2];
                ++met;
                turning += own > 0 && own < 1;
                levels |= 1 << b.node.level;
                if (a.node.level == b.node.level) {
                    EXPECT_EQ(own, other);
                } else {
                    ASSERT_EQ(std::abs(a.node.level - b.node.level), 1);
                    EXPECT_EQ(std::max(own, other), 1);
                    EXPECT_EQ(a.node.level < b.node.level ? own : other, renderer::kFinerBeside);
                    EXPECT_EQ(a.node.level < b.node.level ? b.morph : a.morph, 0) << "a node beside a finer one moved";
                }
            };
            for (const renderer::ChosenNode& one : nodes) {
                const glm::ivec2 low = one.node.origin;
                const int side = TERRAIN_QUADS << one.node.level;
                for (int i = 0; i < side; i += TERRAIN_QUADS) {
                    if (low.x > 0 && low.y + i < 899) compare(*at[std::size_t(low.y + i) * 1024 + std::size_t(low.x - 1)], one, 0);
                    if (low.y > 0 && low.x + i < 1024) compare(*at[std::size_t(low.y - 1) * 1024 + std::size_t(low.x + i)], one, 1);
                }
            }
        }
        EXPECT_GT(met, 500);
        EXPECT_GT(turning, 20);
        EXPECT_GT(std::popcount(unsigned(levels)), 2);
    }
}

// A part measured anew is as if all were.
TEST(TerrainTree, FollowsAPart)
{
    const auto before = test::heightMap({700, 601}, 1, test::hills);
    io::HeightGrid hill{.size = {90, 70}};
    hill.metres.assign(90 * 70, 77);
    const io::HeightMap after = before->with(hill, {480, 240});
    renderer::TerrainTree followed{*before};
    followed.update(after, {{480, 240}, {570, 310}});
    const renderer::TerrainTree fresh{after};
    for (int level = 0; level < fresh.levels(); ++level)
        for (int z = 0; z < fresh.nodes(level).y; ++z)
            for (int x = 0; x < fresh.nodes(level).x; ++x) {
                EXPECT_EQ(followed.error(level, {x, z}), fresh.error(level, {x, z})) << level;
                EXPECT_EQ(followed.nodeAt(level, {x, z}).high, fresh.nodeAt(level, {x, z}).high) << level;
            }
    EXPECT_EQ(followed.coarsestWithin(0.5), fresh.coarsestWithin(0.5));
}

// A wall of 10 m in the north, seen from 2 m.
TEST(GroundHorizon, HidesWhatStandsBehindAndLowerOnly)
{
    renderer::GroundHorizon horizon{{0, 2, 0}};
    const auto hides = [&](glm::dvec2 from, glm::dvec2 to, double high) { return horizon.hides(horizon.look({.from = from, .to = to, .low = -100, .high = high})); };
    EXPECT_FALSE(hides({-5, -80}, {5, -60}, 3));
    horizon.add(horizon.look({.from = {-40, -30}, .to = {40, -20}, .low = 10, .high = 12}));
    EXPECT_TRUE(hides({-5, -80}, {5, -60}, 3));
    EXPECT_TRUE(hides({-5, -80}, {5, -60}, 11)) << "over the far corner of the wall one sees 11.6 m there";
    EXPECT_FALSE(hides({-5, -80}, {5, -60}, 19));
    EXPECT_FALSE(hides({60, -80}, {160, -60}, 3)) << "beside it";
    EXPECT_FALSE(hides({-5, 60}, {5, 80}, 3)) << "behind the eye";
    EXPECT_FALSE(hides({-5, -5}, {5, 5}, 3)) << "where the eye is";
    renderer::GroundHorizon above{{0, 200, 0}}; // looks down on it
    above.add(above.look({.from = {-40, -30}, .to = {40, -20}, .low = 10, .high = 12}));
    EXPECT_FALSE(above.hides(above.look({.from = {-5, -80}, .to = {5, -60}, .low = -100, .high = 3})));
}

} // namespace
