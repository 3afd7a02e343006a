// The wind: what it does to a plant is bounded, keeps its length and goes on in time; and what is drawn of that agrees
// in every pass.
#include "renderer/cull.h"
#include "renderer/wind.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{320, 180};

glsl::Wind windAt(double time, float speed = 8, const glm::dvec3& eye = {})
{
    return renderer::windOf({.speed = speed, .direction = 70, .gustiness = 0.5f}, true, eye, time);
}

glsl::Sway swayAt(const glsl::Wind& wind, const glm::vec2& place, std::uint32_t id, float height = 12)
{
    return glsl::windSway(wind, glsl::windPlace(wind, place, {0, 0}), 1, height, glsl::windPhase(id));
}

TEST(Wind, APlantKeepsItsLengthAndStandsOnItsRoot)
{
    std::mt19937 random{2};
    std::uniform_real_distribution<float> side{-5, 5}, up{0, 12}, time{0, 900}, speed{0, 60};
    for (int i = 0; i < 2000; ++i) {
        const glsl::Wind wind = windAt(time(random), speed(random));
        const glsl::Sway sway = swayAt(wind, {side(random), side(random)}, std::uint32_t(i));
        const glm::vec3 point{side(random), up(random), side(random)};
        const glm::vec3 moved = glsl::windBent(point, sway.top, point.y / 12);
        EXPECT_NEAR(glm::length(moved), glm::length(point), 0.001f * glm::length(point));
        EXPECT_EQ(glsl::windBent({point.x, 0, point.z}, sway.top, 0), (glm::vec3{point.x, 0, point.z}));
        EXPECT_EQ(glsl::windLeaf(point, 0, time(random), 0.3f), glm::vec3{0});
    }
}

TEST(Wind, GoesNoFartherThanBoundsAllow)
{
    std::mt19937 random{3};
    std::uniform_real_distribution<float> side{-9, 9}, share{0, 1}, time{0, 5000}, speed{0, 60}, tall{0.2f, 30};
    for (int i = 0; i < 20000; ++i) {
        const io::Wind blows{.speed = speed(random), .direction = side(random) * 40, .gustiness = share(random)};
        const glsl::Wind wind = renderer::windOf(blows, true, {}, time(random));
        const float height = tall(random), amount = share(random), up = share(random);
        const glm::vec2 place = glm::vec2{side(random), side(random)} * 100.0f;
        const glsl::Sway sway = glsl::windSway(wind, place, amount, height, std::uint32_t(i) & 255u);
        const glm::vec3 point{side(random), height * up, side(random)};
        const glm::vec3 leaf = glsl::windLeaf(point, up, wind.time, 0.2f) * sway.flutter;
        const glm::vec3 moved = glsl::windBent(point, sway.top, up) + leaf;
        ASSERT_LE(glm::length(moved - point), glsl::windReach(glsl::windMost(wind), amount * height) + 1e-4f);
        ASSERT_LE(glsl::windReach(glsl::windMost(wind), height), height * WIND_MOST_REACH);
    }
}

TEST(Wind, NothingMovesWhereNoneBlows)
{
    for (const glsl::Wind& wind : {windAt(7, 0), renderer::windOf({}, false, {}, 7)}) {
        EXPECT_EQ(glsl::windReach(glsl::windMost(wind), 9), 0);
        EXPECT_EQ(swayAt(wind, {3, 4}, 9).top, glm::vec2{0});
        EXPECT_EQ(swayAt(wind, {3, 4}, 9).flutter, 0);
    }
}

TEST(Wind, EachPlantSwaysForItself)
{
    const glsl::Wind wind = windAt(12);
    int alike = 0;
    for (std::uint32_t id = 1; id <= 200; ++id)
        alike += glm::length(swayAt(wind, {0, 0}, id).top - swayAt(wind, {0, 0}, id + 1).top) < 0.002f;
    EXPECT_LT(alike, 20);
    double mean = 0, least = 1, most = 0;
    for (int i = 0; i < 4000; ++i) {
        const float gust = glsl::windGust({i * 7.31f, i * 3.17f});
        mean += gust / 4000.0, least = std::min(least, double(gust)), most = std::max(most, double(gust));
    }
    EXPECT_NEAR(mean, 0.5, 0.06);
    EXPECT_LT(least, 0.12);
    EXPECT_GT(most, 0.88);
}

// Neither a frame nor the end of a period nor an eye that goes on makes a plant jump.
TEST(Wind, GoesOnWithoutAJump)
{
    for (const double time : {0.0, 31.7, 1024.0 - 1 / 120.0, 51200.0 - 1 / 120.0})
        for (std::uint32_t id = 1; id < 50; ++id) {
            const glm::vec2 place{id * 13.0f, id * -7.0f};
            const glm::vec2 before = swayAt(windAt(time), place, id).top;
            EXPECT_LT(glm::length(swayAt(windAt(time + 1 / 60.0), place, id).top - before), 0.02f) << time;
            EXPECT_LT(glm::length(swayAt(windAt(time, 8, {511, 0, 3}), place, id).top -
                                  swayAt(windAt(time, 8, {513, 0, 3}), place, id).top), 1e-3f) << time;
        }
}

// A tree that sways and a box that does not, 6 m apart on a plane.
struct Windy {
    test::TestWorld world;
    io::ObjectId tree{}, box{};

    explicit Windy(float amount = 1, float speed = 12, bool ground = true)
    {
        if (ground) {
            world.scene.exchange(io::Terrain{.heightMap = "terrain/flat.png"});
            world.scene.exchange(test::heightMap({201, 201}, 2, [](double, double) { return 0.0; }));
        }
        tree = test::addObject(world, sways("tree", test::treeModel(), amount), {});
        const io::TemplateId still = test::addTemplate(world, "box", test::box({2, 4, 2}, {0.6f, 0.5f, 0.4f, 1}));
        box = test::addObject(world, still, {.position = {6, 0, 0}});
        io::Environment environment = test::plainEnvironment(90, 40);
        environment.wind = {.speed = speed, .direction = 0, .gustiness = 0.5f};
        world.scene.exchange(environment);
        test::load(world);
    }
    io::TemplateId sways(const std::string& name, std::shared_ptr<const io::Model> model, float amount)
    {
        const io::TemplateId id = test::addTemplate(world, name, std::move(model));
        io::Template changed = *world.scene.find(id);
        changed.wind = amount;
        world.scene.exchange(id, changed);
        return id;
    }
};

struct Shown {
    io::Image image;
    std::vector<std::uint32_t> ids;
    bool operator==(const Shown& other) const { return image.bytes == other.image.bytes && ids == other.ids; }
};

renderer::FrameInput frameAt(double time, const io::Camera& camera)
{
    renderer::FrameInput in = test::frame(kSize, camera);
    in.time = time;
    return in;
}

Shown shown(const renderer::FrameInput& in)
{
    test::shared().render(in);
    return {test::shared().readPicture(), test::shared().readIds({0, 0}, in.size)};
}

const io::Camera kBefore{.eye = {2, 4, 16}};

TEST(Sway, MovesWhatSwaysAndNothingElse)
{
    Windy windy;
    const Shown first = shown(frameAt(1, kBefore)), again = shown(frameAt(1, kBefore));
    const Shown later = shown(frameAt(3, kBefore));
    EXPECT_TRUE(first == again) << "the same moment is the same picture";
    EXPECT_FALSE(first == later);
    const auto owned = [](const Shown& s, io::ObjectId id) {
        std::vector<bool> mask;
        for (const std::uint32_t one : s.ids)
            mask.push_back(one == io::number(id));
        return mask;
    };
    EXPECT_NE(owned(first, windy.tree), owned(later, windy.tree));
    EXPECT_EQ(owned(first, windy.box), owned(later, windy.box));

    Windy still{0};
    EXPECT_TRUE(shown(frameAt(1, kBefore)) == shown(frameAt(3, kBefore)));
    Windy calm{1, 0};
    EXPECT_TRUE(shown(frameAt(1, kBefore)) == shown(frameAt(3, kBefore)));
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Sway, SwitchedOffIsAsIfNoneBlew)
{
    renderer::FrameInput in = frameAt(1, kBefore), later = frameAt(3, kBefore);
    in.settings.wind = later.settings.wind = false;
    Windy windy;
    const Shown off = shown(in);
    EXPECT_TRUE(off == shown(later));
    Windy still{0};
    EXPECT_TRUE(off == shown(frameAt(3, kBefore)));
}

TEST(Sway, IdsCoverWhatIsSeen)
{
    Windy windy{1, 12, false};
    for (const double time : {0.5, 2.0, 4.5}) {
        renderer::FrameInput in = frameAt(time, kBefore);
        in.show = renderer::Show::Albedo;
        const Shown with = shown(in);
        const glm::u8vec4 nothing = with.image.row<glm::u8vec4>(0)[0];
        int wrong = 0, tree = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i) {
            const bool seen = with.image.row<glm::u8vec4>(i / kSize.x)[i % kSize.x] != nothing;
            wrong += seen != (with.ids[std::size_t(i)] != 0);
            tree += with.ids[std::size_t(i)] == io::number(windy.tree);
        }
        EXPECT_GT(tree, 1000);
        EXPECT_EQ(wrong, 0);
        in.show = renderer::Show::Lod; // drawn again where depths are equal
        const Shown levels = shown(in);
        int others = 0;
        glm::u8vec4 colour{0};
        for (int i = 0; i < kSize.x * kSize.y; ++i) {
            if (levels.ids[std::size_t(i)] != io::number(windy.tree)) continue;
            const glm::u8vec4 here = levels.image.row<glm::u8vec4>(i / kSize.x)[i % kSize.x];
            if (colour.a == 0) colour = here;
            others += here != colour;
        }
        EXPECT_EQ(others, 0);
    }
}

// From where the sun stands a tree hides its own shadow; but for what the narrow view still widens.
int shadowBesideTheTree(double time, bool wind)
{
    const double e = glm::radians(40.0);
    const glm::dvec3 sun{std::cos(e), std::sin(e), 0};
    const glm::dvec3 eye = sun * 150.0 + glm::dvec3{0, 4, 0};
    renderer::FrameInput in = frameAt(time, {.eye = eye, .yaw = 90, .pitch = -40, .fov = 9});
    in.settings.wind = wind;
    in.show = renderer::Show::Shadow;
    const Shown s = shown(in);
    int count = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        count += s.ids[std::size_t(i)] == renderer::kTerrainId &&
                 s.image.row<glm::u8vec4>(i / kSize.x)[i % kSize.x].x < 128;
    return count;
}

TEST(Sway, ShadowsFollow)
{
    Windy windy{1, 40};
    io::Environment environment = windy.world.scene.environment();
    environment.shadows = {.cascades = 1, .distance = 300, .resolution = 4096};
    windy.world.scene.exchange(environment);
    test::load(windy.world);
    const int still = shadowBesideTheTree(0, false);
    for (const double time : {0.5, 2.0, 4.5})
        EXPECT_LT(shadowBesideTheTree(time, true), still * 1.3);

    // The tree itself behind the eye, its shadow before it.
    const io::Camera away{.eye = {-4, 5, 0}, .yaw = 90, .pitch = -45};
    const auto at = [&](double time, bool wind) {
        renderer::FrameInput in = frameAt(time, away);
        in.settings.wind = wind;
        return shown(in);
    };
    EXPECT_FALSE(at(0.5, true) == at(2.5, true));
    EXPECT_TRUE(at(0.5, false) == at(2.5, false));
}

std::uint64_t submitted(double time, const io::Camera& camera)
{
    test::shared().render(frameAt(time, camera));
    return test::shared().stats().trianglesSubmitted;
}

TEST(Sway, ShadowMapsWhereNoneIsSeenAreKept)
{
    Windy windy{1, 4};
    const auto redrawn = [&](float distance) {
        io::Environment environment = windy.world.scene.environment();
        environment.shadows = {.cascades = 1, .distance = distance, .resolution = 2048};
        windy.world.scene.exchange(environment);
        test::load(windy.world);
        submitted(1, kBefore);
        const std::uint64_t kept = submitted(1, kBefore);
        return submitted(2, kBefore) > kept;
    };
    EXPECT_TRUE(redrawn(40));
    EXPECT_FALSE(redrawn(9000));
    windy.world.scene.exchange(windy.tree, std::nullopt);
    EXPECT_FALSE(redrawn(40)) << "nothing there sways";
}

// A pole whose top, leaning away, comes up from below the picture, where the sphere of the upright one does not reach.
TEST(Sway, IsNotCulledWhereItLeansIntoTheView)
{
    Windy windy{1, 60};
    const io::TemplateId pole = windy.sways("pole", test::box({0.4f, 16, 0.4f}, {1, 1, 1, 1}), 1);
    test::addObject(windy.world, pole, {.position = {-40, 0, 0}});
    test::load(windy.world);
    for (int i = 0; i < 40; ++i) {
        renderer::FrameInput in = frameAt(i * 0.4, {.eye = {-40, 27 + i * 0.04, 20}, .fov = 56});
        const Shown culled = shown(in);
        in.settings.culling = false;
        EXPECT_TRUE(culled == shown(in)) << i;
    }
}

int differing(const Shown& a, const Shown& b)
{
    int count = 0;
    for (std::size_t i = 0; i < a.ids.size(); ++i)
        count += a.ids[i] != b.ids[i];
    return count;
}

TEST(Sway, IsTheSameOnEveryWayOfDrawing)
{
    Windy windy;
    renderer::FrameInput in = frameAt(2.3, kBefore);
    in.settings.culler = renderer::Culler::Cpu;
    const Shown cpu = shown(in);
    in.settings.culler = renderer::Culler::Gpu;
    shown(in); // which is when the GPU learns what is seen
    EXPECT_LT(differing(cpu, shown(in)), 10) << "but for rounding";
    in.settings.occlusion = false;
    EXPECT_LT(differing(cpu, shown(in)), 10);

    io::Template direct = *windy.world.scene.find(io::TemplateId{1});
    direct.drawPath = io::DrawPath::Direct;
    windy.world.scene.exchange(io::TemplateId{1}, direct);
    test::load(windy.world);
    in.settings.culler = renderer::Culler::Cpu;
    EXPECT_TRUE(cpu == shown(in));
}

// What is shown of it grows from nothing at half a pixel to all at one.
TEST(Sway, FadesAwayWithDistance)
{
    glsl::CullRecord record = renderer::cullRecord({0, 0, 0}, 5, 0, 0);
    record.sway = 10;
    const glsl::CullModel plain{.levels = 1};
    const glsl::CullModel pictured{.errors = {{0, 1.0f / 32, 0, 0}, {}}, .levels = 2, .impostor = 1};
    const auto at = [&](double distance, const glsl::CullModel& model) {
        const glsl::Wind wind = windAt(0, 5);
        const renderer::CullRequest request{
            .eye = {0, 0, distance}, .errorAngle = 0.001f, .impostors = true, .wind = wind, .swayAngle = 0.0005f};
        return glsl::swayShown(record, model, renderer::cullView(request, 1));
    };
    const float way = glsl::windReach(glsl::windMost(windAt(0, 5)), 10);
    EXPECT_EQ(at(way / 0.001 + 4, plain), 1);
    EXPECT_NEAR(at(way / 0.00075 + 5, plain), 0.5, 0.01);
    EXPECT_EQ(at(way / 0.0005 + 6, plain), 0);
    EXPECT_EQ(at(1, plain), 1);
    EXPECT_EQ(at(5 + 0.74 * 5 / 32 / 0.001, pictured), 1);
    EXPECT_EQ(at(5 + 1.01 * 5 / 32 / 0.001, pictured), 0) << "a picture does not sway";
}

} // namespace
