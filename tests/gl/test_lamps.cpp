// Point and spot lights: what they give, whom they reach, what stands in their way.
#include "renderer/lamp_clusters.h"
#include "renderer/shaders/shared/brdf.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{96, 64};
constexpr double kPi = 3.14159265358979;

struct Yard { // a white floor at height 0, by night
    test::TestWorld world;
    io::TemplateId lamp = io::TemplateId::None;
};

Yard yard(const io::LightSource& light, double side = 60)
{
    Yard made;
    io::Model floor = io::boxModel({float(side), 1, float(side)}, {0.64f, 0.64f, 0.64f, 1});
    floor.materials[0].metallic = 0;
    floor.materials[0].roughness = 1;
    test::addObject(made.world, test::addTemplate(made.world, "floor", std::make_shared<io::Model>(std::move(floor))), {.position = {0, -1, 0}});
    made.lamp = made.world.scene.templateSlot("lamp");
    made.world.scene.exchange(made.lamp, io::Template{.name = "lamp", .light = light});
    made.world.assets.models.resize(made.world.scene.templates().size());
    io::Environment night = test::plainEnvironment(0, -60);
    night.sky.ambient = 0;
    made.world.scene.exchange(night);
    return made;
}

io::Camera above(double height = 20)
{
    return {.eye = {0, height, 0}, .pitch = -90, .fov = 60};
}

io::Image radiance(const io::Camera& camera)
{
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings.ao = false;
    test::shared().render(in);
    return test::shared().readRadiance();
}

glm::vec3 at(const io::Image& image, const io::Camera& camera, const glm::dvec3& place)
{
    const auto pixel = renderer::project(camera, kSize, place);
    return pixel ? image.row<glm::vec3>(int(pixel->y))[int(pixel->x)] : glm::vec3{-1};
}

// Of the floor where a pixel shows it, in doubles.
glm::dvec3 expected(const io::LightSource& light, const glm::dvec3& lamp, const glm::dvec3& axis, const io::Camera& camera, glm::ivec2 pixel)
{
    const io::Ray ray = renderer::rayThrough(camera, kSize, glm::dvec2{pixel} + 0.5);
    const glm::dvec3 place = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
    const glm::dvec3 to = lamp - place, l = glm::normalize(to), v = -ray.direction;
    const double d2 = glm::dot(to, to), share = d2 / (double(light.range) * light.range);
    double strength = std::pow(std::clamp(1 - share * share, 0.0, 1.0), 2) / d2;
    if (light.kind == io::LightKind::Spot) {
        const double outer = std::cos(glm::radians(double(light.outer))), inner = std::cos(glm::radians(double(light.inner)));
        strength *= std::pow(std::clamp((-glm::dot(axis, l) - outer) / (inner - outer), 0.0, 1.0), 2);
    }
    const glsl::Reflector r = glsl::reflectorOf(glm::vec3{0.64f}, 0, 1, float(v.y));
    const glm::dvec3 h = glm::normalize(l + v);
    const glm::dvec3 lit = glm::dvec3{r.diffuse} * l.y / kPi + glm::dvec3{glsl::lobeOf(r, float(l.y), float(h.y), float(glm::dot(h, l)), 1e30f)};
    return lit * glm::dvec3{light.colour * light.intensity} * strength;
}

TEST(Lamps, PointLightGivesWhatTheFormulaSays)
{
    const io::LightSource light{.kind = io::LightKind::Point, .colour = {1, 0.5f, 0.25f}, .intensity = 3, .range = 12};
    Yard made = yard(light);
    test::addObject(made.world, made.lamp, {.position = {2, 3, -1}});
    test::load(made.world);
    const io::Image image = radiance(above());
    for (int y = 2; y < kSize.y; y += 6)
        for (int x = 2; x < kSize.x; x += 6) {
            const glm::dvec3 wanted = expected(light, {2, 3, -1}, {}, above(), {x, y});
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(image.row<glm::vec3>(y)[x][c], wanted[c], 1e-4 + 0.01 * wanted[c]) << x << " " << y;
        }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Lamps, SpotLightShinesAlongItsAxis)
{
    const io::LightSource light{.kind = io::LightKind::Spot, .colour = {1, 1, 1}, .intensity = 5, .range = 30, .inner = 15, .outer = 30, .offset = {0, 0, -0.5f}};
    Yard made = yard(light);
    const io::Transform transform{.position = {-3, 6, 2}, .rotation = {-70, 35, 0}};
    test::addObject(made.world, made.lamp, transform);
    test::load(made.world);
    const glm::dmat3 linear{io::linearPart(transform)};
    const io::Image image = radiance(above());
    double most = 0;
    for (int y = 1; y < kSize.y; y += 4)
        for (int x = 1; x < kSize.x; x += 4) {
            const glm::dvec3 wanted = expected(light, transform.position + linear * glm::dvec3{0, 0, -0.5}, linear * glm::dvec3{0, 0, -1}, above(), {x, y});
            EXPECT_NEAR(image.row<glm::vec3>(y)[x].x, wanted.x, 2e-4 + 0.015 * wanted.x) << x << " " << y;
            most = std::max(most, wanted.x);
        }
    EXPECT_GT(most, 0.01);
}

TEST(Lamps, AThousandAtOnceAreTheirSum)
{
    const io::LightSource light{.kind = io::LightKind::Point, .colour = {1, 0.8f, 0.6f}, .intensity = 0.5f, .range = 6};
    Yard made = yard(light, 200);
    std::mt19937 random{3};
    std::uniform_real_distribution<double> place{-15, 15}, height{0.5, 3};
    std::vector<glm::dvec3> lamps;
    for (int i = 0; i < 1000; ++i) {
        lamps.emplace_back(place(random), height(random), place(random));
        test::addObject(made.world, made.lamp, {.position = lamps.back()});
    }
    test::load(made.world);
    for (const io::Camera& camera : {above(), io::Camera{.eye = {0, 5, 20}, .pitch = -25, .fov = 60}}) {
        const io::Image image = radiance(camera);
        for (int y = kSize.y / 2; y < kSize.y; y += 7)
            for (int x = 3; x < kSize.x; x += 11) {
                glm::dvec3 sum{0};
                for (const glm::dvec3& lamp : lamps)
                    sum += expected(light, lamp, {}, camera, {x, y});
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(image.row<glm::vec3>(y)[x][c], sum[c], 2e-4 + 0.01 * sum[c]) << x << " " << y;
            }
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Lamps, MirrorFollowsWhatChanges)
{
    io::LightSource light{.kind = io::LightKind::Point, .colour = {1, 1, 1}, .intensity = 2, .range = 8};
    Yard made = yard(light);
    io::Scene& scene = made.world.scene;
    const io::ObjectId id = test::addObject(made.world, made.lamp, {.position = {-5, 2, 0}});
    test::load(made.world);
    const auto light_ = [&](double x) { return at(radiance(above()), above(), {x, 0, 0}).x; };
    EXPECT_GT(light_(-5), 0.05);
    EXPECT_LT(light_(5), 1e-4);

    io::Object moved = scene.at(id); // moved
    moved.transform.position.x = 5;
    scene.exchange(id, moved);
    test::shared().update(scene, made.world.assets, {.objects = {id}});
    EXPECT_LT(light_(-5), 1e-4);
    const float bright = light_(5);
    EXPECT_GT(bright, 0.05);

    io::Template dimmed = *scene.find(made.lamp); // its template edited
    dimmed.light.intensity = 1;
    scene.exchange(made.lamp, dimmed);
    test::shared().update(scene, made.world.assets, {.templates = {made.lamp}});
    EXPECT_NEAR(light_(5), bright / 2, bright * 0.01);

    const io::ObjectId second = test::addObject(made.world, made.lamp, {.position = {5, 2, 0}}); // added
    test::shared().update(scene, made.world.assets, {.objects = {second}});
    EXPECT_NEAR(light_(5), bright, bright * 0.01);

    scene.exchange(id, std::optional<io::Object>{}); // deleted
    test::shared().update(scene, made.world.assets, {.objects = {id}});
    EXPECT_NEAR(light_(5), bright / 2, bright * 0.01);

    dimmed.light.kind = io::LightKind::None; // a lamp no more
    scene.exchange(made.lamp, dimmed);
    test::shared().update(scene, made.world.assets, {.templates = {made.lamp}});
    EXPECT_EQ(light_(5), 0);
}

TEST(Lamps, SwitchedOffTheyAreDark)
{
    Yard made = yard({.kind = io::LightKind::Point, .intensity = 2, .range = 10});
    test::addObject(made.world, made.lamp, {.position = {0, 2, 0}});
    test::load(made.world);
    renderer::FrameInput in = test::frame(kSize, above());
    const auto brightest = [&] {
        test::shared().render(in);
        const io::Image image = test::shared().readRadiance();
        return at(image, above(), {0.5, 0, 0.5}).x;
    };
    EXPECT_GT(brightest(), 0.01);
    in.settings.lamps = false;
    EXPECT_EQ(brightest(), 0);
}

TEST(Lamps, BadOnesShineNotAtAll)
{
    const io::Object object{.id = io::ObjectId(1)};
    const auto shines = [&](io::LightSource light) { return renderer::lampOf(object, light).has_value(); };
    const io::LightSource good{.kind = io::LightKind::Spot};
    EXPECT_TRUE(shines(good));
    io::LightSource bad = good;
    bad.intensity = std::nanf("");
    EXPECT_FALSE(shines(bad));
    bad = good;
    bad.range = -1;
    EXPECT_FALSE(shines(bad));
    bad = good;
    bad.offset.x = INFINITY;
    EXPECT_FALSE(shines(bad));
    bad = good;
    bad.inner = 80; // wider than the outer
    ASSERT_TRUE(shines(bad));
    EXPECT_LE(renderer::lampOf(object, bad)->inner, renderer::lampOf(object, bad)->outer);
    io::Object nowhere = object;
    nowhere.transform.position.y = INFINITY;
    EXPECT_FALSE(renderer::lampOf(nowhere, good));
}

// A roof of 4 m at half the lamp's height.
struct Shaded {
    Yard made;
    io::ObjectId roof, lamp;
};

Shaded roofed(io::LightSource light, const io::Transform& lamp, bool ownModel = false)
{
    Shaded shaded{.made = yard(light)};
    test::TestWorld& world = shaded.made.world;
    const io::TemplateId roof = test::addTemplate(world, "roof", test::box({4, 0.2f, 4}, {0.5f, 0.5f, 0.5f, 1}));
    shaded.roof = test::addObject(world, roof, {.position = {0, 2, 0}});
    if (ownModel) { // around the light on all sides
        io::Template value = *world.scene.find(shaded.made.lamp);
        value.model = "models/lamp.glb";
        world.scene.exchange(shaded.made.lamp, value);
        world.assets.models.resize(world.scene.templates().size());
        world.assets.models[io::number(shaded.made.lamp) - 1] = test::box({0.6f, 0.6f, 0.6f}, {1, 1, 1, 1});
    }
    shaded.lamp = test::addObject(world, shaded.made.lamp, lamp);
    return shaded;
}

const io::Camera kAside{.eye = {0, 9, 16}, .pitch = -28, .fov = 60};

TEST(Lamps, WhatStandsInTheLightThrowsAShadow)
{
    io::LightSource point{.kind = io::LightKind::Point, .intensity = 20, .range = 30, .castShadow = true};
    io::LightSource spot{.kind = io::LightKind::Spot, .intensity = 20, .range = 30, .inner = 50, .outer = 58, .castShadow = true};
    for (io::LightSource light : {point, spot}) {
        Shaded shaded = roofed(light, {.position = {0, 4, 0}, .rotation = {-90, 0, 0}});
        test::load(shaded.made.world);
        const io::Image image = radiance(kAside);
        const float under = at(image, kAside, {0, 0, 2.8}).x, lit = at(image, kAside, {0, 0, 5.5}).x;
        EXPECT_LT(under, 0.01 * lit) << int(light.kind); // the shadow reaches to 4 m
        EXPECT_GT(lit, 0.01) << int(light.kind);

        light.castShadow = false;
        io::Template open = *shaded.made.world.scene.find(shaded.made.lamp);
        open.light = light;
        shaded.made.world.scene.exchange(shaded.made.lamp, open);
        test::shared().update(shaded.made.world.scene, shaded.made.world.assets, {.templates = {shaded.made.lamp}});
        const io::Image without = radiance(kAside);
        EXPECT_GT(at(without, kAside, {0, 0, 2.8}).x, lit);
        EXPECT_NEAR(at(without, kAside, {0, 0, 5.5}).x, lit, lit * 0.02); // nothing else is darker by it
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Lamps, ALanternLetsItsOwnLightOut)
{
    const io::LightSource light{.kind = io::LightKind::Point, .intensity = 20, .range = 30, .offset = {0, 0.3f, 0}, .castShadow = true};
    Shaded shaded = roofed(light, {.position = {0, 3.7, 0}}, true);
    test::load(shaded.made.world);
    const io::Image image = radiance(kAside);
    EXPECT_GT(at(image, kAside, {0, 0, 5.5}).x, 0.02);
    EXPECT_LT(at(image, kAside, {0, 0, 2.8}).x, 1e-3);
}

TEST(Lamps, ShadowsAreKeptUntilSomethingMovesInTheLight)
{
    const io::LightSource light{.kind = io::LightKind::Point, .intensity = 20, .range = 10, .castShadow = true};
    Shaded shaded = roofed(light, {.position = {0, 4, 0}});
    io::Scene& scene = shaded.made.world.scene;
    const io::TemplateId rock = test::addTemplate(shaded.made.world, "rock", test::box({1, 1, 1}, {1, 1, 1, 1}));
    const io::ObjectId far = test::addObject(shaded.made.world, rock, {.position = {200, 0, 0}});
    test::load(shaded.made.world);
    const auto triangles = [&] {
        radiance(kAside);
        return test::shared().stats().trianglesSubmitted;
    };
    const auto move = [&](io::ObjectId id, double x) {
        io::Object moved = scene.at(id);
        moved.transform.position.x = x;
        scene.exchange(id, moved);
        test::shared().update(scene, shaded.made.world.assets, {.objects = {id}});
    };
    const std::uint64_t first = triangles(), kept = triangles();
    EXPECT_LT(kept, first);
    for (int frame = 0; frame < 40; ++frame) { // out of reach, for long: by night the sun's shadow maps do not forget it
        for (int i = 0; i < 10; ++i)
            move(far, 220 + i);
        EXPECT_EQ(triangles(), kept);
    }
    move(shaded.roof, 3);
    EXPECT_GT(triangles(), kept);
    EXPECT_EQ(triangles(), kept);
    const io::Image image = radiance(kAside); // its shadow went along
    EXPECT_GT(at(image, kAside, {-2.5, 0, 0.5}).x, 0.02);
    EXPECT_LT(at(image, kAside, {5.5, 0, 0.5}).x, 1e-3);
}

// An open floor does not shade itself, however the light falls.
TEST(Lamps, NothingShadesItself)
{
    const io::LightSource light{.kind = io::LightKind::Point, .intensity = 5, .range = 25, .castShadow = true};
    for (const double height : {0.4, 1.5, 6.0}) {
        Yard made = yard(light);
        test::addObject(made.world, made.lamp, {.position = {0.3, height, 0.2}});
        test::load(made.world);
        const io::Image image = radiance(above(16));
        int wrong = 0, count = 0;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const double wanted = expected(light, {0.3, height, 0.2}, {}, above(16), {x, y}).x;
                if (wanted < 1e-3) continue;
                ++count;
                wrong += image.row<glm::vec3>(y)[x].x < wanted * 0.9;
            }
        EXPECT_GT(count, 500);
        EXPECT_LE(wrong, count / 200) << height;
    }
}

TEST(LampClusters, EveryLampIsWhereItShines)
{
    std::mt19937 random{8};
    std::uniform_real_distribution<double> place{-60, 60}, unit{-1, 1}, size{0.5, 25}, turn{-180, 180};
    std::uniform_real_distribution<float> angle{0.1f, 1.5f};
    for (int view = 0; view < 6; ++view) {
        const io::Camera camera{.eye = {place(random), place(random), place(random)}, .yaw = float(turn(random)), .pitch = float(turn(random) / 2), .fov = 70};
        const renderer::Eye eye = renderer::eyeOf(camera, {160, 90});
        std::vector<renderer::Lamp> lamps;
        for (int i = 0; i < 200; ++i) {
            renderer::Lamp lamp{.place = camera.eye + glm::dvec3{place(random), place(random), place(random)}, .intensity = glm::vec3{1}, .range = float(size(random))};
            lamp.direction = glm::normalize(glm::vec3{unit(random), unit(random), unit(random)});
            lamp.outer = i % 2 ? angle(random) : 0.0f;
            lamps.push_back(lamp);
        }
        const renderer::LampClusters clusters = renderer::clustersOf(lamps, eye);
        int missing = 0, inside = 0;
        double listed = 0, reached = 0;
        for (int i = 0; i < 3000; ++i) {
            const glm::dvec2 ndc{unit(random), unit(random)};
            const double depth = std::exp2(unit(random) * 5 + 2);
            const glm::dvec3 relative = (eye.forward + eye.right * (ndc.x * eye.tanHalfFov * eye.aspect) + eye.up * (ndc.y * eye.tanHalfFov)) * depth;
            const glm::ivec2 tile = glm::ivec2{glm::floor((ndc * 0.5 + 0.5) * glm::dvec2{LAMP_TILES_X, LAMP_TILES_Y})};
            const int slice = std::clamp(int(std::log2(float(depth)) * clusters.sliceScale + clusters.sliceBias), 0, LAMP_SLICES - 1);
            const std::size_t cluster = std::size_t((slice * LAMP_TILES_Y + tile.y) * LAMP_TILES_X + tile.x);
            const auto list = std::span{clusters.lists}.subspan(clusters.lists[2 * cluster], clusters.lists[2 * cluster + 1]);
            listed += double(list.size());
            for (std::uint32_t lamp = 0; lamp < lamps.size(); ++lamp) {
                const glm::dvec3 from = eye.position + relative - lamps[lamp].place;
                const double away = glm::length(from);
                if (away >= lamps[lamp].range * 0.999) continue;
                if (lamps[lamp].isSpot() && glm::dot(from / away, glm::dvec3{lamps[lamp].direction}) <= std::cos(lamps[lamp].outer) + 1e-3) continue;
                ++inside;
                reached += 1;
                missing += std::ranges::find(list, lamp) == list.end();
            }
        }
        EXPECT_GT(inside, 100);
        EXPECT_EQ(missing, 0) << view;
        EXPECT_LT(listed, reached * 6 + 3000) << view;
    }
}

} // namespace
