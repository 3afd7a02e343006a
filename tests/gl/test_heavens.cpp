// The sky by night: moon and stars.
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {

io::Environment night(float phase)
{
    io::Environment environment = test::plainEnvironment(0, -30);
    environment.exposure = 3.3f;
    environment.moon.mode = io::SunMode::Manual;
    environment.moon.azimuth = 0;
    environment.moon.elevation = 40;
    environment.moon.phase = phase;
    return environment;
}

TEST(Heavens, MoonHasItsSizeAndPhase)
{
    const auto bright = [](float phase) { // pixels
        test::TestWorld world;
        io::Environment environment = night(phase);
        environment.sky.stars = 0;
        world.scene.exchange(environment);
        test::load(world);
        test::shared().render(test::frame({200, 200}, {.eye = {0, 2, 0}, .pitch = 40, .fov = 2}));
        const io::Image image = test::shared().readRadiance();
        int count = 0;
        for (int i = 0; i < 200 * 200; ++i)
            count += image.row<glm::vec3>(0)[i].y > 0.001;
        return count;
    };
    const double full = bright(0.5f);
    EXPECT_NEAR(2 * std::sqrt(full / 3.14159265) * (2.0 / 200), 0.52, 0.03);
    EXPECT_NEAR(bright(0.25f) / full, 0.5, 0.08);
    EXPECT_NEAR(bright(0.75f) / full, 0.5, 0.08);
    EXPECT_LT(bright(0.02f) / full, 0.06);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Heavens, MoonLightsTheGroundAndThrowsShadows)
{
    const auto ground = [](float phase, float brightness, double x, double z) {
        test::TestWorld world;
        world.scene.exchange(io::Terrain{.heightMap = "terrain/flat.png"});
        world.scene.exchange(test::heightMap({201, 201}, 1, [](double, double) { return 0.0; }));
        test::addObject(world, test::addTemplate(world, "tower", test::box({4, 20, 4}, {0.6f, 0.6f, 0.6f, 1})), {});
        io::Environment environment = night(phase);
        environment.moon.azimuth = 90;
        environment.moon.brightness = brightness;
        world.scene.exchange(environment);
        test::load(world);
        const io::Camera camera{.eye = {x, 30, z}, .pitch = -89.9f, .fov = 4};
        test::shared().render(test::frame({16, 16}, camera));
        return double(test::shared().readRadiance().row<glm::vec3>(8)[8].y);
    };
    const double full = ground(0.5f, 1, 0, 40), quarter = ground(0.25f, 1, 0, 40), none = ground(0.5f, 0, 0, 40);
    EXPECT_GT(full, 1.5 * quarter);
    EXPECT_GT(quarter, 1.01 * none);
    EXPECT_GT(none, 0); // night is not black
    EXPECT_LT(ground(0.5f, 1, -10, 0), 0.7 * full); // the moon stands in the east
}

// Stars stay where they are on the sphere: after a sidereal day they are back, after an hour they are not.
TEST(Heavens, StarsTurnWithTheSphere)
{
    const auto look = [](int day, double hour, float stars = 1) {
        io::Environment environment = night(0);
        environment.clock = io::Clock::Zone;
        environment.dayOfYear = day;
        environment.time = float(hour);
        environment.sky.stars = stars;
        test::TestWorld world;
        world.scene.exchange(environment);
        test::load(world);
        test::shared().render(test::frame({160, 90}, {.eye = {0, 2, 0}, .pitch = 49, .fov = 40}));
        const io::Image image = test::shared().readRadiance();
        std::vector<double> light(160 * 90);
        for (std::size_t i = 0; i < light.size(); ++i)
            light[i] = image.row<glm::vec3>(0)[i].y;
        return light;
    };
    const auto difference = [](const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0, all = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            sum += std::abs(a[i] - b[i]);
            all += a[i] + b[i];
        }
        return sum / all;
    };
    const std::vector<double> first = look(100, 22), none = look(100, 22, 0);
    EXPECT_GT(difference(first, none), 0.02);
    EXPECT_EQ(difference(first, look(100, 22)), 0);
    const double hour = difference(first, look(100, 23));
    EXPECT_LT(difference(first, look(101, 22 - 3.0 / 60 - 55.909 / 3600)), 0.3 * hour);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

} // namespace
