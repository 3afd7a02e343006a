#include "renderer/water.h"

#include "io/scene/tree_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer {
namespace {

constexpr double kGravity = 9.81;   // m/s^2
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kTimePeriod = 4096; // s, of what only noise is moved by
constexpr double kNodeReach = 3;    // a node is split where it is nearer than so many of its sides
constexpr float kMostCrowded = 0.8f; // share by which neighbours come together where all crests meet
constexpr double kSmallestLift = 0.5; // pixels under which a wave lifts nothing

// Each is so much of the one before: no two ever repeat together.
constexpr double kLengths = 0.617;
// Their directions from the wind's, degrees, and how their heights share what is there.
constexpr double kAside[WATER_WAVES] = {0, -24, 31, -48, 14, 57, -11};
constexpr double kShares[WATER_WAVES] = {0.30, 0.22, 0.16, 0.12, 0.09, 0.07, 0.04};

glm::dvec2 turned(const glm::dvec2& v, double degrees)
{
    const double a = glm::radians(degrees), c = std::cos(a), s = std::sin(a);
    return {v.x * c - v.y * s, v.x * s + v.y * c};
}

double wrapped(double value, double period)
{
    return value - std::floor(value / period) * period;
}

// Slopes that a wind makes, root mean square over all waves (Cox and Munk, "Measurement of the Roughness of the Sea Surface",
// 1954), without those that are waves of their own here.
float rippleSlope(const io::Environment& e, double slopeOfWaves)
{
    const double ofWind = 0.003 + 0.00512 * std::max(double(e.wind.speed), 0.0);
    const double rest = std::max(ofWind - slopeOfWaves, 0.3 * ofWind);
    const double ofRain = 0.01 * std::min(double(e.weather.rain) / 20, 1.0);
    return float(std::sqrt(rest * std::min(double(e.water.waves) / 0.15, 1.0) + ofRain));
}

// Where the eye is in a layer of ripples that the wind carries, in turns of its texture.
glm::vec2 layerAt(const glm::dvec2& eye, const glm::dvec2& along, double metres, double time)
{
    const double length = metres / 9;  // of the ripples that stand out
    const double speed = std::sqrt(kGravity * length / kTurn);
    const glm::dvec2 across{-along.y, along.x};
    return {wrapped((glm::dot(eye, along) - speed * time) / metres, 1), wrapped(glm::dot(eye, across) / metres, 1)};
}

struct Splitter {
    const Eye& eye;
    const std::optional<Volume>& volume;
    double height, lift; // m: of the level, and above and below it that waves reach
    double finest;       // m, side of the smallest node
    std::vector<WaterPatch> patches;

    bool sees(const glm::dvec2& low, double side) const
    {
        if (!volume) return true;
        const io::Box box{glm::vec3{glm::dvec3{low.x - lift, height - lift, low.y - lift}},
                          glm::vec3{glm::dvec3{low.x + side + lift, height + lift, low.y + side + lift}}};
        return std::ranges::none_of(volume->planes, [&](const glm::dvec4& p) { return io::sideOf(box, p) == io::Side::Outside; });
    }
    double distanceTo(const glm::dvec2& low, double side) const
    {
        const glm::dvec2 at{eye.position.x, eye.position.z};
        const glm::dvec2 away = glm::max(glm::max(low - at, at - (low + side)), glm::dvec2{0});
        return std::hypot(glm::length(away), eye.position.y - height);
    }
    void split(const glm::dvec2& low, double side)
    {
        if (!sees(low, side)) return;
        if (side > finest * 1.5 && distanceTo(low, side) < kNodeReach * side) {
            const double half = side / 2;
            for (const glm::dvec2 child : {glm::dvec2{0, 0}, glm::dvec2{half, 0}, glm::dvec2{0, half}, glm::dvec2{half, half}})
                split(low + child, half);
            return;
        }
        patches.push_back({.origin = glm::vec2{low - glm::dvec2{eye.position.x, eye.position.z}},
                           .cell = float(side / WATER_CELLS),
                           .turnedAt = float(2 * kNodeReach * side)});
    }
};

} // namespace

glsl::Water waterOf(const io::Environment& e, const Eye& eye, double time)
{
    const io::Water& water = e.water;
    const double direction = glm::radians(double(e.wind.direction));
    const glm::dvec2 wind{std::sin(direction), -std::cos(direction)}; // clockwise from north, -Z
    const glm::dvec2 at{eye.position.x, eye.position.z};
    glsl::Water result{};
    double length = std::max(double(water.wavelength), 0.1), steepest = 0, slopes = 0;
    for (int i = 0; i < WATER_WAVES; ++i, length *= kLengths) {
        const glm::dvec2 towards = turned(wind, kAside[i]);
        const double number = kTurn / length, height = 0.5 * std::max(water.waves, 0.0f) * kShares[i];
        const double phase = number * glm::dot(at, towards) - std::sqrt(kGravity * number) * time + i * 2.4;
        const double slope = number * height;
        result.wave[i] = {.towards = glm::vec2{towards},
                          .number = float(number),
                          .amplitude = float(height),
                          .phase = float(wrapped(phase, kTurn)),
                          .push = float(height),
                          .length = float(length),
                          .slope = float(slope)};
        steepest += slope;
        slopes += 0.5 * slope * slope;
    }
    for (glsl::WaterWave& wave : result.wave) // circles, but flatter where crests would fold over
        wave.push *= std::min(1.0f, kMostCrowded / float(std::max(steepest, 1e-6)));
    result.colour = water.colour;
    result.height = float(water.level - eye.position.y);
    result.extinction = 1 / std::max(water.clarity, 0.01f);
    result.foam = water.foam;
    result.ripple = rippleSlope(e, slopes);
    result.waves = std::max(water.waves, 0.0f);
    const glm::dvec2 aside = wind * double(WATER_RIPPLES_COSINE) + glm::dvec2{-wind.y, wind.x} * double(WATER_RIPPLES_SINE);
    result.ripples = glm::vec4{layerAt(at, wind, double(WATER_RIPPLES_NEAR), time), layerAt(at, aside, double(WATER_RIPPLES_WIDE), time)};
    result.wind = glm::vec2{wind};
    result.finest = float(std::clamp(double(water.wavelength) / 64, 0.05, 4.0));
    result.time = float(wrapped(time, kTimePeriod));
    return result;
}

std::vector<WaterPatch> waterPatches(glsl::Water& water, const Eye& eye, const std::optional<Volume>& volume)
{
    // As far as the longest wave is told apart by cells, and a pixel tells how high it is.
    const double longest = double(water.wave[0].length) * WATER_CELL_RATIO / 2;
    const double reach = std::min(longest, double(water.waves) / (kSmallestLift * pixelAngle(eye)));
    water.inner = glm::vec4{0};
    if (water.waves <= 0 || std::abs(water.height) > reach) return {};
    const double finest = double(water.finest) * WATER_CELLS;
    double side = finest;
    while (side < reach) side *= 2;
    const glm::dvec2 at{eye.position.x, eye.position.z};
    const glm::dvec2 middle = glm::round(at / side) * side; // of sixteen nodes, in which the eye's reach lies
    Splitter splitter{eye, volume, double(water.height) + eye.position.y, double(water.waves), finest, {}};
    for (int z = -2; z < 2; ++z)
        for (int x = -2; x < 2; ++x)
            splitter.split(middle + glm::dvec2{x, z} * side, side);
    water.inner = glm::vec4{middle - 2 * side - at, middle + 2 * side - at};
    return std::move(splitter.patches);
}

} // namespace renderer
