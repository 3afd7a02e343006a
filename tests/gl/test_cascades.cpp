// Where the windows of the shadow maps lie, without a GPU.
#include "io/scene/shadow_ends.h"
#include "renderer/cascades.h"
#include "renderer/cull.h"
#include "renderer/shadow_constants.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

constexpr glm::ivec2 kSize{320, 180};
constexpr double kSunRadius = 0.0046; // rad

io::Shadows manual(int cascades)
{
    return {.cascades = cascades, .distance = 900, .splits = io::Splits::Manual};
}

struct Kind {
    const char* name;
    io::Shadows shadows;
    float fov = 60;
};
std::vector<Kind> kinds()
{
    return {{"defaults", {}},
            {"one", {.cascades = 1}},
            {"six", {.cascades = 6, .distance = 1000}},
            {"by hand", manual(6)},
            {"soft", {.filter = io::ShadowFilter::Pcf7, .softness = 4, .bias = 8}},
            {"contact", {.contact = true, .blend = 0.5f}},
            {"small", {.cascades = 6, .resolution = 256, .filter = io::ShadowFilter::Pcf7, .softness = 4, .bias = 8}},
            {"narrow", {}, 8},
            {"wide", {}, 130}};
}

TEST(Cascades, TexelsStandStillInTheWorld)
{
    const glm::dvec3 sun = glm::normalize(glm::dvec3{0.4, 0.6, 0.3});
    for (const Kind& kind : kinds()) {
        std::mt19937 random{3};
        std::uniform_real_distribution<double> place{-500, 500}, turn{-180, 180}, tilt{-80, 80};
        std::vector<double> radii;
        for (int i = 0; i < 1000; ++i) {
            const io::Camera camera{.eye = {place(random), place(random), place(random)}, .yaw = float(turn(random)), .pitch = float(tilt(random)), .fov = kind.fov};
            const renderer::Eye eye = renderer::eyeOf(camera, kSize);
            const auto cascades = renderer::cascadesOf(eye, kind.shadows, sun, kSunRadius);
            ASSERT_EQ(cascades.size(), std::size_t(kind.shadows.cascades)) << kind.name;
            for (std::size_t c = 0; c < cascades.size(); ++c) {
                const glm::dvec4 origin = cascades[c].textureFromRelative * glm::dvec4{-eye.position, 1};
                const glm::dvec2 texels = glm::dvec2{origin} * double(kind.shadows.resolution);
                ASSERT_NEAR(texels.x, std::round(texels.x), 1e-3) << kind.name;
                ASSERT_NEAR(texels.y, std::round(texels.y), 1e-3) << kind.name;
                if (radii.size() < cascades.size()) radii.push_back(cascades[c].radius);
                ASSERT_EQ(cascades[c].radius, radii[c]) << kind.name;
            }
        }
    }
}

// Texels that lie in a window around a place, on the nearest side.
double roomAround(const renderer::Cascade& cascade, const glm::dvec3& place)
{
    const io::Texel low = cascade.low % std::int64_t(cascade.resolution);
    double least = 1e9;
    for (int axis = 0; axis < 2; ++axis) {
        const double begin = double(low[axis] < 0 ? low[axis] + cascade.resolution : low[axis]);
        const double at = place[axis] * cascade.resolution;
        least = std::min({least, at - begin, begin + cascade.resolution - at});
    }
    return least;
}

TEST(Cascades, CoverTheirSlicesAndWhatTheFilterSees)
{
    std::mt19937 random{8};
    std::uniform_real_distribution<double> place{-500, 500}, turn{-180, 180}, side{-1, 1}, unit{0, 1}, height{0.02, 1};
    for (const Kind& kind : kinds())
        for (int i = 0; i < 60; ++i) {
            const io::Camera camera{.eye = {place(random), 20, place(random)}, .yaw = float(turn(random)), .pitch = float(side(random) * 60), .fov = kind.fov};
            const renderer::Eye eye = renderer::eyeOf(camera, {1280, 720});
            const glm::dvec3 sun = glm::normalize(glm::dvec3{side(random), height(random), side(random)});
            const auto cascades = renderer::cascadesOf(eye, kind.shadows, sun, kSunRadius);
            const glsl::Shadows constants = renderer::shadowConstants(kind.shadows, cascades, sun);
            double begin = 0;
            for (std::size_t k = 0; k < cascades.size(); ++k) {
                const renderer::Cascade& cascade = cascades[k];
                const double reach = std::max(renderer::filterReach(kind.shadows), kind.shadows.contact ? MOST_PENUMBRA : 0.0f);
                const double lifted = reach / 2 * double(kind.shadows.bias);
                for (int corner = 0; corner < 60; ++corner) { // eight corners, then anywhere inside
                    const bool inside = corner >= 8;
                    const double x = inside ? side(random) : corner & 1 ? 1 : -1, y = inside ? side(random) : corner & 2 ? 1 : -1;
                    const double distance = glm::mix(begin, cascade.end, inside ? unit(random) : corner & 4 ? 1.0 : 0.0);
                    const glm::dvec3 direction = eye.forward + eye.right * (eye.tanHalfFov * eye.aspect * x) + eye.up * (eye.tanHalfFov * y);
                    const glm::dvec3 at{cascade.textureFromRelative * glm::dvec4{glm::normalize(direction) * distance, 1}};
                    ASSERT_GE(roomAround(cascade, at), reach + lifted + 1) << kind.name << " cascade " << k;
                    ASSERT_GE(at.z, 0) << kind.name;
                    ASSERT_LE(at.z, 1) << kind.name;
                }
                begin = std::min(cascade.end, double(constants.cascade[k].blendFrom)); // where the next one begins to show
            }
        }
}

TEST(Cascades, EverySettingCounts)
{
    io::Shadows shadows{.cascades = 3, .distance = 90, .lambda = 0};
    EXPECT_EQ(renderer::cascadeEnds(shadows).size(), 3u);
    EXPECT_NEAR(renderer::cascadeEnds(shadows)[0], 30.3, 0.1);
    EXPECT_DOUBLE_EQ(renderer::cascadeEnds(shadows)[2], 90);
    shadows.lambda = 1;
    EXPECT_LT(renderer::cascadeEnds(shadows)[0], 5);
    shadows.splits = io::Splits::Manual;
    shadows.end1 = 20;
    shadows.end2 = 70;
    EXPECT_EQ(renderer::cascadeEnds(shadows), (std::vector<double>{20, 70, 90}));
    EXPECT_EQ(renderer::cascadeEnds(manual(6)), (std::vector<double>{15, 45, 110, 250, 600, 900}));
    EXPECT_FLOAT_EQ(renderer::filterReach({}), 2);
    EXPECT_FLOAT_EQ(renderer::filterReach({.filter = io::ShadowFilter::Pcf7, .softness = 1.5f}), 6);
}

TEST(Cascades, EndsRiseWhateverIsAskedFor)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const io::Shadows& shadows : {io::Shadows{.cascades = 6, .splits = io::Splits::Manual, .end1 = 300, .end2 = 20, .end3 = 600},
                                       io::Shadows{.cascades = 99, .distance = 0, .splits = io::Splits::Manual},
                                       io::Shadows{.cascades = -3, .distance = -5, .lambda = 7},
                                       io::Shadows{.cascades = 6, .distance = nan, .splits = io::Splits::Manual, .end1 = nan, .end3 = nan}}) {
        const std::vector<double> ends = renderer::cascadeEnds(shadows);
        ASSERT_FALSE(ends.empty());
        ASSERT_LE(ends.size(), std::size_t(MAX_CASCADES));
        for (std::size_t i = 0; i < ends.size(); ++i)
            EXPECT_GT(ends[i], i == 0 ? 0 : ends[i - 1]);
        for (const renderer::Cascade& c : renderer::cascadesOf(renderer::eyeOf({}, kSize), shadows, {0, 1, 0}, 0)) {
            EXPECT_TRUE(std::isfinite(c.radius) && c.radius > 0);
            EXPECT_TRUE(std::isfinite(c.textureFromRelative[3].z));
        }
    }
}

// Corners of boxes whose shadow falls into a window, against what culling lets through: it must let all of them.
TEST(Cascades, LetThroughAllThatCanCastIntoThem)
{
    std::mt19937 random{21};
    std::uniform_real_distribution<double> place{-1500, 1500}, up{-50, 400}, size{0.5, 60}, side{-1, 1}, elevation{0.03, 1};
    struct Caster {
        glm::dvec3 centre;
        glm::dvec3 half;
    };
    std::vector<Caster> casters;
    std::vector<glsl::CullRecord> records;
    for (int i = 0; i < 4000; ++i) {
        const bool tall = i % 50 == 0;
        const Caster caster{{place(random), up(random), place(random)}, {size(random), tall ? 2000 : size(random), size(random)}};
        casters.push_back(caster);
        records.push_back(renderer::cullRecord(caster.centre, glm::length(caster.half), 0, CULL_CASTS_SHADOW));
    }
    const glsl::CullModel model{.levels = 1};
    std::size_t inside = 0;
    for (int i = 0; i < 12; ++i) {
        const renderer::Eye eye = renderer::eyeOf({.eye = {place(random) / 4, 10, place(random) / 4}, .yaw = float(180 * side(random))}, kSize);
        const glm::dvec3 sun = glm::normalize(glm::dvec3{side(random), elevation(random), side(random)});
        const glm::dmat3 axes = renderer::lightAxes(sun);
        for (const renderer::Cascade& cascade : renderer::cascadesOf(eye, {.cascades = 6}, sun, kSunRadius)) {
            std::vector<bool> passed(casters.size());
            for (const renderer::CascadePiece& piece : renderer::piecesOf(cascade, cascade.window(), eye.position, sun)) {
                std::vector<renderer::Seen> seen;
                renderer::cull({.records = records, .models = {&model, 1}}, {.volume = piece.casters, .towardSun = sun, .required = CULL_CASTS_SHADOW}, seen);
                for (const renderer::Seen& one : seen)
                    passed[one.slot()] = true;
            }
            const glm::dvec2 low = glm::dvec2{cascade.low} * cascade.texel, high = glm::dvec2{cascade.window().high} * cascade.texel;
            for (std::size_t k = 0; k < casters.size(); ++k)
                for (int corner = 0; corner < 64; ++corner) { // points of the box, corners and between
                    const glm::dvec3 share{(corner & 3) / 1.5 - 1, (corner >> 2 & 3) / 1.5 - 1, (corner >> 4 & 3) / 1.5 - 1};
                    const glm::dvec3 at = axes * (casters[k].centre + casters[k].half * share);
                    if (at.x < low.x || at.y < low.y || at.x > high.x || at.y > high.y || at.z < cascade.bottom) continue;
                    ++inside;
                    ASSERT_TRUE(passed[k]) << "caster " << k << " of camera " << i;
                    break;
                }
        }
    }
    EXPECT_GT(inside, 5000u);
}

TEST(Cascades, ShadowsOfWhatMovesAreFoundWhereTheyFall)
{
    const renderer::Eye eye = renderer::eyeOf({.eye = {0, 5, 0}}, kSize);
    const glm::dvec3 sun = glm::normalize(glm::dvec3{0.3, 0.5, 0.2});
    for (const renderer::Cascade& cascade : renderer::cascadesOf(eye, {}, sun, kSunRadius)) {
        const glm::dvec3 above = eye.position + eye.forward * 2.0 + sun * 3000.0; // however far towards the light
        const io::TexelRect rect = renderer::shadowOf(cascade, {above, 1}, sun);
        EXPECT_FALSE(io::common(rect, cascade.window()).empty());
        EXPECT_TRUE(renderer::shadowOf(cascade, {eye.position - sun * 5000.0, 1}, sun).empty());
    }
}

} // namespace
