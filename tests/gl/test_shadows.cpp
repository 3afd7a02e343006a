// Shadows fall where the sun says, and stand still while the camera moves.
#include "io/scene/texel_rect.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{320, 180};

// A plane of 200 m with a tower of 20 m at the origin.
test::TestWorld tower(bool castShadow)
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/flat.png"});
    world.scene.exchange(test::heightMap({201, 201}, 1, [](double, double) { return 0.0; }));
    const io::TemplateId id = test::addTemplate(world, "tower", test::box({4, 20, 4}, {0.6f, 0.6f, 0.6f, 1}));
    io::Template changed = *world.scene.find(id);
    changed.castShadow = castShadow;
    world.scene.exchange(id, changed);
    test::addObject(world, id, {});
    return world;
}

// 40 m from the tower, where the light leaves its shadow.
double lightAt(const glm::dvec3& place, const io::Camera& camera, const renderer::Settings& settings = {})
{
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings = settings;
    in.settings.antiAliasing = renderer::AntiAliasing::Off;
    test::shared().render(in);
    return test::brightnessAt(test::shared().readPicture(), camera, place);
}

TEST(Shadows, TowerThrowsOneAwayFromTheSun)
{
    test::TestWorld world = tower(true);
    const io::Camera above{.eye = {0, 60, 60}, .pitch = -45};
    for (const float azimuth : {30.0f, 135.0f, 250.0f}) {
        world.scene.exchange(test::plainEnvironment(azimuth, 45));
        test::load(world);
        const double a = glm::radians(double(azimuth));
        const glm::dvec3 away{-std::sin(a) * 14, 0, std::cos(a) * 14};
        const double shaded = lightAt(away, above), lit = lightAt(-away, above);
        EXPECT_LT(shaded, lit * 0.75) << azimuth;
        renderer::Settings off;
        off.shadows = false;
        EXPECT_NEAR(lightAt(away, above, off), lit, 3) << azimuth;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Shadows, CasterBehindTheCameraCounts)
{
    test::TestWorld world = tower(true);
    world.scene.exchange(test::plainEnvironment(180, 30)); // the sun stands in the south, +Z
    test::load(world);
    const io::Camera camera{.eye = {0, 6, -8}, .pitch = -30}; // looks north, the tower behind it
    const double shaded = lightAt({0, 0, -18}, camera), lit = lightAt({9, 0, -22}, camera);
    EXPECT_LT(shaded, lit * 0.75);
}

TEST(Shadows, TemplatesThatCastNoneDoNot)
{
    const io::Camera above{.eye = {0, 60, 60}, .pitch = -45};
    test::TestWorld world = tower(false);
    world.scene.exchange(test::plainEnvironment(90, 45));
    test::load(world);
    EXPECT_NEAR(lightAt({-14, 0, 0}, above), lightAt({14, 0, 0}, above), 3);
}

TEST(Shadows, AnOpenPlaneIsNotShadedByItself)
{
    test::TestWorld world = tower(false);
    for (const float elevation : {4.0f, 12.0f, 40.0f, 88.0f}) {
        world.scene.exchange(test::plainEnvironment(120, elevation));
        test::load(world);
        renderer::FrameInput in = test::frame(kSize, {.eye = {40, 3, 40}, .yaw = 160, .pitch = -15});
        in.show = renderer::Show::Shadow;
        test::shared().render(in);
        const io::Image image = test::shared().readPicture();
        const auto ids = test::shared().readIds({0, 0}, kSize);
        int ground = 0, dark = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i) {
            if (ids[std::size_t(i)] != renderer::kTerrainId) continue;
            ++ground;
            dark += image.row<glm::u8vec4>(0)[i].x < 240;
        }
        EXPECT_GT(ground, 5000);
        EXPECT_LE(dark, ground / 1000) << elevation;
    }
}

TEST(TexelRect, whatIsLeftCoversAllOnce)
{
    std::mt19937 random{7};
    std::uniform_int_distribution<int> at{-9, 9}, extent{0, 12};
    const auto rect = [&] {
        const io::Texel low{at(random), at(random)};
        return io::TexelRect{low, low + io::Texel{extent(random), extent(random)}};
    };
    const auto holds = [](const io::TexelRect& r, int x, int y) {
        return x >= r.low.x && x < r.high.x && y >= r.low.y && y < r.high.y;
    };
    for (int i = 0; i < 500; ++i) {
        const io::TexelRect whole = rect(), hole = rect();
        const auto rest = io::without(whole, hole);
        const auto cut = io::cutAtMultiples(whole, 5);
        for (int y = -10; y < 24; ++y)
            for (int x = -10; x < 24; ++x) {
                const auto count = [&](const auto& parts) {
                    return std::ranges::count_if(parts, [&](const auto& part) { return holds(part, x, y); });
                };
                ASSERT_EQ(count(rest), holds(whole, x, y) && !holds(hole, x, y));
                ASSERT_EQ(count(cut), holds(whole, x, y));
            }
        for (const io::TexelRect& piece : cut) // inside of one copy of the texture
            for (int axis = 0; axis < 2; ++axis)
                ASSERT_EQ((piece.low[axis] + 100) / 5, (piece.high[axis] + 99) / 5);
    }
}

// Hills with towers on them.
test::TestWorld townOnHills()
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/hills.png"});
    world.scene.exchange(test::heightMap({257, 257}, 4, [](double x, double z) { return 12 * std::sin(x * 0.02) * std::cos(z * 0.017); }));
    const io::TemplateId id = test::addTemplate(world, "tower", test::box({4, 20, 4}, {0.6f, 0.6f, 0.6f, 1}));
    std::mt19937 random{5};
    std::uniform_real_distribution<double> place{-200, 200};
    for (int i = 0; i < 200; ++i)
        test::addObject(world, id, {.position = {place(random), 0, place(random)}});
    world.scene.exchange(test::plainEnvironment(150, 35));
    return world;
}

io::Image shadowsAt(const io::Camera& camera, bool anew)
{
    renderer::FrameInput in = test::frame(kSize, camera);
    in.show = renderer::Show::Shadow;
    if (anew) { // whatever is drawn without levels of detail is not kept
        in.settings.lod = false;
        test::shared().render(in);
        in.settings.lod = true;
    }
    test::shared().render(in);
    return test::shared().readPicture();
}

// Of pixels. Places are counted from the eye in floats, so that an edge may fall on the other side of a texel's middle.
double differingShare(const io::Image& a, const io::Image& b)
{
    int differing = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        differing += std::abs(int(a.row<glm::u8vec4>(0)[i].x) - int(b.row<glm::u8vec4>(0)[i].x)) > 12;
    return double(differing) / (kSize.x * kSize.y);
}

TEST(Shadows, WhatIsKeptIsAsIfDrawnAnew)
{
    test::TestWorld world = townOnHills();
    test::load(world);
    std::mt19937 random{11};
    std::uniform_real_distribution<double> step{-9, 14};
    io::Camera camera{.eye = {-60, 30, 80}, .yaw = 20, .pitch = -20};
    for (int i = 0; i < 12; ++i) {
        camera.eye += glm::dvec3{step(random), step(random) * 0.2, step(random)};
        camera.yaw += float(step(random));
        const io::Image kept = shadowsAt(camera, false);
        if (i % 3 != 2) continue;
        EXPECT_LT(differingShare(kept, shadowsAt(camera, true)), 5e-4) << i;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Shadows, WhatMovesTakesItsShadowAlong)
{
    test::TestWorld world = townOnHills();
    test::load(world);
    const io::Camera camera{.eye = {-60, 40, 80}, .yaw = 20, .pitch = -20};
    const io::Image before = shadowsAt(camera, false);
    io::Object moved = world.scene.objects()[7];
    moved.transform.position = {-70, 0, 40};
    const io::ObjectId id = moved.id;
    world.scene.exchange(id, moved);
    io::Changes changes;
    changes.objects.push_back(id);
    test::shared().update(world.scene, world.assets, changes);
    const io::Image after = shadowsAt(camera, false);
    EXPECT_GT(differingShare(before, after), 2e-3);
    EXPECT_LT(differingShare(after, shadowsAt(camera, true)), 5e-4);
}

} // namespace
