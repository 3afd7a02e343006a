#include "renderer/clouds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace renderer {
namespace {

constexpr double kPeriod = 100;             // repeats after which every octave of the field meets its own beginning
constexpr double kBegin = 0.196;            // of the width: where cloudThickness() takes a tenth of the light, and a cloud begins
constexpr double kFlattest = 0.12;          // sine of the sun's height, for shadows
constexpr float kWettingRain = 5;           // mm an hour, from which all is wet
constexpr float kCoveringSnow = 5;          // and covered
constexpr glm::dvec3 kLives{1500, 5400, 420}; // s after which an octave has changed through all of its noise

double wrapped(double value, double period)
{
    return value - std::floor(value / period) * period;
}

// Share of the sum of three even distributions of these widths that lies under x: the volume of a corner cut off a box.
double shareUnder(double x, const std::array<double, 3>& widths)
{
    double sum = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        double left = x;
        int sign = 1;
        for (unsigned axis = 0; axis < 3; ++axis)
            if (corner >> axis & 1) left -= widths[axis], sign = -sign;
        if (left > 0) sum += sign * left * left * left;
    }
    return sum / (6 * widths[0] * widths[1] * widths[2]);
}

// Another part of the same noise for each seed: fractions of golden numbers never come close to each other again.
glm::dvec3 placeOfSeed(int seed)
{
    const glm::dvec3 steps{0.8191725133961645, 0.6710436067037893, 0.5497004779019703}; // Roberts 2018
    return glm::fract(double(seed) * steps);
}

} // namespace

float cloudFieldAt(float coverage)
{
    const std::array<double, 3> shares{CLOUD_BILLOWS_SHARE, CLOUD_BROAD_SHARE, CLOUD_FINE_SHARE};
    const double wanted = 1 - std::clamp(double(coverage), 0.0, 1.0);
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (shareUnder(middle, shares) < wanted ? low : high) = middle;
    }
    return float((low + high) / 2);
}

glsl::Clouds cloudsOf(const io::Environment& environment, const glsl::Light& light, const Eye& eye, double time)
{
    const io::Clouds& c = environment.clouds;
    const double size = std::max(double(c.size), 100.0);
    const double towards = glm::radians(double(c.direction));
    const glm::dvec2 wind{std::sin(towards), -std::cos(towards)}; // clockwise from north, -Z
    const glm::dvec3 seed = placeOfSeed(c.seed);
    const glm::dvec2 origin = (glm::dvec2{eye.position.x, eye.position.z} - wind * (double(c.speed) * time)) / size +
                              glm::dvec2{seed} * kPeriod;
    const glm::dvec3 phase = glm::dvec3{seed.z, seed.x, seed.y} + double(c.change) * time / kLives;

    glsl::Clouds clouds{};
    clouds.origin = glm::vec2{wrapped(origin.x, kPeriod), wrapped(origin.y, kPeriod)};
    clouds.perMetre = float(1 / size);
    clouds.phase = glm::vec3{glm::fract(phase)};
    clouds.sun = light.sunAtClouds;
    clouds.thickness = std::max(c.thickness, 1.0f);
    clouds.density = std::max(c.density, 0.0f);
    clouds.shadow = c.shadow;
    clouds.on = light.cloudsOn;
    clouds.base = float(c.altitude - eye.position.y);
    clouds.planet = float(double(environment.sky.planetRadius) * 1000 + eye.position.y);
    clouds.albedo = environment.sky.groundAlbedo;
    clouds.cover = c.coverage * (1 - std::exp(-0.1f * clouds.density * clouds.thickness)); // as the layer hides what is behind it
    clouds.wet = glm::clamp(environment.weather.rain / kWettingRain, 0.0f, 1.0f);
    constexpr double kNowhere = -1e9;
    clouds.water = float(environment.water.on ? double(environment.water.level) - eye.position.y : kNowhere);
    clouds.snow = glm::clamp(environment.weather.snow / kCoveringSnow, 0.0f, 1.0f);
    clouds.through = glsl::throughCloud(0.8f * clouds.density * clouds.thickness);

    clouds.width = 0.06f + 0.5f * c.softness;
    const double closed = glm::smoothstep(0.85, 1.0, double(c.coverage)); // such a cover has no thin places
    clouds.edge = cloudFieldAt(c.coverage) - clouds.width * float(kBegin + closed);

    // The map moves by whole texels of the field, so that shadows do not swim.
    constexpr double kTexel = double(CLOUD_MAP_METRES) / CLOUD_MAP_SIZE;
    clouds.mapLod = float(std::max(std::log2(kTexel / size * CLOUD_SHAPE_SIZE), 0.0));
    clouds.sunward = glm::vec2{light.towardSun.x, light.towardSun.z} / std::max(light.towardSun.y, float(kFlattest));
    const glm::dvec2 eyeInField = glm::dvec2{clouds.origin} * size;
    const glm::dvec2 seen = eyeInField + glm::dvec2{clouds.sunward} * double(clouds.base);
    const glm::dvec2 middle = glm::floor(seen / kTexel) * kTexel;
    clouds.map = glm::vec4{middle - eyeInField, (seen - middle) / double(CLOUD_MAP_METRES) + 0.5};
    return clouds;
}

} // namespace renderer
