// Clouds: their arithmetic, how much of the sky they take, that both kinds and their shadows agree, and what stays the same.
#include "renderer/clouds.h"
#include "tests/gl/support/cloud_canvas.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{160, 90};

TEST(Clouds, PhaseOverTheSphereIsOne)
{
    double whole = 0, mean = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = -1 + 2 * (i + 0.5) / kSteps;
        const double ring = 4 * 3.14159265358979 / kSteps;
        whole += ring * glsl::cloudPhase(float(cosine));
        mean += ring * cosine * glsl::cloudPhase(float(cosine));
    }
    EXPECT_NEAR(whole, 1, 0.005);
    EXPECT_GT(mean, 0.4); // mostly ahead
}

// In steps that grow, as rays march.
TEST(Clouds, ASlabLetsThroughWhatBeerSays)
{
    for (const double depth : {0.5, 1.0, 2.0}) {
        constexpr float kMetres = 1000;
        float through = 1, light = 0, before = 0;
        for (int i = 1; i <= 56; ++i) {
            const float end = std::pow(float(i) / 56, 3.0f);
            const glm::vec2 step = glsl::cloudStep(float(depth) / kMetres, kMetres * (end - before));
            light += through * step.y;
            through *= step.x;
            before = end;
        }
        EXPECT_NEAR(through / std::exp(-depth), 1, 0.01) << depth;
        EXPECT_NEAR(light + through, 1, 1e-4) << depth; // what is not let through is scattered
    }
}

TEST(Clouds, ShellsAreMetWhereSpheresAre)
{
    constexpr double kRadius = 6361000;
    for (const double height : {2500.0, -800.0, 12000.0})
        for (const double up : {1.0, 0.5, 0.02, 0.0, -0.01, -0.05, -0.6}) {
            const glm::vec2 met = glsl::cloudShell(float(kRadius), float(up), float(height));
            const double inside = kRadius * kRadius * up * up + height * (2 * kRadius + height);
            if (inside < 0) {
                EXPECT_LT(met.y, 0);
                continue;
            }
            const double near = -kRadius * up - std::sqrt(inside), far = -kRadius * up + std::sqrt(inside);
            EXPECT_NEAR(met.x, near, std::abs(near) * 1e-3 + 1) << height << " " << up;
            EXPECT_NEAR(met.y, far, std::abs(far) * 1e-3 + 1) << height << " " << up;
        }
}

TEST(Clouds, NoiseIsSpreadEvenly)
{
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 20000; ++i)
        texels.push_back(std::uint8_t(100 + i % 7 * (i % 3) + i % 11)), texels.push_back(7);
    renderer::spreadEvenly(texels, 2, 0);
    double mean = 0;
    int low = 0;
    for (std::size_t i = 0; i < texels.size(); i += 2)
        mean += texels[i] / 20000.0, low += texels[i] < 64;
    EXPECT_NEAR(mean, 127.5, 3);
    EXPECT_NEAR(low / 20000.0, 0.25, 0.06);
    EXPECT_EQ(texels[1], 7); // another channel
}

class CloudField : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }

    // Shares of the sky straight up that let through less than 0.9: of the layer, of the volumes.
    glm::dvec2 covered(test::CloudCanvas& canvas, const io::Environment& environment, double time = 0)
    {
        const auto values = canvas.draw("cloud_cover", environment, time, renderer::CloudKind::Layer);
        glm::dvec2 share{0};
        for (const glm::vec4& value : values)
            share += glm::dvec2{value.x < 0.9f, value.y < 0.9f} / double(values.size());
        return share;
    }
};

TEST_F(CloudField, CoverageIsTheShareOfTheSky)
{
    test::CloudCanvas canvas{{128, 128}};
    for (const float softness : {0.1f, 0.25f, 0.8f}) {
        glm::dvec2 before{0};
        for (int tenth = 1; tenth <= 9; ++tenth) {
            io::Environment environment = test::plainEnvironment(150, 40);
            environment.clouds.coverage = float(tenth) / 10;
            environment.clouds.softness = softness;
            const glm::dvec2 share = covered(canvas, environment);
            EXPECT_NEAR(share.x, tenth / 10.0, 0.12) << "layer, softness " << softness;
            EXPECT_NEAR(share.y, tenth / 10.0, 0.12) << "volumes, softness " << softness;
            EXPECT_TRUE(share.x > before.x && share.y > before.y) << tenth << " " << softness;
            before = share;
        }
    }
    io::Environment environment = test::plainEnvironment(150, 40);
    EXPECT_EQ(covered(canvas, environment), glm::dvec2{0}); // none
    environment.clouds.coverage = 1;
    EXPECT_GT(covered(canvas, environment).x, 0.99);
    EXPECT_GT(covered(canvas, environment).y, 0.99);
}

TEST_F(CloudField, ShapesChangeWhileTheyDrift)
{
    test::CloudCanvas canvas{{64, 64}};
    io::Environment environment = test::plainEnvironment(150, 40);
    environment.clouds.coverage = 0.5f;
    environment.clouds.speed = 0;
    const auto differing = [&](double from, double to) {
        const auto a = canvas.draw("cloud_cover", environment, from, renderer::CloudKind::Layer);
        const auto b = canvas.draw("cloud_cover", environment, to, renderer::CloudKind::Layer);
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += std::abs(a[i].x - b[i].x) / double(a.size());
        return sum;
    };
    EXPECT_LT(differing(0, 1), 0.01);
    EXPECT_GT(differing(0, 300), 0.1);
    EXPECT_GT(differing(0, 1500 * 3), 0.05); // when one octave has come back to its beginning, others have not
    environment.clouds.change = 0;
    EXPECT_EQ(differing(0, 300), 0);
    environment.clouds.speed = 20;
    EXPECT_GT(differing(0, 300), 0.1);
}

TEST_F(CloudField, SeedAndSizeMakeOtherSkies)
{
    test::CloudCanvas canvas{{64, 64}};
    io::Environment environment = test::plainEnvironment(150, 40);
    environment.clouds.coverage = 0.5f;
    const auto first = canvas.draw("cloud_cover", environment, 5, renderer::CloudKind::Layer);
    EXPECT_TRUE(first == canvas.draw("cloud_cover", environment, 5, renderer::CloudKind::Layer));
    environment.clouds.seed = 1;
    EXPECT_FALSE(first == canvas.draw("cloud_cover", environment, 5, renderer::CloudKind::Layer));
    environment.clouds.seed = 0;
    environment.clouds.size = 3000;
    EXPECT_FALSE(first == canvas.draw("cloud_cover", environment, 5, renderer::CloudKind::Layer));
}

TEST_F(CloudField, TheMapOfShadowsIsWhatAMarchToTheSunFinds)
{
    test::CloudCanvas canvas{{10, 10}};
    for (const float elevation : {60.0f, 25.0f}) {
        io::Environment environment = test::plainEnvironment(200, elevation);
        environment.clouds.coverage = 0.5f;
        const auto values = canvas.draw("cloud_map_probe", environment, 40, renderer::CloudKind::Volume);
        double least = 1, most = 0;
        for (const glm::vec4& value : values) {
            EXPECT_NEAR(value.x, value.y, 0.05) << elevation;
            least = std::min(least, double(value.x)), most = std::max(most, double(value.x));
        }
        EXPECT_LT(least, 0.1);
        EXPECT_GT(most, 0.9);
        environment.clouds.shadow = 0;
        for (const glm::vec4& value : canvas.draw("cloud_map_probe", environment, 40, renderer::CloudKind::Volume))
            EXPECT_EQ(value.x, 1);
    }
}

// ---- in pictures ----------------------------------------------------------------------------------------------

io::Image radianceOf(const io::Environment& environment, const io::Camera& camera, renderer::CloudKind kind, double time = 0)
{
    test::TestWorld world = test::makeWorld({.heightMap = {65, 65}, .metresPerTexel = 200, .trees = 0, .boxes = 0});
    world.scene.exchange(environment);
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings.cloudKind = kind;
    in.settings.shadows = false;
    in.time = time;
    test::shared().render(in);
    return test::shared().readRadiance();
}

glm::dvec3 meanOf(const io::Image& image, int top, int bottom)
{
    glm::dvec3 sum{0};
    for (int y = top; y < bottom; ++y)
        for (int x = 0; x < image.size.x; ++x) {
            const glm::vec3 texel = image.row<glm::vec3>(y)[x];
            EXPECT_TRUE(std::isfinite(texel.x + texel.y + texel.z) && std::min({texel.x, texel.y, texel.z}) >= 0);
            sum += glm::dvec3{texel} / double((bottom - top) * image.size.x);
        }
    return sum;
}

// Kasten and Czeplak (1980) measured a quarter under eight oktas, for stratus and altostratus a sixth to a third.
TEST(CloudLight, AClosedCoverLeavesAQuarterOfNoonAndIsGrey)
{
    const io::Camera down{.eye = {0, 400, 0}, .pitch = -89};
    io::Environment environment = test::plainEnvironment(180, 60);
    const glm::dvec3 clear = meanOf(radianceOf(environment, down, renderer::CloudKind::Layer), 0, kSize.y);
    for (const renderer::CloudKind kind : {renderer::CloudKind::Layer, renderer::CloudKind::Volume}) {
        environment.clouds.coverage = 1;
        environment.clouds.thickness = 1400;
        const glm::dvec3 overcast = meanOf(radianceOf(environment, down, kind), 0, kSize.y);
        const glm::dvec3 ratio = overcast / clear;
        EXPECT_GT(ratio.y, 0.15);
        EXPECT_LT(ratio.y, 0.35);
        EXPECT_NEAR(ratio.x / ratio.y, 1, 0.12); // as neutral as the light of sun and sky together
        EXPECT_NEAR(ratio.z / ratio.y, 1, 0.15);
        environment.clouds.thickness = 6000; // a storm's
        EXPECT_LT(meanOf(radianceOf(environment, down, kind), 0, kSize.y).y, 0.6 * overcast.y);
    }
}

TEST(CloudLight, StormsAreDarkBelowAndBrightAbove)
{
    for (const renderer::CloudKind kind : {renderer::CloudKind::Layer, renderer::CloudKind::Volume}) {
        io::Environment environment = test::plainEnvironment(180, 55);
        environment.clouds.coverage = 1;
        const io::Camera up{.eye = {0, 400, 0}, .pitch = 50};
        const double thin = meanOf(radianceOf(environment, up, kind), 0, kSize.y).y;
        environment.clouds.thickness = 5000;
        environment.clouds.density = 0.06f;
        const double storm = meanOf(radianceOf(environment, up, kind), 0, kSize.y).y;
        const io::Camera above{.eye = {0, 12000, 0}, .pitch = -50};
        const double tops = meanOf(radianceOf(environment, above, kind), 0, kSize.y).y;
        EXPECT_LT(storm, 0.6 * thin);
        EXPECT_GT(tops, 3 * storm);
    }
}

TEST(CloudLight, TheSunsDiscIsGoneBehindACloud)
{
    for (const renderer::CloudKind kind : {renderer::CloudKind::Layer, renderer::CloudKind::Volume}) {
        io::Environment environment = test::plainEnvironment(0, 45);
        environment.clouds.coverage = 1;
        const io::Image image = radianceOf(environment, {.eye = {0, 400, 0}, .pitch = 45, .fov = 4}, kind);
        float most = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i)
            most = std::max(most, image.row<glm::vec3>(0)[i].y);
        EXPECT_LT(most, 1);
    }
}

TEST(CloudPicture, StandsStillWhileNothingChanges)
{
    for (const renderer::CloudKind kind : {renderer::CloudKind::Layer, renderer::CloudKind::Volume}) {
        io::Environment environment = test::plainEnvironment(90, 30);
        environment.clouds.coverage = 0.5f;
        const io::Camera camera{.eye = {0, 300, 0}, .pitch = 25};
        const io::Image first = radianceOf(environment, camera, kind, 12);
        radianceOf(environment, camera, kind, 500);
        const io::Image again = radianceOf(environment, camera, kind, 12);
        EXPECT_TRUE(first.bytes == again.bytes);
        EXPECT_FALSE(first.bytes == radianceOf(environment, camera, kind, 20).bytes);
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// From the ground, in them, above them, and where the sun has set.
TEST(CloudPicture, IsWholeFromEverywhere)
{
    for (const renderer::CloudKind kind : {renderer::CloudKind::Layer, renderer::CloudKind::Volume})
        for (const double height : {300.0, 2500.0, 3100.0, 20000.0})
            for (const float elevation : {45.0f, -2.0f}) {
                io::Environment environment = test::plainEnvironment(90, elevation);
                environment.clouds.coverage = 0.6f;
                environment.fog.density = 0.0001f;
                meanOf(radianceOf(environment, {.eye = {0, height, 0}, .yaw = 60, .pitch = -8, .fov = 80}, kind), 0, kSize.y);
            }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// Share of pixels, of those that `counts` lets through, in which two pictures differ by more than `most` of the first one's light.
template <class Counts> double shareApart(const io::Image& a, const io::Image& b, float most, Counts&& counts)
{
    int apart = 0, counted = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            if (!counts(x, y)) continue;
            const glm::vec3 here = a.row<glm::vec3>(y)[x], there = b.row<glm::vec3>(y)[x];
            apart += glm::length(here - there) > most * glm::length(here);
            ++counted;
        }
    EXPECT_GT(counted, 50);
    return double(apart) / counted;
}

// But for where it is thin.
TEST(CloudPicture, ACoverHidesWaterFromAnEyeAbove)
{
    const io::Camera above{.eye = {0, 6000, 0}, .yaw = 20, .pitch = -35};
    for (const renderer::CloudKind kind : {renderer::CloudKind::Layer, renderer::CloudKind::Volume}) {
        io::Environment environment = test::plainEnvironment(200, 50);
        environment.clouds.coverage = 1;
        environment.clouds.density = 0.08f;
        const io::Image dry = radianceOf(environment, above, kind);
        environment.water.on = true;
        environment.water.level = 100;
        EXPECT_LT(shareApart(dry, radianceOf(environment, above, kind), 0.03f, [](int, int) { return true; }), 0.01) << int(kind);
    }
}

// Air, fog and sky over a closed cover are those of a clear day: down to where the clouds end, two degrees below the level.
TEST(CloudPicture, AboveACoverTheAirIsClear)
{
    test::TestWorld world;
    const io::TemplateId peak = test::addTemplate(world, "peak", test::box({8000, 9000, 100}, {0.001f, 0.001f, 0.001f, 1}));
    test::addObject(world, peak, {.position = {-9000, 0, -40000}});
    const auto seen = [&](float coverage) {
        io::Environment environment = test::plainEnvironment(200, 50);
        environment.clouds.coverage = coverage;
        environment.fog = {.density = 0.00005f, .height = 3000};
        world.scene.exchange(environment);
        test::load(world);
        test::shared().render(test::frame(kSize, {.eye = {0, 6000, 0}, .pitch = 0, .fov = 20}));
        return test::shared().readRadiance();
    };
    EXPECT_EQ(shareApart(seen(0), seen(1), 0.05f, [](int, int y) { return y < kSize.y / 2 + 6; }), 0);
}

struct BeforeClouds {
    io::Image radiance, depth;
    bool isSky(int x, int y) const { return depth.row<glm::u8vec4>(y)[x].x == depth.row<glm::u8vec4>(0)[5].x; } // as the corner above
};

BeforeClouds beforeClouds(test::TestWorld& world, float coverage, renderer::CloudKind kind)
{
    io::Environment environment = test::plainEnvironment(90, 40);
    environment.clouds.coverage = coverage;
    environment.clouds.shadow = 0;
    world.scene.exchange(environment);
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 30, 0}, .yaw = 20, .pitch = 6, .fov = 60});
    in.settings.cloudKind = kind;
    in.ids = true;
    test::shared().render(in);
    BeforeClouds before{.radiance = test::shared().readRadiance(), .depth = {}};
    in.show = renderer::Show::Depth;
    test::shared().render(in);
    before.depth = test::shared().readPicture();
    return before;
}

// A mountain before a cloud is not touched by it, whatever the resolution that clouds are made at.
TEST(CloudPicture, NearSurfacesStandBeforeVolumes)
{
    test::TestWorld world = test::makeWorld({.heightMap = {257, 257}, .trees = 0, .boxes = 30});
    const BeforeClouds layer = beforeClouds(world, 0.7f, renderer::CloudKind::Layer), volume = beforeClouds(world, 0.7f, renderer::CloudKind::Volume);
    int surfaces = 0;
    EXPECT_EQ(shareApart(layer.radiance, volume.radiance, 0.004f, [&](int x, int y) {
        surfaces += !layer.isSky(x, y);
        return !layer.isSky(x, y);
    }), 0);
    EXPECT_GT(surfaces, 500);
    EXPECT_LT(surfaces, kSize.x * kSize.y - 500);
}

// Nor does it draw a line into the clouds along its edge.
TEST(CloudPicture, VolumesGoOnUpToSurfacesBeforeThem)
{
    test::TestWorld open, wall;
    const io::TemplateId id = test::addTemplate(wall, "wall", test::box({101, 37, 1}, {0.5f, 0.5f, 0.5f, 1}));
    test::addObject(wall, id, {.position = {-20, 20, -97}, .rotation = {0, 0, 7}});
    const BeforeClouds with = beforeClouds(wall, 1, renderer::CloudKind::Volume), without = beforeClouds(open, 1, renderer::CloudKind::Volume);
    const auto atEdge = [&](int x, int y) { return y + 2 < kSize.y && with.isSky(x, y) && !with.isSky(x, y + 2); };
    EXPECT_LT(shareApart(without.radiance, with.radiance, 0.03f, atEdge), 0.15); // the march is noisy
}

// ---- what falls from them --------------------------------------------------------------------------------------

TEST(WeatherSurface, OnlyWhatFacesUpGetsWetOrWhite)
{
    ASSERT_TRUE(test::haveContext());
    test::CloudCanvas canvas{{64, 64}};
    io::Environment environment = test::plainEnvironment(90, 40);
    const auto probe = [&](float rain, float snow) {
        environment.weather = {.rain = rain, .snow = snow};
        return canvas.draw("weather_probe", environment, 0, renderer::CloudKind::Layer);
    };
    for (const glm::vec4& value : probe(0, 0)) {
        EXPECT_EQ(value.x, 0.2f);
        EXPECT_EQ(value.y, 0.9f);
    }
    environment.water = {.on = true, .level = 1e4}; // on the bed of a lake nothing falls
    for (const glm::vec4& value : probe(50, 50)) {
        EXPECT_EQ(value.x, 0.2f);
        EXPECT_EQ(value.y, 0.9f);
    }
    environment.water.on = false;
    for (const float amount : {0.5f, 2.0f, 5.0f, 50.0f}) {
        const auto wet = probe(amount, 0), white = probe(0, amount);
        double wetMean = 0, whiteMean = 0, rough = 0;
        int ups = 0;
        for (std::size_t i = 0; i < wet.size(); ++i) {
            if (wet[i].w <= 0.29f) {
                EXPECT_EQ(wet[i].x, 0.2f);
                EXPECT_EQ(wet[i].y, 0.9f);
                EXPECT_EQ(white[i].x, 0.2f);
            }
            if (wet[i].w < 0.8f) continue;
            EXPECT_LE(wet[i].x, 0.2f);
            EXPECT_LE(wet[i].y, 0.9f);
            EXPECT_GE(white[i].x, 0.2f);
            if (amount >= 5) {
                EXPECT_NEAR(wet[i].x, 0.12f, 0.001f); // all of it
                EXPECT_NEAR(white[i].x, 0.89f, 0.001f);
            }
            wetMean += wet[i].x, whiteMean += white[i].x, rough += wet[i].y, ++ups;
        }
        if (amount == 2) { // part of it
            EXPECT_LT(wetMean / ups, 0.185);
            EXPECT_GT(wetMean / ups, 0.1);
            EXPECT_GT(whiteMean / ups, 0.25);
            EXPECT_LT(whiteMean / ups, 0.85);
        }
        if (amount >= 5) {
            EXPECT_LT(rough / ups, 0.72);
        }
    }
}

TEST(WeatherSurface, ShowsOnTheGroundOfAPicture)
{
    const io::Camera down{.eye = {0, 400, 0}, .pitch = -60};
    io::Environment environment = test::plainEnvironment(180, 60);
    const double dry = meanOf(radianceOf(environment, down, renderer::CloudKind::Layer), 30, kSize.y).y;
    environment.weather.snow = 5;
    const double white = meanOf(radianceOf(environment, down, renderer::CloudKind::Layer), 30, kSize.y).y;
    EXPECT_GT(white, 2 * dry);
}

} // namespace
