// Water: where it lies, what it mirrors, how deep one sees, and that time alone moves it.
#include "renderer/ripples.h"
#include "renderer/shader_library.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/water.h"
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace {

constexpr glm::ivec2 kSize{160, 120};

// A bowl whose shore is a circle, and beyond it a plain above the water.
double bowl(double x, double z)
{
    return std::min(std::hypot(x, z) * 0.2 - 8, 4.0);
}

double floorAt(double depth)
{
    return -depth;
}

io::Environment waterEnvironment(float level, float waves = 0)
{
    io::Environment environment = test::plainEnvironment(90, 50);
    environment.water.on = true;
    environment.water.level = level;
    environment.water.waves = waves;
    environment.water.foam = 0;
    return environment;
}

test::TestWorld worldOf(double (*height)(double, double), const io::Environment& environment)
{
    test::TestWorld world;
    io::Terrain terrain;
    terrain.heightMap = "terrain/bowl.png";
    world.scene.exchange(test::heightMap({257, 257}, 1, height));
    terrain.layers = {{.name = "white", .colour = {0.8f, 0.8f, 0.8f}, .roughness = 1}};
    world.scene.exchange(std::move(terrain));
    world.assets.layers.resize(1);
    world.scene.exchange(environment);
    return world;
}

io::Camera fromAbove(double height, double x = 0, double z = 0)
{
    return {.eye = {x, height, z}, .pitch = -90, .fov = 60};
}

io::Image radianceOf(test::TestWorld& world, const renderer::FrameInput& in)
{
    test::load(world);
    test::shared().render(in);
    return test::shared().readRadiance();
}

double mean(const glm::vec3& v)
{
    return (v.x + v.y + v.z) / 3.0;
}

renderer::Eye eyeAt(const glm::dvec3& place, float pitch = -10)
{
    return renderer::eyeOf({.eye = place, .pitch = pitch}, {1280, 720});
}

TEST(Water, LiesWhereTheGroundIsLower)
{
    const io::Environment environment = waterEnvironment(0);
    test::TestWorld world = worldOf(bowl, environment);
    const io::Camera camera = fromAbove(90);
    renderer::FrameInput in = test::frame(kSize, camera);
    const io::Image wet = radianceOf(world, in);
    in.settings.water = false;
    const io::Image dry = radianceOf(world, in);
    int covered = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const io::Ray ray = renderer::rayThrough(camera, kSize, {x + 0.5, y + 0.5});
            const double t = -camera.eye.y / ray.direction.y; // where it meets the level
            const glm::dvec3 at = camera.eye + ray.direction * t;
            const double fromShore = 40 - std::hypot(at.x, at.z); // m inwards
            const bool differs = wet.row<glm::vec3>(y)[x] != dry.row<glm::vec3>(y)[x];
            if (std::abs(fromShore) > 1.5) {
                EXPECT_EQ(differs, fromShore > 0) << x << " " << y;
            }
            covered += differs;
        }
    EXPECT_GT(covered, 2000);
}

TEST(Water, ReachesTheHorizonBeyondTheGround)
{
    test::TestWorld world = worldOf(bowl, waterEnvironment(0));
    const io::Camera camera{.eye = {3000, 20, 3000}, .yaw = 40, .pitch = 0, .fov = 50};
    renderer::FrameInput in = test::frame(kSize, camera);
    const io::Image wet = radianceOf(world, in);
    in.settings.water = false;
    const io::Image dry = radianceOf(world, in);
    for (const int x : {3, 80, 156}) {
        EXPECT_NE(wet.row<glm::vec3>(kSize.y / 2 + 1)[x], dry.row<glm::vec3>(kSize.y / 2 + 1)[x]); // just below it
        EXPECT_EQ(wet.row<glm::vec3>(kSize.y / 2 - 2)[x], dry.row<glm::vec3>(kSize.y / 2 - 2)[x]); // just above
    }
}

TEST(Water, CalmWaterMirrorsTheSkyByFresnel)
{
    io::Environment environment = waterEnvironment(0);
    environment.water.colour = glm::vec3{0};
    environment.water.clarity = 0.05f; // nothing comes from within
    test::TestWorld world = worldOf([](double, double) { return -50.0; }, environment);
    for (const double down : {75.0, 45.0, 20.0, 8.0}) { // degrees
        const io::Camera look{.eye = {0, 3, 0}, .yaw = 20, .pitch = float(-down), .fov = 3};
        const io::Camera mirrored{.eye = {0, 3, 0}, .yaw = 20, .pitch = float(down), .fov = 3};
        const glm::vec3 water = radianceOf(world, test::frame(kSize, look)).row<glm::vec3>(kSize.y / 2)[kSize.x / 2];
        const glm::vec3 sky = radianceOf(world, test::frame(kSize, mirrored)).row<glm::vec3>(kSize.y / 2)[kSize.x / 2];
        const double wanted = 0.02 + 0.98 * std::pow(1 - std::sin(glm::radians(down)), 5);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(water[c] / (sky[c] * wanted), 1, 0.04) << down << " degrees, channel " << c;
    }
}

TEST(Water, LightOfTheGroundFadesWithDepth)
{
    io::Environment environment = waterEnvironment(0);
    environment.water.colour = glm::vec3{0};
    const auto seen = [&](double (*ground)(double, double), float clarity, bool on) {
        environment.water.clarity = clarity;
        environment.water.on = on;
        test::TestWorld world = worldOf(ground, environment);
        // From above, away from the sun's own glint.
        const io::Image image = radianceOf(world, test::frame(kSize, fromAbove(10)));
        return mean(image.row<glm::vec3>(kSize.y / 2)[kSize.x / 2]);
    };
    const auto shallow = [](double, double) { return floorAt(1); };
    const auto deep = [](double, double) { return floorAt(4); };
    const double mirrored = seen(deep, 0.05f, true);
    for (const float clarity : {2.0f, 4.0f, 9.0f}) {
        const double one = (seen(shallow, clarity, true) - mirrored) / (0.98 * seen(shallow, clarity, false));
        const double four = (seen(deep, clarity, true) - mirrored) / (0.98 * seen(deep, clarity, false));
        EXPECT_NEAR(one, std::exp(-1 / clarity), 0.03) << clarity;
        EXPECT_NEAR(four, std::exp(-4 / clarity), 0.03) << clarity;
    }
}

// Radiance at the middle of the picture of a white thing less that of a black one: what comes through of its own light.
template <class World> double ownLight(World&& worldInColour, const renderer::FrameInput& in)
{
    const auto seen = [&](float colour) {
        test::TestWorld world = worldInColour(colour);
        return mean(radianceOf(world, in).row<glm::vec3>(kSize.y / 2)[kSize.x / 2]);
    };
    return seen(0.8f) - seen(0);
}

// The haze before water counts once, for the ground in it as for the water itself.
TEST(Water, GroundInItIsSeenThroughFogOnce)
{
    const auto ground = [](bool water, float density) {
        return ownLight(
            [&](float colour) {
                io::Environment environment = waterEnvironment(0);
                environment.water.on = water;
                environment.water.clarity = 100;
                environment.fog = {.density = density, .height = 20000};
                test::TestWorld world = worldOf([](double, double) { return floorAt(1); }, environment);
                io::Terrain terrain = world.scene.terrain();
                terrain.layers[0].colour = glm::vec3{colour};
                world.scene.exchange(std::move(terrain));
                return world;
            },
            test::frame(kSize, fromAbove(100)));
    };
    for (const float density : {0.0f, 0.004f, 0.012f})
        EXPECT_NEAR(ground(true, density) / ground(false, density), 0.98 * std::exp(-0.01), 0.02) << density;
}

TEST(Water, WhatItMirrorsIsSeenThroughFogOnce)
{
    for (const int skyPixels : {1, 4}) {
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 2, 0}, .pitch = -5, .fov = 40});
        in.settings.skyPixels = skyPixels;
        const auto wall = [&](float density) {
            return ownLight(
                [&](float colour) {
                    io::Environment environment = waterEnvironment(0);
                    environment.sun.azimuth = 180;
                    environment.fog = {.density = density, .height = 20000};
                    environment.sky.aerial = 0;
                    test::TestWorld world = worldOf([](double, double) { return -50.0; }, environment);
                    const io::TemplateId id = test::addTemplate(world, "wall", test::box({400, 400, 1}, {colour, colour, colour, 1}));
                    test::addObject(world, id, {.position = {0, -200, -120}});
                    return world;
                },
                in);
        };
        EXPECT_NEAR(wall(0.01f) / wall(0), std::exp(-0.01 * 120), 0.03) << skyPixels;
    }
}

TEST(Water, MovesWithTimeAndIsTheSameAtTheSame)
{
    test::TestWorld world = worldOf(bowl, waterEnvironment(0, 0.4f));
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 4, 20}, .pitch = -20});
    in.time = 12;
    const io::Image first = radianceOf(world, in);
    in.time = 12.4;
    const io::Image later = radianceOf(world, in);
    in.time = 12;
    EXPECT_EQ(radianceOf(world, in).bytes, first.bytes);
    EXPECT_NE(later.bytes, first.bytes);
}

TEST(Water, WithoutItNothingIsDrawn)
{
    test::TestWorld world = worldOf(bowl, waterEnvironment(0));
    test::load(world);
    const auto passes = [](const renderer::FrameInput& in) {
        test::shared().render(in);
        std::set<std::string> names;
        for (const renderer::PassTime& pass : test::shared().stats().passes)
            names.insert(pass.name);
        return names;
    };
    renderer::FrameInput in = test::frame(kSize, fromAbove(60));
    EXPECT_TRUE(passes(in).contains("water"));
    in.settings.water = false;
    EXPECT_FALSE(passes(in).contains("water"));
    in.settings.water = true;
    io::Environment dry = waterEnvironment(0);
    dry.water.on = false;
    world.scene.exchange(dry);
    test::load(world);
    EXPECT_FALSE(passes(in).contains("water"));
}

TEST(Water, PointingGoesToTheGroundUnderIt)
{
    test::TestWorld world = worldOf(bowl, waterEnvironment(0, 0.3f));
    test::load(world);
    test::shared().render(test::frame(kSize, fromAbove(60)));
    EXPECT_EQ(test::shared().readIds(kSize / 2, {1, 1}).front(), renderer::kTerrainId);
}

TEST(Water, FromWithinItIsDimAndOfItsColour)
{
    io::Environment environment = waterEnvironment(0);
    environment.water.colour = {0.01f, 0.05f, 0.06f};
    test::TestWorld world = worldOf([](double, double) { return -30.0; }, environment);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, -5, 0}, .pitch = 0});
    const io::Image image = radianceOf(world, in);
    const glm::vec3 ahead = image.row<glm::vec3>(kSize.y / 2)[kSize.x / 2];
    EXPECT_GT(ahead.z, ahead.x * 2);
    EXPECT_GT(ahead.z, 0.0005);
    in.camera.pitch = 90; // through Snell's window to the sky
    const glm::vec3 up = radianceOf(world, in).row<glm::vec3>(kSize.y / 2)[kSize.x / 2];
    EXPECT_GT(mean(up), mean(ahead));
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        ASSERT_TRUE(std::isfinite(mean(image.row<glm::vec3>(0)[i])));
}

// Far water is rougher than it looks: nothing of its slopes is lost, so nothing sparkles.
TEST(Water, RipplesKeepTheirMeanSquareSlopeInEveryMip)
{
    ASSERT_TRUE(test::haveContext());
    const renderer::gl::Texture ripples = renderer::makeRipples();
    for (int mip = 0; mip < ripples.mips(); ++mip) {
        const glm::ivec2 size = ripples.size(mip);
        std::vector<glm::vec4> texels(std::size_t(size.x) * std::size_t(size.y));
        glGetTextureImage(ripples.id(), mip, GL_RGBA, GL_FLOAT, GLsizei(texels.size() * sizeof(glm::vec4)), texels.data());
        double square = 0, held = 0;
        for (const glm::vec4& t : texels) {
            square += double(t.z);
            held += double(t.x * t.x + t.y * t.y);
            EXPECT_GE(t.z + 0.02f, t.x * t.x + t.y * t.y);
        }
        EXPECT_NEAR(square / double(texels.size()), 1, 0.02) << "mip " << mip;
        if (mip > 6) {
            EXPECT_LT(held / double(texels.size()), 0.05);
        }
    }
}

TEST(Water, WavesAreNoHigherThanAskedAndDoNotFoldOver)
{
    std::mt19937 random{3};
    std::uniform_real_distribution<float> place{-400, 400};
    for (const float waves : {0.1f, 1.0f, 6.0f}) {
        io::Environment environment = waterEnvironment(0, waves);
        environment.water.wavelength = 14;
        const glsl::Water water = renderer::waterOf(environment, eyeAt({0, 5, 0}), 3);
        float lowest = 0, highest = 0;
        for (int i = 0; i < 20000; ++i) {
            glsl::WaterShape s{};
            const glm::vec2 at{place(random), place(random)};
            for (const glsl::WaterWave& wave : water.wave)
                s = glsl::waterAdd(s, wave, at, 1);
            lowest = std::min(lowest, s.shift.y), highest = std::max(highest, s.shift.y);
            EXPECT_LT(s.crowding, 1);
        }
        EXPECT_LE(highest - lowest, waves * 1.0001f);
        EXPECT_GT(highest - lowest, waves * 0.5f);
    }
}

TEST(Water, WavesTravelWithTheWindAtTheSpeedOfDeepWater)
{
    io::Environment environment = waterEnvironment(0, 1);
    environment.wind.direction = 90; // towards +x
    const renderer::Eye eye = eyeAt({0, 5, 0});
    const double speed = std::sqrt(9.81 * environment.water.wavelength / (2 * 3.14159265358979));
    const glsl::WaterWave before = renderer::waterOf(environment, eye, 10).wave[0], after = renderer::waterOf(environment, eye, 10.5).wave[0];
    const glm::vec2 at{3, 7};
    const glsl::WaterShape a = glsl::waterAdd({}, before, at, 1), b = glsl::waterAdd({}, after, at + glm::vec2{float(speed * 0.5), 0}, 1);
    EXPECT_NEAR(a.shift.y, b.shift.y, 1e-4);
    EXPECT_NEAR(before.towards.x, 1, 1e-5);
}

// Every place around the eye lies in one patch, and culling leaves out none that is seen.
TEST(Water, PatchesFillTheSquareOnce)
{
    io::Environment environment = waterEnvironment(0, 0.5f);
    for (const glm::dvec3 place : {glm::dvec3{0, 2, 0}, glm::dvec3{1234.5, 30, -99876.5}, glm::dvec3{-7, -1, 3}}) {
        const renderer::Eye eye = eyeAt(place);
        glsl::Water water = renderer::waterOf(environment, eye, 0);
        const auto patches = renderer::waterPatches(water, eye, std::nullopt);
        ASSERT_FALSE(patches.empty());
        double area = 0;
        for (const renderer::WaterPatch& patch : patches) {
            const double side = double(patch.cell) * WATER_CELLS;
            area += side * side;
        }
        const glm::vec2 whole = glm::vec2{water.inner.z, water.inner.w} - glm::vec2{water.inner.x, water.inner.y};
        EXPECT_NEAR(area / (double(whole.x) * double(whole.y)), 1, 1e-3);
        const auto some = renderer::waterPatches(water, eye, renderer::volumeOf(eye));
        EXPECT_LT(some.size(), patches.size());
    }
}

TEST(Water, LayoutsAgree)
{
    ASSERT_TRUE(test::haveContext());
    renderer::ShaderLibrary shaders{WOLD_SOURCE_DIR "/renderer/shaders"};
    const renderer::gl::Program& p = shaders.program({.label = "water", .stages = {"water.vert.glsl", "water.frag.glsl"}, .defines = {"PATCHES"}});
    ASSERT_TRUE(p);
    const auto offset = [&](const char* name) {
        const GLuint index = glGetProgramResourceIndex(p.id(), GL_UNIFORM, name);
        constexpr GLenum kOffset = GL_OFFSET;
        GLint result = -1;
        if (index != GL_INVALID_INDEX) glGetProgramResourceiv(p.id(), GL_UNIFORM, index, 1, &kOffset, 1, nullptr, &result);
        return result;
    };
    EXPECT_EQ(offset("water.wave[1].phase"), sizeof(glsl::WaterWave) + offsetof(glsl::WaterWave, phase));
    EXPECT_EQ(offset("water.height"), offsetof(glsl::Water, height));
    EXPECT_EQ(offset("water.ripple"), offsetof(glsl::Water, ripple));
    EXPECT_EQ(offset("water.wind"), offsetof(glsl::Water, wind));
    EXPECT_EQ(offset("water.finest"), offsetof(glsl::Water, finest));
}

} // namespace
