// What is asked of shadows: edges that stand still, no acne, no gaps, no caster that is lost, no seams.
#include "renderer/heavens.h"
#include "renderer/shaders/shared/shadows.h"
#include "tests/gl/support/shadow_probe.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

using test::GroundPoint;

struct Kind {
    const char* name;
    io::Shadows shadows;
};
std::vector<Kind> kinds()
{
    return {{"3 x 3", {.resolution = 1024}},
            {"5 x 5", {.resolution = 1024, .filter = io::ShadowFilter::Pcf5}},
            {"7 x 7", {.resolution = 1024, .filter = io::ShadowFilter::Pcf7}},
            {"contact", {.resolution = 1024, .contact = true}},
            {"six by hand", {.cascades = 6, .distance = 900, .splits = io::Splits::Manual, .resolution = 512}}};
}

io::Environment light(const io::Shadows& shadows, float azimuth, float elevation)
{
    io::Environment environment = test::plainEnvironment(azimuth, elevation);
    environment.shadows = shadows;
    return environment;
}

void setLight(test::TestWorld& world, const io::Environment& environment)
{
    world.scene.exchange(environment);
    test::shared().update(world.scene, world.assets, {.environment = true});
}

test::TestWorld flatGround()
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/flat.png"});
    world.scene.exchange(test::heightMap({513, 513}, 2, [](double, double) { return 0.0; }));
    return world;
}

// Towers, posts and leaning slabs on flat ground.
test::TestWorld town()
{
    test::TestWorld world = flatGround();
    const io::TemplateId kinds[] = {test::addTemplate(world, "tower", test::box({4, 20, 4}, glm::vec4{0.6f})), test::addTemplate(world, "post", test::box({0.3f, 5, 0.3f}, glm::vec4{0.6f})),
                                    test::addTemplate(world, "slab", test::box({6, 0.4f, 5}, glm::vec4{0.6f}))};
    std::mt19937 random{5};
    std::uniform_real_distribution<double> place{-200, 200}, turn{0, 360}, tilt{-50, 50};
    for (int i = 0; i < 600; ++i)
        test::addObject(world, kinds[i % 3], {.position = {place(random), i % 3 == 2 ? 4 : 0, place(random)}, .rotation = {i % 3 == 2 ? tilt(random) : 0, turn(random), 0}});
    return world;
}

TEST(ShadowQuality, ACameraThatMovesOrTurnsChangesNoEdge)
{
    test::TestWorld world = town();
    test::load(world);
    std::mt19937 random{17};
    std::uniform_real_distribution<double> unit{0, 1}, side{-1, 1};
    for (const Kind& kind : kinds()) {
        const io::Environment environment = light(kind.shadows, 150, 32);
        setLight(world, environment);
        test::ShadowProbe probe;
        const io::Camera first{.eye = {-60, 8, 80}, .yaw = 20, .pitch = -14};
        std::vector<GroundPoint> points;
        while (points.size() < 12000) {
            const double yaw = glm::radians(20 + side(random) * 60), distance = 7 + 150 * unit(random) * unit(random);
            points.push_back({{first.eye.x - std::sin(yaw) * distance, 0, first.eye.z - std::cos(yaw) * distance}});
        }
        const std::vector<float> before = probe.ask(environment, first, points);
        std::vector<int> cascades;
        std::vector<bool> seen;
        for (const GroundPoint& point : points) {
            cascades.push_back(probe.cascadeAt(point.place));
            seen.push_back(probe.seen(point.place));
        }
        ASSERT_GT(std::ranges::count_if(before, [](float v) { return v > 0.05f && v < 0.95f; }), 200) << kind.name;
        const auto changed = [&](const io::Camera& camera, bool turned, int& compared) {
            const std::vector<float> after = probe.ask(environment, camera, points);
            int changes = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                // One who steps forward takes the borders of cascades along; one who turns does not.
                const bool same = cascades[i] >= 0 && cascades[i] == probe.cascadeAt(points[i].place);
                if (!seen[i] || !probe.seen(points[i].place) || !(same || turned)) continue;
                ++compared;
                changes += std::abs(after[i] - before[i]) > 0.05f;
            }
            return changes;
        };
        int compared = 0, changes = 0;
        for (const double step : {0.001, 0.004, 0.03, 0.11, 0.4, 1.0}) {
            const double angle = unit(random) * 6.28;
            io::Camera camera = first;
            camera.eye += glm::dvec3{std::cos(angle), side(random) * 0.3, std::sin(angle)} * step;
            changes += changed(camera, false, compared);
        }
        EXPECT_GT(compared, 10000) << kind.name;
        EXPECT_LE(changes, compared / 1000) << kind.name << ", moved";
        compared = changes = 0;
        for (const float turn : {0.01f, 0.3f, 4.0f, 15.0f}) {
            io::Camera camera = first;
            camera.yaw += turn;
            camera.pitch -= turn / 3;
            changes += changed(camera, true, compared);
        }
        EXPECT_GT(compared, 10000) << kind.name;
        EXPECT_LE(changes, compared / 1000) << kind.name << ", turned";
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A plane that leans towards `azimuth` from the sun by `tilt` degrees, and points on it before a camera.
TEST(ShadowQuality, LeaningPlanesAreNotShadedByThemselves)
{
    test::TestWorld world;
    const io::ObjectId slab = test::addObject(world, test::addTemplate(world, "slab", test::box({400, 1, 400}, glm::vec4{0.6f})), {});
    std::mt19937 random{29};
    std::uniform_real_distribution<double> side{-1, 1}, unit{0, 1};
    for (const Kind& kind : kinds()) {
        test::ShadowProbe probe;
        int cases = 0;
        for (const float tilt : {0.0f, 20.0f, 45.0f, 60.0f, 75.0f})
            for (const float turn : {0.0f, 70.0f, 180.0f})
                for (const float elevation : {4.0f, 15.0f, 50.0f, 85.0f}) {
                    if (tilt == 0 && turn > 0) continue;
                    io::Object object = *world.scene.find(slab);
                    object.transform = {.rotation = {tilt, turn, 0}};
                    world.scene.exchange(slab, object);
                    const io::Environment environment = light(kind.shadows, 137, elevation);
                    world.scene.exchange(environment);
                    const glm::dmat4 matrix = io::worldFromModel(object.transform);
                    const glm::dvec3 normal = glm::normalize(glm::dvec3{matrix[1]});
                    if (glm::dot(normal, io::towardSun(environment)) < 0.06) continue; // it is turned away
                    test::load(world);
                    const double top = test::box({400, 1, 400}, glm::vec4{1})->bounds.max.y;
                    const auto onPlane = [&](double x, double z) { return glm::dvec3{matrix * glm::dvec4{x, top, z, 1}}; };
                    const io::Camera camera{.eye = onPlane(3, 5) + normal * 1.7};
                    std::vector<GroundPoint> points;
                    for (int i = 0; i < 3000; ++i) {
                        const double angle = side(random) * 3.14159, distance = 150 * unit(random) * unit(random);
                        points.push_back({onPlane(3 + std::cos(angle) * distance, 5 + std::sin(angle) * distance), glm::vec3{normal}});
                    }
                    const std::vector<float> lit = probe.ask(environment, camera, points);
                    const glm::dvec3 forward = io::forward(camera);
                    int asked = 0, dark = 0;
                    for (std::size_t i = 0; i < points.size(); ++i) {
                        if (glm::dot(points[i].place - camera.eye, forward) < 0 || !probe.seen(points[i].place)) continue;
                        ++asked;
                        dark += lit[i] < 0.95f;
                    }
                    if (asked < 300) continue;
                    ++cases;
                    EXPECT_LE(dark, asked / 1000) << kind.name << ", tilt " << tilt << ", turned " << turn << ", sun " << elevation << ", of " << asked;
                }
        EXPECT_GT(cases, 15) << kind.name;
    }
}

// From the foot of a box away from the sun, in texels until there is shadow.
TEST(ShadowQuality, ShadowsBeginAtTheFootOfWhatThrowsThem)
{
    test::TestWorld world = flatGround();
    test::addObject(world, test::addTemplate(world, "box", test::box({2, 2, 2}, glm::vec4{0.6f})), {});
    test::load(world);
    for (const Kind& kind : kinds())
        for (const float elevation : {8.0f, 25.0f, 45.0f, 70.0f}) {
            const io::Environment environment = light(kind.shadows, 180, elevation); // from the south: the shadow falls to -Z
            setLight(world, environment);
            test::ShadowProbe probe;
            for (const double away : {4.0, 12.0, 40.0, 120.0}) {
                const io::Camera camera{.eye = {away, 2, -1.2}, .yaw = 90};
                std::vector<GroundPoint> points;
                const auto ends = renderer::cascadeEnds(kind.shadows);
                const std::size_t cascade = std::size_t(std::ranges::upper_bound(ends, away) - ends.begin());
                probe.ask(environment, camera, std::vector<GroundPoint>(1));
                const double texel = probe.cascades().at(cascade).texel;
                for (int i = 0; i < 400; ++i)
                    points.push_back({{0, 0, -1 - texel * (i * 0.02)}});
                const std::vector<float> lit = probe.ask(environment, camera, points);
                const auto shadow = std::ranges::find_if(lit, [](float v) { return v < 0.5f; });
                if (texel * 4 > 2 / std::tan(glm::radians(double(elevation)))) continue; // as wide as the shadow itself
                EXPECT_LE(double(shadow - lit.begin()) * 0.02, 2.0) << kind.name << ", sun " << elevation << ", " << away << " m away";
            }
        }
}

// The camera stands where a caster's shadow falls, and looks away from the light.
void expectShadowAt(double height, double width, const std::vector<float>& elevations, double share)
{
    test::TestWorld world = flatGround();
    const io::TemplateId id = test::addTemplate(world, "tower", test::box({float(width), float(height), float(width)}, glm::vec4{0.6f}));
    const io::ObjectId tower = test::addObject(world, id, {});
    for (const Kind& kind : kinds())
        for (const float elevation : elevations) {
            const io::Environment environment = light(kind.shadows, 180, elevation);
            const double away = width / 2 + (height / std::tan(glm::radians(double(elevation)))) * share;
            io::Object object = *world.scene.find(tower);
            object.transform.position = {0, 0, away}; // its shadow reaches over the origin, to -Z
            world.scene.exchange(tower, object);
            world.scene.exchange(environment);
            test::load(world);
            test::ShadowProbe probe;
            const io::Camera camera{.eye = {0, 1.7, 1}, .pitch = -20};
            const GroundPoint points[] = {{{0, 0, -2}}, {{width + 8, 0, -12}}};
            const std::vector<float> lit = probe.ask(environment, camera, points);
            EXPECT_LT(lit[0], 0.05f) << kind.name << ", sun " << elevation << ", height " << height;
            EXPECT_GT(lit[1], 0.95f) << kind.name << ", sun " << elevation << ", height " << height;
        }
}

TEST(ShadowQuality, TowersBehindTheCameraThrowTheirs)
{
    expectShadowAt(30, 8, {5, 15, 30, 45, 60, 75}, 0.5);
    expectShadowAt(300, 14, {5, 30, 60, 85}, 0.6); // far outside of every window at most of them
}

TEST(ShadowQuality, CastersThatAreVeryTallOrFarAwayThrowTheirs)
{
    expectShadowAt(9000, 60, {10, 45, 80}, 0.7);
}

TEST(ShadowQuality, CascadesTurnIntoOneAnotherWithoutAStep)
{
    test::TestWorld world = flatGround();
    test::addObject(world, test::addTemplate(world, "beam", test::box({300, 1, 4}, glm::vec4{0.6f})), {.position = {150, 5, 0}});
    test::load(world);
    for (const float blend : {0.1f, 0.35f, 0.0f})
        for (const io::Shadows& base : {io::Shadows{.resolution = 512}, io::Shadows{.resolution = 512, .contact = true}}) {
            io::Shadows shadows = base;
            shadows.blend = blend;
            const io::Environment environment = light(shadows, 180, 50);
            setLight(world, environment);
            test::ShadowProbe probe;
            probe.mixes = true;
            const double edge = -2 - 5 / std::tan(glm::radians(50.0)); // about, where the shadow ends
            const io::Camera camera{.eye = {0, 2, edge}, .yaw = -90};
            std::vector<GroundPoint> open, along;
            for (int i = 0; i < 60000; ++i) {
                open.push_back({{1.0 + i * 0.003, 0, edge - 15}});
                along.push_back({{1.0 + i * 0.003, 0, edge + 0.02}});
            }
            const auto largestStep = [&](const std::vector<GroundPoint>& points) {
                const std::vector<float> lit = probe.ask(environment, camera, points);
                float most = 0;
                for (std::size_t i = 1; i < lit.size(); ++i)
                    most = std::max(most, std::abs(lit[i] - lit[i - 1]));
                return most;
            };
            EXPECT_LE(largestStep(open), 2.0f / 255);
            if (blend > 0) EXPECT_LE(largestStep(along), 6.0f / 255) << blend << " in 3 mm along an edge";
            else EXPECT_GT(largestStep(along), 12.0f / 255) << "there is something to blend";
        }
}

TEST(ShadowQuality, CullingLeavesTheMapsAsTheyAre)
{
    test::TestWorld world = town();
    test::load(world);
    const io::Environment environment = light({.cascades = 6, .distance = 600, .resolution = 512}, 150, 18);
    setLight(world, environment);
    test::ShadowProbe probe;
    std::vector<std::vector<float>> maps[2];
    for (const bool culling : {true, false}) {
        probe.settings.culling = culling;
        probe.ask(environment, {.eye = {-30, 4, 60}, .yaw = 30}, std::vector<GroundPoint>(1));
        for (int layer = 0; layer < 6; ++layer)
            maps[culling].push_back(test::shadowMapDepths(layer));
    }
    for (std::size_t layer = 0; layer < 6; ++layer) {
        ASSERT_EQ(maps[0][layer].size(), 512u * 512);
        EXPECT_EQ(maps[0][layer], maps[1][layer]) << layer;
        EXPECT_LT(*std::ranges::min_element(maps[0][layer]), 0.9f);
    }
}

TEST(ShadowQuality, PenumbraeWidenWithTheDistanceToWhatThrowsThem)
{
    test::TestWorld world = flatGround();
    test::addObject(world, test::addTemplate(world, "beam", test::box({60, 0.5f, 4}, glm::vec4{0.6f})), {.position = {0, 20, 0}});
    test::addObject(world, test::addTemplate(world, "wall", test::box({60, 0.5f, 4}, glm::vec4{0.6f})), {.position = {0, 0.6, -30}});
    test::load(world);
    const auto widthAt = [&](bool contact, double edge) { // m from 10 to 90 % of the light
        const io::Environment environment = light({.cascades = 1, .distance = 20, .resolution = 2048, .contact = contact}, 180, 80);
        setLight(world, environment);
        test::ShadowProbe probe;
        std::vector<GroundPoint> points;
        for (int i = 0; i < 4000; ++i)
            points.push_back({{0, 0, edge + 1 - i * 0.0005}});
        const std::vector<float> lit = probe.ask(environment, {.eye = {3, 1.7, edge}, .yaw = 90, .pitch = -20}, points);
        return double(std::ranges::count_if(lit, [](float v) { return v > 0.1f && v < 0.9f; })) * 0.0005;
    };
    const double high = -2 - 20 / std::tan(glm::radians(80.0)), low = -32 - 0.6 / std::tan(glm::radians(80.0));
    EXPECT_NEAR(widthAt(false, high), widthAt(false, low), 0.01);
    EXPECT_GT(widthAt(true, high), 2.5 * widthAt(true, low));
    // 80 % of the light of a disc comes between 0.69 of its radius to either side.
    EXPECT_NEAR(widthAt(true, high), 2 * 0.69 * 20.5 * std::tan(glm::radians(0.53 / 2)), 0.05);
}

// A map that ends as a cliff of 200 m: its shadow on what lies around ends as well.
TEST(GroundShadow, EndsBeyondTheMap)
{
    test::TestWorld world;
    world.scene.exchange(io::Terrain{.heightMap = "terrain/rim.png"});
    world.scene.exchange(test::heightMap({65, 65}, 16, [](double x, double z) { return std::max(std::abs(x), std::abs(z)) > 480 ? 200.0 : 0.0; }));
    test::load(world);
    test::ShadowProbe probe;
    for (const float azimuth : {90.0f, 200.0f, 315.0f}) {
        const io::Environment environment = light({.distance = 50}, azimuth, 30); // 346 m of shadow
        setLight(world, environment);
        const double a = glm::radians(double(azimuth));
        const glm::dvec3 toward{std::sin(a), 0, -std::cos(a)};
        const glm::dvec3 edge = -toward * (512 / std::max(std::abs(toward.x), std::abs(toward.z)));
        const std::vector<GroundPoint> points{{edge - toward * 60.0}, {edge - toward * 260.0}, {edge - toward * 450.0},
                                              {edge - toward * 5000.0}, {edge + glm::dvec3{toward.z, 0, -toward.x} * 3000.0}, {-edge + toward * 300.0}};
        const std::vector<float> lit = probe.ask(environment, {.eye = {0, 600, 0}, .pitch = -20}, points);
        const std::vector<float> expected{0, 0, 1, 1, 1, 1};
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_NEAR(lit[i], expected[i], 0.02) << azimuth << ", point " << i;
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// What a frame of a day that runs 60 times as fast changes in shadows: mostly nothing, and then no map is drawn.
TEST(ShadowQuality, StandStillInMostFramesOfARunningDay)
{
    constexpr double kTurn = 0.008; // degrees a frame
    constexpr int kFrames = 40;
    test::TestWorld world = town();
    test::load(world);
    renderer::FrameInput in = test::frame({320, 180}, {.eye = {-60, 8, 80}, .yaw = 20, .pitch = -14});
    in.show = renderer::Show::Shadow;
    std::vector<std::byte> before;
    std::uint64_t still = 0;
    int changes = 0, drawn = 0;
    for (int i = 0; i < kFrames; ++i) {
        setLight(world, light({}, float(150 + i * kTurn), float(32 + i * kTurn * 0.5)));
        test::shared().render(in);
        const std::uint64_t calls = test::shared().stats().drawCalls;
        const std::vector<std::byte> now = test::shared().readPicture().bytes;
        if (i > 0) changes += now != before, drawn += calls > still + 2; // the sky's tables follow the sun
        before = now;
        if (i > 0) continue;
        test::shared().render(in);
        still = test::shared().stats().drawCalls;
    }
    EXPECT_GT(changes, 0) << "they do follow the sun";
    EXPECT_LE(changes, kFrames / 3);
    EXPECT_LE(drawn, changes);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

// A still picture depends on no frame before it.
TEST(ShadowQuality, StepsOfTheSunHaveNoHistory)
{
    for (int i = 0; i < 20000; ++i) {
        const double height = glm::radians(-90 + 180.0 * (i % 141) / 140), around = i * 0.37;
        const glm::dvec3 sun{std::sin(around) * std::cos(height), std::sin(height), std::cos(around) * std::cos(height)};
        const glm::dvec3 step = renderer::inSteps(sun);
        ASSERT_LT(glm::degrees(glm::length(step - sun)), 0.037) << height;
        ASSERT_LT(glm::length(renderer::inSteps(step) - step), 1e-9) << height;
    }
}

} // namespace
