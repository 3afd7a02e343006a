// What is left out was not to be seen.
#include "renderer/cull.h"
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{320, 180};

TEST(Culling, SameIdsAndSamePictureWithAndWithout)
{
    test::TestWorld world = test::makeWorld({.heightMap = {257, 257}, .trees = 150, .boxes = 60});
    test::load(world);
    std::mt19937 random{11};
    std::uniform_real_distribution<double> place{-200, 200}, turn{-180, 180}, tilt{-60, 25};
    for (int i = 0; i < 6; ++i) {
        io::Camera camera{.eye = {place(random), 0, place(random)}, .yaw = float(turn(random)), .pitch = float(tilt(random))};
        camera.eye.y = world.scene.heights()->height(camera.eye.x, camera.eye.z).value_or(0) + 12;
        renderer::FrameInput in = test::frame(kSize, camera);
        test::shared().render(in);
        const auto ids = test::shared().readIds({0, 0}, kSize);
        const io::Image picture = test::shared().readPicture();
        const std::uint64_t drawn = test::shared().stats().instancesDrawn;
        in.settings.culling = false;
        test::shared().render(in);
        EXPECT_EQ(ids, test::shared().readIds({0, 0}, kSize)) << "camera " << i;
        EXPECT_EQ(picture.bytes, test::shared().readPicture().bytes) << "camera " << i;
        EXPECT_LT(drawn, test::shared().stats().instancesDrawn);
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// One model of four levels, whose errors are 1, 4 and 16 thousandths of its radius.
const glsl::CullModel kModel{.errors = {{0, 0.001f, 0.004f, 0.016f}, {}}, .levels = 4, .firstBin = 0, .whole = 0};

std::vector<renderer::Seen> seenOf(std::span<const glsl::CullRecord> records, const renderer::CullRequest& request,
                                   const glsl::CullModel& model = kModel)
{
    std::vector<renderer::Seen> seen;
    renderer::cull({.records = records, .models = {&model, 1}}, request, seen);
    return seen;
}

TEST(Culling, AgreesWithDoublesAwayFromThePlanes)
{
    std::mt19937 random{5};
    std::uniform_real_distribution<double> place{-4000, 4000}, size{0.1, 30};
    constexpr int kCount = 20000;
    std::vector<glsl::CullRecord> records;
    std::vector<glm::dvec4> exact;
    for (int i = 0; i < kCount; ++i) {
        exact.emplace_back(place(random), place(random) * 0.1, place(random), size(random));
        records.push_back(renderer::cullRecord(glm::dvec3{exact.back()}, exact.back().w, 0, CULL_CASTS_SHADOW));
    }
    const renderer::Eye eye = renderer::eyeOf({.eye = {30, 40, -20}, .yaw = 70, .pitch = -8}, kSize);
    const renderer::Volume volume = renderer::volumeOf(eye);
    std::vector<bool> seen(kCount);
    for (const renderer::Seen& one : seenOf(records, {.volume = volume, .eye = eye.position}))
        seen[one.slot()] = true;
    for (int i = 0; i < kCount; ++i) {
        double least = 1e30;
        for (const glm::dvec4& plane : volume.planes)
            least = std::min(least, glm::dot(glm::dvec3{plane}, glm::dvec3{exact[std::size_t(i)]}) + plane.w + exact[std::size_t(i)].w);
        EXPECT_FALSE(least > 0 && !seen[std::size_t(i)]) << i;
        EXPECT_FALSE(least < -0.1 && seen[std::size_t(i)]) << i;
    }
    const auto count = std::ranges::count(seen, true);
    EXPECT_GT(count, 100);
    EXPECT_LT(count, kCount / 2);
}

TEST(Culling, FlagsAndSmallThingsAreLeftOut)
{
    const glsl::CullRecord records[] = {renderer::cullRecord({0, 0, -10}, 1, 0, CULL_CASTS_SHADOW),
                                        renderer::cullRecord({0, 0, -10}, 1, 0, CULL_MARKER),
                                        renderer::cullRecord({0, 0, -1000}, 0.1, 0, CULL_CASTS_SHADOW)};
    const auto slots = [&](const renderer::CullRequest& request) {
        std::vector<std::uint32_t> result;
        for (const renderer::Seen& one : seenOf(records, request))
            result.push_back(one.slot());
        return result;
    };
    EXPECT_EQ(slots({.smallestAngle = 0.001f, .refused = CULL_MARKER}), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(slots({.smallestRadius = 0.05f, .required = CULL_CASTS_SHADOW}), (std::vector<std::uint32_t>{0, 2}));
}

TEST(Levels, AreChosenByTheErrorThatCanBeSeen)
{
    // With 1/1000 of the distance allowed, a sphere of 1 m takes levels 1, 2 and 3 from 2, 5 and 17 m.
    const renderer::CullRequest request{.errorAngle = 0.001f};
    const auto levelsAt = [&](double distance) {
        const glsl::CullRecord record = renderer::cullRecord({0, 0, -distance}, 1, 0, 0);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> result; // level, fade
        for (const renderer::Seen& one : seenOf({&record, 1}, request)) {
            result.emplace_back((one.drawn >> DRAWN_LEVEL_SHIFT) & DRAWN_LEVEL_MASK, one.drawn >> DRAWN_FADE_SHIFT);
            EXPECT_EQ(one.bin, result.back().first * BINS_OF_LEVEL + (result.back().second ? 1 : 0));
        }
        return result;
    };
    using Levels = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(levelsAt(0.5), (Levels{{0, 0}})) << "the eye is inside";
    EXPECT_EQ(levelsAt(1.99), (Levels{{0, 0}}));
    EXPECT_EQ(levelsAt(3), (Levels{{1, 0}}));
    EXPECT_EQ(levelsAt(4.99), (Levels{{1, 0}}));
    EXPECT_EQ(levelsAt(5.005 + 4 * LEVEL_FADE / 2), (Levels{{2, 8}, {1, 16 + 8}})) << "half way they share the pixels";
    EXPECT_EQ(levelsAt(1000), (Levels{{3, 0}}));
}

TEST(Levels, MeshesMayErrFartherThanImpostors)
{
    glsl::CullModel model = kModel;
    model.impostor = 1; // level 3
    const auto level = [&](double distance, float leeway) {
        const glsl::CullRecord record = renderer::cullRecord({0, 0, -distance}, 1, 0, 0);
        const auto seen = seenOf({&record, 1}, {.errorAngle = 0.001f, .impostors = true, .meshLeeway = leeway}, model);
        return int((seen.at(0).drawn >> DRAWN_LEVEL_SHIFT) & DRAWN_LEVEL_MASK);
    };
    EXPECT_EQ(level(1.9, 1), 0);
    EXPECT_EQ(level(1.9, 2), 1) << "from 1.5 m";
    EXPECT_EQ(level(4, 1), 1);
    EXPECT_EQ(level(4, 2), 2) << "from 3 m";
    EXPECT_EQ(level(16.5, 2), 2);
    EXPECT_EQ(level(18.5, 2), 3);
}

TEST(Levels, ParallelLightAllowsALength)
{
    const glsl::CullRecord record = renderer::cullRecord({0, 0, -5}, 2, 0, 0);
    const auto level = [&](float length) {
        const auto seen = seenOf({&record, 1}, {.towardSun = glm::dvec3{0, 1, 0}, .errorLength = length});
        EXPECT_EQ(seen.size(), 1u);
        return int((seen.at(0).drawn >> DRAWN_LEVEL_SHIFT) & DRAWN_LEVEL_MASK);
    };
    EXPECT_EQ(level(0), 0);
    EXPECT_EQ(level(0.0021f), 1);
    EXPECT_EQ(level(0.031f), 2);
    EXPECT_EQ(level(10), 3);
}

TEST(Levels, WhatBlendsSwitchesAtOnce)
{
    glsl::CullModel model = kModel;
    model.whole = 1;
    for (double distance = 1; distance < 30; distance *= 1.01) {
        const glsl::CullRecord record = renderer::cullRecord({0, 0, -distance}, 1, 0, 0);
        EXPECT_EQ(seenOf({&record, 1}, {.errorAngle = 0.001f}, model).size(), 1u) << distance;
    }
}

} // namespace
