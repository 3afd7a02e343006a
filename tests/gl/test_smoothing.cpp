// Edges: each way of smoothing them against the same picture drawn with sixteen times as many pixels.
#include "renderer/passes/temporal.h"
#include "renderer/shaders/shared/tone_map.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{160, 120};
constexpr int kMore = 4; // times as many pixels along a side

std::vector<glm::vec3> lightOf(const io::Image& image) // linear
{
    std::vector<glm::vec3> light;
    for (int i = 0; i < image.size.x * image.size.y; ++i)
        light.push_back(glsl::decodeSrgb(glm::vec3{image.row<glm::u8vec4>(0)[i]} / 255.0f));
    return light;
}

class Smoothing : public testing::Test {
protected:
    // A bar before the sky, tilted.
    void tilt(float degrees)
    {
        world = {};
        const io::TemplateId bar = test::addTemplate(world, "bar", test::box({10, 1.7f, 0.2f}, {0.9f, 0.85f, 0.8f, 1}));
        object = test::addObject(world, bar, {.position = {0, 0, -8}, .rotation = {0, 0, degrees}});
        world.scene.exchange(test::plainEnvironment(180, 40));
        test::load(world);
    }
    io::Image draw(renderer::AntiAliasing kind, int times = 1, int frames = 1)
    {
        renderer::FrameInput in = test::frame(kSize * times, camera);
        in.settings.antiAliasing = kind;
        in.settings.dither = false;
        in.ids = false;
        for (int i = 0; i < frames; ++i)
            test::shared().render(in);
        EXPECT_EQ(test::shared().glErrors(), 0u);
        EXPECT_TRUE(test::shared().shaderFaults().empty());
        return test::shared().readPicture();
    }
    std::vector<glm::vec3> reference()
    {
        const std::vector<glm::vec3> fine = lightOf(draw(renderer::AntiAliasing::Off, kMore));
        std::vector<glm::vec3> light(std::size_t(kSize.x) * kSize.y, glm::vec3{0});
        for (int y = 0; y < kSize.y * kMore; ++y)
            for (int x = 0; x < kSize.x * kMore; ++x)
                light[std::size_t(y / kMore) * kSize.x + x / kMore] += fine[std::size_t(y) * kSize.x * kMore + x] / float(kMore * kMore);
        return light;
    }
    static double error(const io::Image& image, const std::vector<glm::vec3>& wanted)
    {
        const std::vector<glm::vec3> light = lightOf(image);
        double sum = 0;
        for (std::size_t i = 0; i < light.size(); ++i)
            sum += double(glm::dot(light[i] - wanted[i], light[i] - wanted[i]));
        return std::sqrt(sum / double(light.size()));
    }
    test::TestWorld world;
    io::ObjectId object{};
    io::Camera camera{.eye = {0, 0.3, 0}};
};

TEST_F(Smoothing, SmaaComesCloserThanFxaaOnMostEdges)
{
    int better = 0, edges = 0;
    for (const float degrees : {2.0f, 5.0f, 9.0f, 14.0f, 21.0f, 33.0f, 45.0f, 62.0f, 80.0f, 87.0f}) {
        tilt(degrees);
        const auto wanted = reference();
        const double off = error(draw(renderer::AntiAliasing::Off), wanted);
        const double fxaa = error(draw(renderer::AntiAliasing::Fxaa), wanted);
        const double smaa = error(draw(renderer::AntiAliasing::Smaa), wanted);
        RecordProperty("smaa at " + std::to_string(int(degrees)), std::to_string(off) + " " + std::to_string(fxaa) + " " + std::to_string(smaa));
        EXPECT_LT(smaa, off * 0.75) << degrees;
        EXPECT_LT(fxaa, off) << degrees;
        better += smaa <= fxaa;
        ++edges;
    }
    EXPECT_GE(better * 10, edges * 8) << better << " of " << edges;
}

TEST_F(Smoothing, StraightEdgesAndEvenPlacesStayAsTheyAre)
{
    tilt(0);
    EXPECT_EQ(draw(renderer::AntiAliasing::Smaa).bytes, draw(renderer::AntiAliasing::Off).bytes);
}

TEST_F(Smoothing, GatheredFramesComeCloserThanOne)
{
    for (const float degrees : {5.0f, 33.0f, 62.0f}) {
        tilt(degrees);
        const auto wanted = reference();
        const double off = error(draw(renderer::AntiAliasing::Off), wanted);
        const double gathered = error(draw(renderer::AntiAliasing::Taa, 1, 2 * renderer::kTemporalFrames), wanted);
        EXPECT_LT(gathered, off * 0.6) << degrees;
        EXPECT_FALSE(test::shared().stats().gathering) << "an untouched view is done at last";
    }
}

int farthest(const io::Image& a, const io::Image& b, int rows = kSize.y)
{
    int most = 0;
    for (std::size_t i = 0; i < std::size_t(rows) * a.rowBytes(); ++i)
        most = std::max(most, std::abs(int(a.bytes[i]) - int(b.bytes[i])));
    return most;
}

TEST_F(Smoothing, NothingIsGatheredOverACut)
{
    tilt(21);
    const io::Image plain = draw(renderer::AntiAliasing::Off);
    draw(renderer::AntiAliasing::Taa, 1, 5);
    camera.yaw = 180;
    draw(renderer::AntiAliasing::Taa);
    camera.yaw = 0;
    EXPECT_LE(farthest(draw(renderer::AntiAliasing::Taa), plain), 2) << "the first frame is as off";
    EXPECT_TRUE(test::shared().stats().gathering);
}

TEST_F(Smoothing, WhatMovedLeavesNoTrail)
{
    tilt(21);
    draw(renderer::AntiAliasing::Taa, 1, 12);
    world.scene.exchange(object, std::nullopt);
    test::shared().update(world.scene, world.assets, {.objects = {object}});
    const io::Image after = draw(renderer::AntiAliasing::Taa, 1, 3);
    EXPECT_LE(farthest(after, draw(renderer::AntiAliasing::Off), kSize.y * 2 / 5), 2) << "over the horizon, which is an edge itself";
}

TEST_F(Smoothing, IdsAreWhereTheyAreWithoutIt)
{
    tilt(21);
    renderer::FrameInput in = test::frame(kSize, camera);
    test::shared().render(in);
    const auto ids = test::shared().readIds({0, 0}, kSize);
    draw(renderer::AntiAliasing::Taa, 1, 7);
    in.settings.antiAliasing = renderer::AntiAliasing::Taa;
    test::shared().render(in);
    EXPECT_EQ(test::shared().readIds({0, 0}, kSize), ids);
}

TEST_F(Smoothing, OddSizes)
{
    tilt(21);
    for (const auto kind : {renderer::AntiAliasing::Smaa, renderer::AntiAliasing::Taa})
        for (const glm::ivec2 size : {glm::ivec2{1, 1}, {3, 90}, {131, 2}, {77, 55}}) {
            renderer::FrameInput in = test::frame(size, camera);
            in.settings.antiAliasing = kind;
            test::shared().render(in);
            test::shared().render(in);
            EXPECT_EQ(test::shared().readPicture().size, size);
        }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

} // namespace
