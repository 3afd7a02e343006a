// How surfaces answer light, against integrals in doubles; and what the GBuffer keeps of them.
#include "renderer/eye.h"
#include "renderer/light.h"
#include "renderer/shaders/shared/brdf.h"
#include "renderer/shaders/shared/octahedron.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kRoughnesses[] = {0.045f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1};
constexpr float kCosines[] = {0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.7f, 0.9f, 1};

// The lobe over a hemisphere of radiance 1: light directions spread as GGX reflects them, so that mirrors need no more samples.
double mirrored(const glsl::Reflector& r)
{
    constexpr int kSide = 160;
    const double a2 = double(r.alpha) * r.alpha;
    const glm::dvec3 v{std::sqrt(1 - double(r.nov) * r.nov), 0, r.nov};
    double sum = 0;
    for (int i = 0; i < kSide; ++i)
        for (int k = 0; k < kSide; ++k) {
            const double u = (i + 0.5) / kSide, phi = 2 * kPi * (k + 0.5) / kSide;
            const double noh = std::sqrt((1 - u) / (1 + (a2 - 1) * u)), sine = std::sqrt(1 - noh * noh);
            const glm::dvec3 h{sine * std::cos(phi), sine * std::sin(phi), noh};
            const double voh = glm::dot(v, h);
            const glm::dvec3 l = 2 * voh * h - v;
            if (l.z <= 0 || voh <= 0) continue;
            const double d = noh * noh * (a2 - 1) + 1;
            const double density = a2 / (kPi * d * d) * noh / (4 * voh);
            sum += double(glsl::lobeOf(r, float(l.z), float(noh), float(voh), 1e30f).x) / density;
        }
    return sum / (kSide * kSide);
}

TEST(Surfaces, WhiteFurnaceKeepsTheLight)
{
    for (const float roughness : kRoughnesses)
        for (const float nov : kCosines) {
            const glsl::Reflector r = glsl::reflectorOf(glm::vec3{1}, 0, roughness, nov);
            const double sun = mirrored(r) + r.diffuse.x;          // light by light
            const double sky = double(r.mirrored.x) + r.diffuse.x; // by the split sum, as ambient light goes
            EXPECT_GE(sun, 0.90) << roughness << " " << nov;
            EXPECT_LE(sun, 1.001) << roughness << " " << nov;
            EXPECT_NEAR(sky, 1, 1e-3) << roughness << " " << nov;
        }
}

TEST(Surfaces, MetalsKeepWhatTheirFacetsHandOn)
{
    double worst = 1, worstOnce = 1;
    for (const float roughness : kRoughnesses)
        for (const float nov : kCosines) {
            const glsl::Reflector r = glsl::reflectorOf(glm::vec3{1}, 1, roughness, nov);
            const double whole = mirrored(r);
            worst = std::min(worst, whole);
            worstOnce = std::min(worstOnce, whole / r.gain.x);
            EXPECT_NEAR(whole, 1, 0.10) << roughness << " " << nov;
        }
    RecordProperty("least reflected", std::to_string(worst));
    RecordProperty("least reflected by single scattering", std::to_string(worstOnce));
    EXPECT_LT(worstOnce, 0.5); // what is lost without
}

TEST(Surfaces, BlinnPhongMeansTheSameRoughness)
{
    for (const float roughness : {0.2f, 0.4f, 0.7f}) {
        const float alpha = roughness * roughness;
        const double n = 2 / (double(alpha) * alpha) - 2;
        EXPECT_NEAR(glsl::blinnPhong(alpha, 1) / ((n + 8) / (8 * kPi)), 1, 1e-4);
        EXPECT_NEAR(glsl::blinnPhong(alpha, 0.95f) / ((n + 8) / (8 * kPi) * std::pow(0.95, n)), 1, 1e-3);
        // (n + 8) / (8 pi) is the norm of the lobe times the cosine, seen from straight above.
        double sum = 0;
        constexpr int kSteps = 20000;
        for (int i = 0; i < kSteps; ++i) {
            const double theta = (i + 0.5) / kSteps * kPi / 2, half = theta / 2;
            sum += glsl::blinnPhong(alpha, float(std::cos(half))) * std::cos(theta) * std::sin(theta) * 2 * kPi * (kPi / 2 / kSteps);
        }
        EXPECT_NEAR(sum, 1, 0.12) << roughness;
    }
}

TEST(Surfaces, OctahedralNormalsComeBack)
{
    std::mt19937 random{4};
    std::normal_distribution<double> axis;
    const auto kept = [](glm::vec2 p) { return glm::round(glm::clamp(p, -1.0f, 1.0f) * 32767.0f) / 32767.0f; };
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        glm::dvec3 n{axis(random), axis(random), axis(random)};
        if (i < 6) n = glm::dvec3{i / 2 == 0, i / 2 == 1, i / 2 == 2} * (i % 2 ? 1.0 : -1.0);
        n = glm::normalize(n);
        const glm::vec2 stored = kept(glsl::octahedral(glm::vec3{n}));
        const glm::vec3 back = glsl::fromOctahedral(stored);
        worst = std::max(worst, std::asin(std::min(glm::length(glm::cross(n, glm::dvec3{back})), 1.0)));
        const glm::vec3 again = glsl::fromOctahedral(kept(glsl::octahedral(back)));
        EXPECT_LE(glm::distance(back, again), 3e-7f); // stable
    }
    EXPECT_LE(glm::degrees(worst), 0.004);
}

// A plate with its top at the origin, seen from above; the sun, and no sky.
test::TestWorld plate(const glm::vec3& colour, float metallic, float roughness, const io::Environment& environment)
{
    test::TestWorld world;
    io::Model model = io::boxModel({20, 1, 20}, {colour, 1});
    model.materials[0].metallic = metallic;
    model.materials[0].roughness = roughness;
    const io::TemplateId id = test::addTemplate(world, "plate", std::make_shared<io::Model>(std::move(model)));
    test::addObject(world, id, {.position = {0, -1, 0}});
    io::Environment dark = environment;
    dark.sky.ambient = 0;
    world.scene.exchange(dark);
    return world;
}

renderer::FrameInput plainFrame(glm::ivec2 size, const io::Camera& camera)
{
    renderer::FrameInput in = test::frame(size, camera);
    in.settings.shadows = in.settings.ao = false;
    return in;
}

glm::dvec3 sunAt(const io::Environment& e, double height)
{
    return glm::dvec3{e.sun.irradiance} *
           glm::dvec3{renderer::sunThrough(renderer::atmosphereOf(e.sky, height), height, io::towardSun(e),
                                           glm::radians(double(e.sun.angularDiameter)) / 2)};
}

TEST(Surfaces, SunOnAWhiteWallGivesEOverPi)
{
    const io::Environment e = test::plainEnvironment(0, 90);
    test::TestWorld world = plate(glm::vec3{1}, 0, 1, e);
    test::load(world);
    const io::Camera camera{.eye = {0, 6, 0}, .pitch = -90, .fov = 2};
    test::shared().render(plainFrame({32, 32}, camera));
    const glm::dvec3 got{test::shared().readRadiance().row<glm::vec3>(16)[16]};
    const glsl::Reflector r = glsl::reflectorOf(glm::vec3{1}, 0, 1, 1);
    for (int c = 0; c < 3; ++c) { // the Lambert part, of what the lobe leaves
        const double lobe = glsl::lobeOf(r, 1, 1, 1, 1e30f)[c];
        const double lambert = (got[c] / sunAt(e, 6)[c] - lobe) / (1 - double(r.mirrored[c]));
        EXPECT_NEAR(lambert * kPi, 1, 1e-3) << c;
    }
}

// In doubles, with formulas of its own but for what becomes of the rest of the light.
glm::dvec3 expectedRadiance(const glm::dvec3& colour, double metallic, double roughness, const glm::dvec3& v, const glm::dvec3& l)
{
    const glm::dvec3 h = glm::normalize(v + l);
    const double a2 = std::pow(roughness, 4), noh = h.y, nol = l.y, nov = v.y;
    const double d = a2 / (kPi * std::pow(noh * noh * (a2 - 1) + 1, 2));
    const auto lambda = [&](double c) { return (std::sqrt(1 + a2 * (1 - c * c) / (c * c)) - 1) / 2; };
    const double g = 1 / (1 + lambda(nol) + lambda(nov));
    const glm::dvec3 f0 = glm::mix(glm::dvec3{0.04}, colour, metallic);
    const glm::dvec3 f = f0 + (1.0 - f0) * std::pow(1 - glm::dot(h, l), 5);
    const glsl::Reflector rest = glsl::reflectorOf(glm::vec3{colour}, float(metallic), float(roughness), float(nov));
    const glm::dvec3 lobe = f * glm::dvec3{rest.gain} * (d * g / (4 * nol * nov));
    return (colour * (1 - metallic) * (1.0 - glm::dvec3{rest.mirrored}) / kPi + lobe) * nol;
}

TEST(Surfaces, MetallicRoughnessSweepIsTheReferences)
{
    const io::Environment e = test::plainEnvironment(180, 40); // the sun in the south, +Z
    const glm::dvec3 toSun = io::towardSun(e), colour{0.64, 0.36, 0.16}; // squares of halves, as kept
    const io::Camera camera{.eye = {0, 4, -6}, .yaw = 180, .pitch = -30, .fov = 50};
    constexpr glm::ivec2 kSize{48, 32};
    for (const double metallic : {0.0, 0.4, 1.0})
        for (const int rough : {3, 5, 7, 9, 12, 15}) {
            const double roughness = rough / 15.0;
            test::TestWorld world = plate(glm::vec3{colour}, float(metallic), float(roughness), e);
            test::load(world);
            test::shared().render(plainFrame(kSize, camera));
            const io::Image image = test::shared().readRadiance();
            double squares = 0;
            int count = 0;
            for (int y = 0; y < kSize.y; ++y)
                for (int x = 0; x < kSize.x; ++x) {
                    const io::Ray ray = renderer::rayThrough(camera, kSize, {x + 0.5, y + 0.5});
                    const glm::dvec3 at = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
                    if (ray.direction.y > -0.02 || std::max(std::abs(at.x), std::abs(at.z)) > 9.5) continue;
                    const glm::dvec3 wanted = expectedRadiance(colour, metallic, roughness, -ray.direction, toSun) * sunAt(e, camera.eye.y);
                    const glm::dvec3 got{image.row<glm::vec3>(y)[x]};
                    const glm::dvec3 error = glm::min(got, 1.0) - glm::min(wanted, 1.0);
                    squares += glm::dot(error, error) / 3;
                    ++count;
                }
            ASSERT_GT(count, 500);
            EXPECT_LE(std::sqrt(squares / count), 1 / 255.0) << "metallic " << metallic << " roughness " << roughness;
        }
}

TEST(Surfaces, AHighlightIsNoBrighterThanTheSun)
{
    const io::Environment e = test::plainEnvironment(0, 90);
    test::TestWorld world = plate(glm::vec3{1}, 1, 0.05f, e);
    test::load(world);
    const io::Camera camera{.eye = {0, 6, 0}, .pitch = -90, .fov = 2};
    test::shared().render(plainFrame({32, 32}, camera));
    const float got = test::shared().readRadiance().row<glm::vec3>(16)[16].y;
    const double disc = sunAt(e, 6).y / (4 * kPi * std::pow(std::sin(glm::radians(0.265) / 2), 2));
    EXPECT_LE(got, disc * 1.01);
    EXPECT_GT(got, disc * 0.2); // and not much darker
}

TEST(Surfaces, PositionsComeBackFromDepth)
{
    std::mt19937 random{9};
    std::uniform_real_distribution<double> across{-1, 1}, far{1, 5000};
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 ray{across(random) * 1.03, across(random) * 0.58, 1}; // as `ray` of full_screen.vert.glsl
        const double distance = i < 1000 ? 5000 : far(random);
        const float depth = float(renderer::kNear / distance); // what a 32-bit depth buffer keeps
        const glm::vec3 back = glm::vec3{ray} * (float(renderer::kNear) / depth);
        worst = std::max(worst, glm::distance(glm::dvec3{back}, ray * distance));
    }
    EXPECT_LE(worst, 0.002);
}

TEST(Surfaces, TheSameFrameTwiceIsTheSame)
{
    test::TestWorld world = test::makeWorld({.heightMap = {129, 129}, .trees = 60, .boxes = 10});
    world.scene.exchange(test::plainEnvironment(140, 35));
    test::load(world);
    renderer::FrameInput in = test::frame({160, 90}, {.eye = {0, 60, 60}, .pitch = -30});
    for (const renderer::Show show : {renderer::Show::Albedo, renderer::Show::Normal, renderer::Show::Roughness, renderer::Show::Ao}) {
        in.show = show;
        test::shared().render(in);
        const io::Image first = test::shared().readPicture();
        test::shared().render(in);
        EXPECT_EQ(first.bytes, test::shared().readPicture().bytes) << int(show);
    }
}

// A glowing thing by night is brighter than middle grey by far, and no darker by day.
TEST(Surfaces, WhatGlowsIsBrightByNightAndByDay)
{
    for (const float elevation : {-30.0f, 50.0f}) {
        io::Environment e = test::plainEnvironment(180, elevation);
        test::TestWorld world;
        io::Model model = io::boxModel({1, 1, 1}, {0.2f, 0.2f, 0.2f, 1});
        model.materials[0].emissive = {1, 0.6f, 0.2f};
        model.materials[0].metallic = 0;
        test::addObject(world, test::addTemplate(world, "glow", std::make_shared<io::Model>(std::move(model))), {});
        world.scene.exchange(e);
        test::load(world);
        test::shared().render(test::frame({32, 32}, {.eye = {0, 0.5, 4}, .fov = 6}));
        const glm::vec3 got = test::shared().readRadiance().row<glm::vec3>(16)[16];
        const glm::vec3 seen = got * std::exp2(e.exposure);
        EXPECT_GT(seen.r, 3) << elevation; // more than the picture's white: it blooms
        EXPECT_NEAR(got.r, 1, elevation < 0 ? 0.05 : 0.2) << elevation;
        EXPECT_NEAR(got.g / got.r, 0.6, 0.05);
    }
}

} // namespace
