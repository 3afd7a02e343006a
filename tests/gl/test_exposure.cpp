// Exposure that the picture chooses, and the light that a lens scatters.
#include "renderer/passes/bloom.h"
#include "renderer/passes/exposure.h"
#include "tests/gl/support/pass_bench.h"
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{320, 180};
const io::AutoExposure kWide{.on = true, .lowest = -20, .highest = 20, .seconds = 1, .darkness = 0};

class Exposure : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
    double ev(const std::function<glm::vec3(int, int)>& light, const io::AutoExposure& wanted = kWide, std::optional<double> seconds = {})
    {
        const auto radiance = test::PassBench::radiance(kSize, light);
        bench.frame(view, [&](renderer::GpuFrame& gpu) { pass.choose(gpu, *radiance, *sky, view, wanted, seconds); });
        return pass.read();
    }
    test::PassBench bench;
    renderer::ExposurePass pass{bench.shaders};
    std::unique_ptr<renderer::GBuffer> sky = test::PassBench::bareSky(kSize);
    glsl::View view{.exposure = 1};
};

TEST_F(Exposure, EvenLightBecomesMiddleGrey)
{
    for (const float light : {1e-5f, 0.003f, 0.18f, 1.0f, 777.0f}) {
        const double got = ev([&](int, int) { return glm::vec3{light}; });
        EXPECT_NEAR(light * std::exp2(got), 0.18, 0.18 * 0.02) << light;
    }
}

TEST_F(Exposure, DarknessStaysDarkAsFarAsAskedFor)
{
    const auto light = [](float l) { return [l](int, int) { return glm::vec3{l}; }; };
    io::AutoExposure kept = kWide;
    kept.darkness = 0.5f;
    const auto shown = [&](float l) { return std::log2(l) + ev(light(l), kept) - std::log2(0.18); };
    for (const float day : {0.02f, 0.18f, 5.0f})
        EXPECT_NEAR(shown(day), 0, 0.03) << day;
    EXPECT_NEAR(shown(std::exp2(-8.5f)), -1, 0.03);
    EXPECT_NEAR(shown(std::exp2(-12.5f)), -3, 0.03);
}

TEST_F(Exposure, AFewBrightPixelsDoNotDecide)
{
    std::mt19937 random{7};
    const auto ramp = [](int x, int y) { return glm::vec3{0.05f + 0.2f * float(x) / kSize.x + 0.1f * float(y) / kSize.y}; };
    const double before = ev(ramp);
    std::vector<bool> bright(std::size_t(kSize.x) * kSize.y);
    for (std::size_t i = 0; i < bright.size(); ++i)
        bright[i] = random() % 100 == 0;
    const double after = ev([&](int x, int y) { return bright[std::size_t(y) * kSize.x + x] ? glm::vec3{1e4f} : ramp(x, y); });
    EXPECT_LT(std::abs(after - before), 0.1);
    EXPECT_LT(ev([&](int x, int y) { return x > kSize.x / 2 ? glm::vec3{1e4f} : ramp(x, y); }), before - 3) << "half of it does";
}

TEST_F(Exposure, StaysWithinItsLimitsAndAsksForCompensation)
{
    const auto grey = [](int, int) { return glm::vec3{0.18f}; };
    EXPECT_NEAR(ev(grey), 0, 0.03);
    EXPECT_NEAR(ev(grey, {.on = true, .compensation = 1.5f, .lowest = -20, .highest = 20}), 1.5, 0.03);
    EXPECT_NEAR(ev(grey, {.on = true, .lowest = 2, .highest = 4}), 2, 1e-4);
    EXPECT_NEAR(ev(grey, {.on = true, .lowest = -4, .highest = -3}), -3, 1e-4);
    EXPECT_NEAR(ev(grey, {.on = true, .lowest = 5, .highest = 3}), 3, 1e-4) << "limits that are the wrong way round";
    EXPECT_NEAR(ev([](int, int) { return glm::vec3{0}; }), 20, 1e-4) << "in the dark";
    EXPECT_TRUE(std::isfinite(ev([](int x, int) { return glm::vec3{x < 90 ? std::nanf("") : 0.18f}; })));
}

TEST_F(Exposure, TakesItsTime)
{
    const auto light = [](float l) { return [l](int, int) { return glm::vec3{l}; }; };
    EXPECT_NEAR(ev(light(0.18f)), 0, 0.03);
    EXPECT_NEAR(ev(light(0.18f / 8), kWide, 1.0), 3 * (1 - std::exp(-1)), 0.05) << "two thirds of three stops in a second";
    double now = 0;
    for (int i = 0; i < 60; ++i)
        now = ev(light(0.18f / 8), kWide, 0.1);
    EXPECT_NEAR(now, 3, 0.05);
    EXPECT_NEAR(ev(light(0.18f)), 0, 0.03) << "a cut";
    EXPECT_DOUBLE_EQ(renderer::adapted(3, 0), 1);
}

// One frame of a file is right at once, whatever was drawn before; and what takes no light keeps its colour.
TEST(ExposurePicture, AStillPictureDependsOnNothingBefore)
{
    test::TestWorld world = test::makeWorld({.heightMap = {65, 65}, .trees = 10, .boxes = 6});
    io::Environment environment = test::plainEnvironment(150, 40);
    environment.autoExposure = kWide;
    const auto draw = [&](float sun) {
        environment.sun.irradiance = glm::vec3{sun};
        world.scene.exchange(environment);
        test::shared().update(world.scene, world.assets, {.environment = true});
        test::shared().render(test::frame(kSize, {.eye = {0, 100, 60}, .pitch = -20}));
        return test::shared().readPicture().bytes;
    };
    test::load(world);
    const auto first = draw(1);
    const double ev = test::shared().readExposure();
    draw(100);
    EXPECT_NEAR(test::shared().readExposure(), ev - std::log2(100.0), 0.05);
    EXPECT_EQ(draw(1), first);
    EXPECT_NEAR(test::shared().readExposure(), ev, 1e-4);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(ExposurePicture, WhatTakesNoLightKeepsItsColour)
{
    io::Model model = *test::box({4, 4, 4}, {0.5f, 0.25f, 0.1f, 1});
    for (io::Material& material : model.materials)
        material.unlit = true;
    test::TestWorld world = test::makeWorld({.heightMap = {65, 65}, .trees = 0, .boxes = 0});
    const io::TemplateId id = test::addTemplate(world, "sign", std::make_shared<const io::Model>(model));
    test::addObject(world, id, {.position = {0, 60, 0}});
    io::Environment environment = test::plainEnvironment(150, 40);
    environment.exposure = 2;
    const io::Camera camera{.eye = {0, 62, 20}};
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings.toneMap = renderer::ToneMap::Neutral;
    const auto draw = [&] {
        world.scene.exchange(environment);
        test::load(world);
        test::shared().render(in);
        return test::shared().readPicture().row<glm::u8vec4>(kSize.y / 2)[kSize.x / 2];
    };
    const glm::ivec4 byHand{draw()};
    environment.autoExposure = {.on = true, .compensation = -3, .lowest = -20, .highest = 20};
    const glm::ivec4 byItself{draw()};
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(byItself[c], byHand[c], 2) << c;
    EXPECT_GT(std::abs(test::shared().readExposure() - 2), 1) << "the exposure is another";
    test::shared().render(in); // again, with the exposure of the frame before
    const glm::ivec4 after{test::shared().readPicture().row<glm::u8vec4>(kSize.y / 2)[kSize.x / 2]};
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(after[c], byHand[c], 2) << c;
}

class Bloom : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
    std::vector<glm::vec4> blurred(const std::function<glm::vec3(int, int)>& light, bool coarse, glm::ivec2 size = kSize)
    {
        const auto radiance = test::PassBench::radiance(size, light);
        std::vector<glm::vec4> result;
        bench.frame({.exposure = 1}, [&](renderer::GpuFrame& gpu) {
            const renderer::gl::Texture& made = pass.render(gpu, radiance->texture, coarse);
            extent = made.size();
            result = test::PassBench::read(made);
        });
        return result;
    }
    static double sum(const std::vector<glm::vec4>& texels)
    {
        double total = 0;
        for (const glm::vec4& t : texels)
            total += double(t.x);
        return total;
    }
    test::PassBench bench;
    renderer::BloomPass pass{bench.shaders};
    glm::ivec2 extent{0};
};

TEST_F(Bloom, KeepsTheSumOfLight)
{
    constexpr float kWeight = 0.04f; // as the scenes' default
    for (const bool coarse : {false, true}) {
        const double even = sum(blurred([](int, int) { return glm::vec3{0.37f}; }, coarse)) / (double(extent.x) * extent.y);
        EXPECT_NEAR(even, 0.37, 0.37 * 0.002) << coarse;

        // Lamps of many brightnesses on a dark ground, none at the rim.
        std::mt19937 random{3};
        std::vector<float> lamps(std::size_t(kSize.x) * kSize.y, 0.02f);
        for (int i = 0; i < 400; ++i)
            lamps[(40 + random() % 100) * kSize.x + 60 + random() % 200] = std::exp2(float(random() % 8));
        double in = 0;
        for (const float l : lamps)
            in += double(l);
        const double scattered = sum(blurred([&](int x, int y) { return glm::vec3{lamps[std::size_t(y) * kSize.x + x]}; }, coarse)) *
                                 (double(kSize.x) * kSize.y) / (double(extent.x) * extent.y);
        EXPECT_NEAR((in * (1 - kWeight) + scattered * kWeight) / in, 1, 0.04) << coarse; // the Karis weights take single lamps back
        const auto soft = [](int x, int y) {
            const double d = glm::length(glm::dvec2{x - 160, y - 90}) / 25;
            return glm::vec3{float(0.01 + 2 * std::exp(-d * d))};
        };
        double smooth = 0;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                smooth += double(soft(x, y).x);
        const double spread = sum(blurred(soft, coarse)) * (double(kSize.x) * kSize.y) / (double(extent.x) * extent.y);
        EXPECT_NEAR((smooth * (1 - kWeight) + spread * kWeight) / smooth, 1, 0.01) << coarse;
    }
}

TEST_F(Bloom, ABrightPixelThatMovesDoesNotFlicker)
{
    for (const bool coarse : {false, true}) {
        std::vector<double> sums;
        for (int shift = 0; shift < 8; ++shift)
            sums.push_back(sum(blurred([&](int x, int y) { return glm::vec3{x == 150 + shift && y == 91 ? 1e5f : 0.0f}; }, coarse)));
        double mean = 0, variance = 0;
        for (const double s : sums)
            mean += s / double(sums.size());
        for (const double s : sums)
            variance += (s - mean) * (s - mean) / double(sums.size());
        EXPECT_GT(mean, 0);
        EXPECT_LT(std::sqrt(variance) / mean, 0.02) << coarse;
    }
}

TEST_F(Bloom, SpreadsFarAndTakesAnySize)
{
    for (const glm::ivec2 size : {glm::ivec2{1, 1}, {3, 200}, {333, 177}, {64, 64}}) {
        const auto texels = blurred([](int x, int) { return glm::vec3{x % 2 ? 1.0f : 0.0f}; }, false, size);
        for (const glm::vec4& t : texels)
            ASSERT_TRUE(std::isfinite(t.x) && t.x >= 0 && t.x <= 1.001f);
    }
    const auto texels = blurred([](int x, int y) { return glm::vec3{std::abs(x - 160) < 4 && std::abs(y - 90) < 4 ? 100.0f : 0.0f}; }, false);
    const auto at = [&](int x, int y) { return texels[std::size_t(y / 2) * extent.x + x / 2].x; };
    EXPECT_GT(at(160, 90), at(180, 90));
    EXPECT_GT(at(180, 90), at(220, 90));
    EXPECT_GT(at(220, 90), 0);
}

} // namespace
