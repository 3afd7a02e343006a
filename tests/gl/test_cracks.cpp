// The drawn ground is tight, moves without a jump, and lies where the map says: by grids and by tessellation.
#include "io/base/noise.h"
#include "io/base/random.h"
#include "tests/gl/support/ground_canvas.h"
#include "tests/gl/support/shared_renderer.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using renderer::GroundStages;

constexpr glm::ivec2 kSize{320, 180};
constexpr renderer::TerrainLimits kWindows{.whole = 256, .window = 320};

struct Way {
    const char* name;
    GroundStages stages;
    bool windowed; // the map is held as windows around the eye
};
constexpr std::array<Way, 4> kWays{{{"Grid", GroundStages::Grid, false},
                                    {"Tessellation", GroundStages::Tessellation, false},
                                    {"GridInWindows", GroundStages::Grid, true},
                                    {"TessellationInWindows", GroundStages::Tessellation, true}}};

double mountains(double x, double z) // as weather leaves them: slopes of up to 60 degrees, smoother the closer one looks
{
    return double(io::simplexFbm(glm::vec2{float(x), float(z)} / 700.0f, 3, {.count = 7, .gain = 0.4f})) * 150;
}

double needles(double x, double z) // 0 .. 1000 m, one texel wide, on broken ground
{
    const auto cell = std::uint32_t(int(x) * 7919 + int(z) * 104729) * 2654435761u;
    return cell % 97 == 0 ? double(cell % 1000) : double(cell >> 28);
}

double rough(double x, double z)
{
    return double(io::simplexFbm(glm::vec2{float(x), float(z)} / 90.0f, 5, {.count = 6, .gain = 0.6f})) * 120;
}

class DrawnGround : public testing::TestWithParam<Way> {
protected:
    static void SetUpTestSuite()
    {
        if (!test::haveContext()) return;
        whole = std::make_unique<test::GroundCanvas>(kSize);
        windowed = std::make_unique<test::GroundCanvas>(kSize, kWindows);
    }
    static void TearDownTestSuite()
    {
        whole = nullptr;
        windowed = nullptr;
    }
    void SetUp() override { ASSERT_TRUE(whole); }

    test::GroundCanvas& canvas() const { return GetParam().windowed ? *windowed : *whole; }
    GroundStages stages() const { return GetParam().stages; }

private:
    static std::unique_ptr<test::GroundCanvas> whole, windowed;
};
std::unique_ptr<test::GroundCanvas> DrawnGround::whole, DrawnGround::windowed;

// In the map's inner half, so that its edges are not seen, and where nothing near stands higher than the eye.
renderer::Eye eyeAbove(const io::HeightMap& map, io::Random& random, double above)
{
    for (;;) {
        const glm::dvec2 reach = glm::dvec2{map.size - 1} * map.metresPerTexel * 0.25;
        const glm::dvec2 at{reach.x * double(random.signedUnit()), reach.y * double(random.signedUnit())};
        const double y = map.height(at.x, at.y).value_or(0) + above;
        const glm::ivec2 texel{(at - map.origin) / map.metresPerTexel};
        double highest = -1e9;
        for (int z = -1; z <= 2; ++z)
            for (int x = -1; x <= 2; ++x)
                highest = std::max(highest, double(map.at(texel.x + x, texel.y + z)));
        if (highest > y - 0.5 || y > 100) continue;
        return renderer::eyeOf({.eye = {at.x, y, at.y}, .yaw = random.unit() * 360, .pitch = -90 + random.unit() * 25, .fov = 50}, kSize);
    }
}

TEST_P(DrawnGround, IsTightInFiveHundredLooks)
{
    io::Random random{11};
    for (const auto& map : {test::heightMap({1025, 900}, 2, rough), test::heightMap({601, 777}, 1, needles)}) {
        canvas().load(map);
        int looks = 0, holes = 0;
        for (; looks < 250; ++looks) {
            canvas().errorPixels = std::exp2(looks % 7); // up to 64: what is in view is of many levels
            const double above = std::exp2(random.unit() * 6) * 1.3; // 1.3 to 83 m
            const renderer::Eye eye = eyeAbove(*map, random, above);
            holes += canvas().holes(eye, eye, stages());
            if (holes > 0) break;
        }
        canvas().errorPixels = 1;
        EXPECT_EQ(holes, 0) << "look " << looks;
    }
}

TEST_P(DrawnGround, IsTightInEachCascade)
{
    io::Random random{12};
    for (const auto& map : {test::heightMap({1025, 900}, 2, rough), test::heightMap({601, 777}, 1, needles)}) {
        canvas().load(map);
        const double side = double(std::min(map->size.x, map->size.y)) * map->metresPerTexel;
        for (const double texel : {0.02, 0.1, 0.5, 2.0, 40.0, 300.0})
            for (int look = 0; look < 4; ++look) {
                const glm::dvec3 sun = glm::normalize(glm::dvec3{random.unit() - 0.5, 1.4, random.unit() - 0.5});
                const double width = std::min(texel * kSize.x * 4, side * 0.25);
                EXPECT_EQ(canvas().holesForSun(sun, {0, 0, 0}, width, texel), 0) << texel;
            }
    }
}

// How far the drawn ground lies from the map at a pixel, in pixels: what of the way up is across the view.
double pixelsOff(const io::HeightMap& map, const renderer::Eye& eye, const glm::vec4& place)
{
    const glm::dvec2 at = map.origin + glm::dvec2{place.x, place.y} * map.metresPerTexel;
    const glm::dvec3 away = glm::dvec3{at.x, place.z, at.y} - eye.position;
    const double distance = glm::length(away), across = std::hypot(away.x, away.z) / distance;
    return (double(place.z) - map.height(at.x, at.y).value_or(place.z)) * across / (distance * renderer::pixelAngle(eye));
}

renderer::Eye walker(const io::HeightMap& map, const glm::dvec2& at, double above, float yaw)
{
    return renderer::eyeOf({.eye = {at.x, map.height(at.x, at.y).value_or(0) + above, at.y}, .yaw = yaw, .pitch = above > 60 ? -30.f : -6.f}, kSize);
}

TEST_P(DrawnGround, LiesWithinAPixelOfTheMap)
{
    const auto map = test::heightMap({2049, 1900}, 1, mountains);
    canvas().load(map);
    io::Random random{13};
    std::vector<double> off;
    for (int look = 0; look < 24; ++look) {
        const glm::dvec2 at{(random.unit() - 0.5) * 1200, (random.unit() - 0.5) * 1200};
        const renderer::Eye eye = walker(*map, at, look % 2 ? 1.7 : 150, random.unit() * 360);
        std::vector<glm::vec4> places;
        canvas().holes(eye, eye, stages(), &places);
        for (const glm::vec4& place : places)
            if (place != test::GroundCanvas::kNothing) off.push_back(std::abs(pixelsOff(*map, eye, place)));
    }
    ASSERT_GT(off.size(), 100'000u);
    std::ranges::sort(off);
    EXPECT_LE(off[std::size_t(double(off.size()) * 0.999)], 1);
    EXPECT_LE(off.back(), 2);
}

// Whether ground ends at a pixel that stands before other ground, or the sky.
bool atAnEdge(const std::vector<glm::vec4>& places, std::size_t pixel)
{
    const auto width = std::size_t(kSize.x);
    if (pixel < width || pixel + width >= places.size()) return true;
    const float across = glm::distance(places[pixel - 1], places[pixel + 1]), down = glm::distance(places[pixel - width], places[pixel + width]);
    const float step = std::min(glm::distance(places[pixel], places[pixel - width]), glm::distance(places[pixel], places[pixel + width]));
    return across > 4 * glm::distance(places[pixel], places[pixel - 1]) || down > 4 * step;
}

TEST_P(DrawnGround, MovesWithoutAJump)
{
    const auto map = test::heightMap({2049, 1900}, 1, mountains);
    canvas().load(map);
    double farthest = 0, moved = 0;
    for (int step = 0; step < 60; ++step) {
        const renderer::Eye eye = walker(*map, {step * 3.1 - 90, 40 + step * 1.7}, 30, 40);
        renderer::Eye further = eye;
        further.position += glm::dvec3{0.07, 0.01, -0.07};
        std::vector<glm::vec4> before, after;
        canvas().holes(eye, eye, stages(), &before);
        canvas().holes(eye, further, stages(), &after);
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i] == test::GroundCanvas::kNothing || after[i] == test::GroundCanvas::kNothing) continue;
            if (atAnEdge(before, i) || atAnEdge(after, i)) continue; // which moved by less than a pixel shows what is behind it
            const double pixels = std::abs(pixelsOff(*map, eye, before[i]) - pixelsOff(*map, eye, after[i]));
            farthest = std::max(farthest, pixels);
            moved += pixels > 0;
        }
    }
    EXPECT_GT(moved, 1000);
    // A tessellated patch that comes to rest takes the map's diagonals at once: none of its vertices moves, but what lies between.
    EXPECT_LE(farthest, stages() == GroundStages::Grid ? 0.25 : 0.35);
}

// Ground that other ground hides is left out: less is drawn, and the same is seen, to the bit.
TEST_P(DrawnGround, MissesNothingThatIsSeen)
{
    io::Random random{17};
    std::uint64_t drawn = 0;
    for (const auto& map : {test::heightMap({2049, 1900}, 1, mountains), test::heightMap({1025, 900}, 2, rough), test::heightMap({601, 777}, 1, needles)}) {
        canvas().load(map);
        for (int look = 0; look < 40; ++look) {
            const glm::dvec2 at = glm::dvec2{random.unit() - 0.5, random.unit() - 0.5} * (glm::dvec2{map->size - 2} * map->metresPerTexel);
            renderer::Eye eye = walker(*map, at, 0, random.unit() * 360);
            const glm::ivec2 texel{(at - map->origin) / map->metresPerTexel};
            for (int corner = 0; corner < 4; ++corner) // whatever is within reach of the near plane is not seen
                eye.position.y = std::max(eye.position.y, double(map->at(texel.x + (corner & 1), texel.y + (corner >> 1))));
            eye.position.y += 0.6 + 300 * std::pow(double(random.unit()), 6);
            if (look % 10 == 9) eye.position.y -= 400; // from beneath one looks through its back
            canvas().errorPixels = std::exp2(look % 4);
            std::vector<glm::vec4> everything, seen;
            canvas().culled = false;
            canvas().holes(eye, eye, stages(), &everything);
            canvas().culled = true;
            canvas().holes(eye, eye, stages(), &seen);
            drawn += canvas().triangles;
            EXPECT_TRUE(everything == seen) << "look " << look;
        }
        canvas().errorPixels = 1;
    }
    EXPECT_GT(drawn, 0u);
}

// Windows follow an eye that goes far and a brush, and show what a texture of the whole map does.
TEST_P(DrawnGround, FollowsTheEyeAndABrush)
{
    const auto before = test::heightMap({2049, 1900}, 1, mountains);
    io::HeightGrid hill{.size = {300, 200}};
    for (int z = 0; z < 200; ++z)
        for (int x = 0; x < 300; ++x)
            hill.metres.push_back(before->at(700 + x, 800 + z) + 40 * std::sin(x * 0.0105f) * std::sin(z * 0.0157f));
    const auto after = std::make_shared<const io::HeightMap>(before->with(hill, {700, 800}));
    io::Scene scene;
    scene.exchange(before);
    canvas().terrain().update(scene, {}, {.everything = true});
    const renderer::Eye there = walker(*before, {600, -700}, 40, 10), here = walker(*after, {-150, 40}, 25, 70);
    canvas().holes(here, here, stages());
    canvas().holes(there, there, stages());
    scene.exchange(after);
    canvas().terrain().update(scene, {}, {.heights = {{{700, 800}, {1000, 1000}}}});
    std::vector<glm::vec4> places;
    canvas().holes(here, here, stages(), &places);
    int shown = 0, off = 0;
    for (const glm::vec4& place : places) {
        if (place == test::GroundCanvas::kNothing) continue;
        ++shown;
        off += std::abs(pixelsOff(*after, here, place)) > 1.5;
    }
    EXPECT_GT(shown, 20'000);
    EXPECT_LT(off, shown / 2000);
}

TEST_P(DrawnGround, AllThatShowsItCompiles)
{
    canvas().load(test::heightMap({601, 300}, 1, rough));
    for (const char* fragment : {"terrain.frag.glsl", "terrain_show.frag.glsl", "terrain_shadow.frag.glsl", "flat.frag.glsl"})
        for (int view = 0; view < 5; ++view)
            EXPECT_TRUE(canvas().compiles(stages(), fragment, {"LAYERS 3", "PAINTED", "HOLES", "FLOW", "LEVELS", "VIEW " + std::to_string(view)})) << fragment << " " << view;
}

// Holes go with the cover that has them, also when the next map is held another way.
TEST_P(DrawnGround, HolesGoWithTheirMap)
{
    if (!GetParam().windowed) return;
    const auto small = test::heightMap({201, 201}, 1, rough), large = test::heightMap({601, 300}, 1, rough);
    const std::vector<std::uint32_t> hole(100, io::packed({.hole = true}));
    io::Scene scene;
    scene.exchange(small);
    scene.exchange(std::make_shared<const io::CoverMap>(io::CoverMap{small->size}.with(hole, {10, 10}, {50, 50})));
    canvas().terrain().update(scene, {}, {.everything = true});
    EXPECT_TRUE(canvas().terrain().holed());
    scene.exchange(large);
    scene.exchange(std::shared_ptr<const io::CoverMap>{});
    canvas().terrain().update(scene, {}, {.everything = true});
    EXPECT_FALSE(canvas().terrain().holed());
    EXPECT_EQ(std::ranges::count(canvas().terrain().coverDefines(), "HOLES"), 0);
}

INSTANTIATE_TEST_SUITE_P(Stages, DrawnGround, testing::ValuesIn(kWays), [](const auto& way) { return way.param.name; });

} // namespace
