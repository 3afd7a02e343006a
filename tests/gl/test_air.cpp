// Fog, and the shafts of light in it.
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{160, 90};

glm::dvec3 meanAround(const io::Image& image, glm::ivec2 middle, int reach)
{
    glm::dvec3 sum{0};
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            sum += glm::dvec3{image.row<glm::vec3>(middle.y + y)[middle.x + x]};
    return sum / double((2 * reach + 1) * (2 * reach + 1));
}

// A bright and a dark wall side by side at a distance: what is left of their difference is what comes through.
double throughFog(double distance, float density, bool froxels)
{
    const auto side = float(distance);
    test::TestWorld world;
    const io::TemplateId bright = test::addTemplate(world, "bright", test::box({side, side, side * 0.01f}, {0.9f, 0.9f, 0.9f, 1}));
    const io::TemplateId dark = test::addTemplate(world, "dark", test::box({side, side, side * 0.01f}, {0.02f, 0.02f, 0.02f, 1}));
    test::addObject(world, bright, {.position = {-distance / 2, -distance / 2, -distance}});
    test::addObject(world, dark, {.position = {distance / 2, -distance / 2, -distance}});
    double difference[2] = {};
    for (const bool fog : {false, true}) {
        io::Environment environment = test::plainEnvironment(180, 30); // the sun behind the eye
        environment.sky.aerial = 0;
        environment.fog = {.density = fog ? density : 0, .height = 20000};
        world.scene.exchange(environment);
        test::load(world);
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 0, 0}, .fov = 40});
        in.settings.froxels = froxels;
        test::shared().render(in);
        const io::Image image = test::shared().readRadiance();
        difference[fog] = meanAround(image, {60, 45}, 3).y - meanAround(image, {100, 45}, 3).y;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
    return difference[1] / difference[0];
}

TEST(Fog, EvenFogIsTheExponential)
{
    for (const double distance : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
        const auto density = float(std::min(0.8 / distance, 0.1));
        const double wanted = std::exp(-double(density) * distance);
        EXPECT_NEAR(throughFog(distance, density, false) / wanted, 1, 0.01) << distance;
        EXPECT_NEAR(throughFog(distance, density, true) / wanted, 1, 0.03) << distance << ", froxels";
    }
}

// What is far away in fog becomes the sky behind it.
TEST(Fog, TurnsIntoTheSky)
{
    for (const auto& [elevation, distance] : {std::pair{50.0f, 6000.0f}, {8.0f, 6000.0f}, {30.0f, 300.0f}}) { // down to thick fog
        test::TestWorld world;
        const io::TemplateId wall = test::addTemplate(world, "wall", test::box({distance * 3, distance * 0.02f, 1}, {0.5f, 0.2f, 0.1f, 1}));
        test::addObject(world, wall, {.position = {0, -distance * 0.1 / 6, -distance}});
        io::Environment environment = test::plainEnvironment(60, elevation);
        environment.fog = {.density = 6 / distance, .height = 20000};
        environment.sky.aerial = 0;
        world.scene.exchange(environment);
        test::load(world);
        test::shared().render(test::frame(kSize, {.eye = {0, 0, 0}, .fov = 2}));
        const io::Image image = test::shared().readRadiance();
        const glm::dvec3 fogged = meanAround(image, {80, 40}, 2), sky = meanAround(image, {80, 31}, 2); // a fifth of a degree higher
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(fogged[c] / sky[c], 1, 0.04) << elevation << " " << c;
    }
}

enum class Roof { None, Half, Whole };

// Open country with the sun overhead and, above the view, a roof.
class Shafts : public testing::Test {
protected:
    io::Image draw(Roof roof, bool shafts, bool picture = false, glm::ivec2 size = kSize)
    {
        test::TestWorld world;
        const io::TemplateId id = test::addTemplate(world, "roof", test::box({800, 1, 1600}, {0.5f, 0.5f, 0.5f, 1}));
        if (roof != Roof::None) test::addObject(world, id, {.position = {-400, 90, 0}});
        if (roof == Roof::Whole) test::addObject(world, id, {.position = {400, 90, 0}});
        const io::TemplateId ground = test::addTemplate(world, "ground", test::box({4000, 1, 4000}, {0.2f, 0.2f, 0.2f, 1}));
        if (picture) test::addObject(world, ground, {.position = {0, -1, 0}});
        io::Environment environment = test::plainEnvironment(0, elevation);
        environment.fog = {.density = density, .height = 20000, .shafts = amount};
        environment.shadows.distance = 300;
        environment.sky.aerial = 0;
        world.scene.exchange(environment);
        test::load(world);
        renderer::FrameInput in = test::frame(size, {.eye = {0, 3, 0}, .fov = 24});
        in.settings.froxels = true;
        in.settings.shafts = shafts;
        in.settings.dither = false;
        test::shared().render(in);
        EXPECT_EQ(test::shared().glErrors(), 0u);
        EXPECT_TRUE(test::shared().shaderFaults().empty());
        return picture ? test::shared().readPicture() : test::shared().readRadiance();
    }
    double missing(Roof roof) // of the whole picture's light
    {
        const io::Image with = draw(roof, true), without = draw(roof, false);
        double sum = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i)
            sum += double(without.row<glm::vec3>(0)[i].y) - double(with.row<glm::vec3>(0)[i].y);
        return sum;
    }
    float density = 0.002f, amount = 1, elevation = 89.9f;
};

TEST_F(Shafts, WithoutShadowsTheFogIsAsItWas)
{
    const io::Image with = draw(Roof::None, true), without = draw(Roof::None, false);
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        ASSERT_NEAR(with.row<glm::vec3>(0)[i].y / without.row<glm::vec3>(0)[i].y, 1, 0.003) << i;
}

TEST_F(Shafts, HalfOfTheFroxelsInShadowLoseHalfOfTheLight)
{
    const double whole = missing(Roof::Whole);
    EXPECT_GT(whole, 0);
    EXPECT_NEAR(missing(Roof::Half) / whole, 0.5, 0.05);
    amount = 0.5f;
    EXPECT_NEAR(missing(Roof::Whole) / whole, 0.5, 0.02) << "the field says how much is taken";
    amount = 0;
    EXPECT_EQ(missing(Roof::Whole), 0);
}

TEST_F(Shafts, NeverTakeMoreThanThereIs)
{
    density = 0.02f;
    const io::Image with = draw(Roof::Whole, true);
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        ASSERT_GE(std::min({with.row<glm::vec3>(0)[i].x, with.row<glm::vec3>(0)[i].y, with.row<glm::vec3>(0)[i].z}), 0) << i;
}

// Along the ground under the roof depth grows evenly from row to row: slices must not show.
TEST_F(Shafts, SlicesDoNotShow)
{
    density = 0.02f;
    elevation = 25; // before the eye: much of the light in fog is the sun's
    constexpr glm::ivec2 kTall{40, 1440}; // rows so narrow that depth grows by little
    const io::Image image = draw(Roof::Whole, true, true, kTall);
    int before = -1;
    for (int y = kTall.y / 2 + 60; y < kTall.y; ++y) { // nearer than where shadows end
        const int value = image.row<glm::u8vec4>(y)[kTall.x / 2].y;
        EXPECT_TRUE(before < 0 || std::abs(value - before) <= 2) << y << ": " << before << " " << value;
        before = value;
    }
}

// Fog over water is as dark as fog over ground.
TEST_F(Shafts, AreThereBeforeWaterToo)
{
    const auto missingOver = [&](bool water) {
        test::TestWorld world;
        const io::TemplateId roof = test::addTemplate(world, "roof", test::box({1600, 1, 1600}, {0.5f, 0.5f, 0.5f, 1}));
        test::addObject(world, roof, {.position = {0, 90, 0}});
        const io::TemplateId ground = test::addTemplate(world, "ground", test::box({1600, 1, 1600}, {0.05f, 0.05f, 0.05f, 1}));
        test::addObject(world, ground, {.position = {0, water ? -31.0 : -1.0, 0}});
        io::Environment environment = test::plainEnvironment(0, elevation);
        environment.fog = {.density = 0.01f, .height = 20000};
        environment.shadows.distance = 300;
        environment.sky.aerial = 0;
        environment.water = {.on = water, .clarity = 0.5f, .waves = 0};
        world.scene.exchange(environment);
        test::load(world);
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 60, 0}, .pitch = -90, .fov = 24});
        in.settings.froxels = true;
        test::shared().render(in);
        const glm::dvec3 with = meanAround(test::shared().readRadiance(), kSize / 2, 3);
        in.settings.shafts = false;
        test::shared().render(in);
        return (meanAround(test::shared().readRadiance(), kSize / 2, 3) - with).y;
    };
    const double ground = missingOver(false);
    EXPECT_GT(ground, 0);
    EXPECT_NEAR(missingOver(true) / ground, 1, 0.05);
}

// On machines without froxels: from what the picture shows, while the sun is in it.
TEST(ScreenShafts, FogIsDarkerBehindAPoleAndOnlyThere)
{
    test::TestWorld world;
    const io::TemplateId pole = test::addTemplate(world, "pole", test::box({3, 60, 3}, {0.1f, 0.1f, 0.1f, 1}));
    test::addObject(world, pole, {.position = {-20, -30, -60}});
    const auto draw = [&](bool shafts, float yaw) {
        io::Environment environment = test::plainEnvironment(0, 4); // before the eye
        environment.fog = {.density = 0.004f, .height = 20000};
        environment.sky.aerial = 0;
        world.scene.exchange(environment);
        test::load(world);
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 0, 0}, .yaw = yaw, .fov = 60});
        in.settings.shafts = shafts;
        test::shared().render(in);
        EXPECT_EQ(test::shared().glErrors(), 0u);
        EXPECT_TRUE(test::shared().shaderFaults().empty());
        return test::shared().readRadiance();
    };
    const io::Image with = draw(true, 0), without = draw(false, 0);
    const auto kept = [&](glm::ivec2 pixel) { return meanAround(with, pixel, 2).y / meanAround(without, pixel, 2).y; };
    EXPECT_LT(kept({30, 40}), 0.97) << "on the far side of the pole, seen from the sun";
    EXPECT_NEAR(kept({120, 40}), 1, 0.002) << "on the other side of the sun";
    EXPECT_NEAR(kept({70, 40}), 1, 0.002) << "between sun and pole";
    EXPECT_EQ(draw(true, 180).bytes, draw(false, 180).bytes) << "with the sun behind the eye";
}

} // namespace
