#include "renderer/heavens.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer {
namespace {

// Of a full moon, bluer than it is, as eyes find it; of the sky at the horizon and overhead; from all around on surfaces.
constexpr glm::vec3 kMoonlight{0.0032f, 0.0040f, 0.0054f};
constexpr glm::vec3 kGlow{0.00005f, 0.00008f, 0.00016f};
constexpr glm::vec3 kGlowOverhead{0.000009f, 0.000015f, 0.000031f};
constexpr glm::vec3 kOnSurfaces{0.00008f, 0.00011f, 0.00018f};
constexpr float kMoonReflects = 0.12f; // geometric albedo
constexpr float kMilkyWay = 0.00011f;  // radiance
constexpr float kStar = 0.025f;        // radiance; the brightest have a third of it

double down(double degrees)
{
    return -std::sin(glm::radians(degrees));
}

// How much the moon brightens the sky around.
float moonInSky(const Bodies& b)
{
    return b.moonlight.y / kMoonlight.y * float(std::max(b.moon.toward.y, 0.0));
}

} // namespace

double moonPhaseLight(double phase)
{
    const double angle = 180 * std::abs(1 - 2 * phase); // between sun and earth as seen from there; 0: full
    return std::pow(10.0, -0.4 * (0.026 * angle + 4e-9 * std::pow(angle, 4)));
}

Bodies bodiesOf(const io::Environment& environment)
{
    Bodies b;
    b.towardSun = io::towardSun(environment);
    b.moon = io::moonOf(environment);
    b.night = glm::smoothstep(down(0), down(8), b.towardSun.y);
    b.glow = glm::smoothstep(down(6.4), down(11), b.towardSun.y);
    b.deepNight = glm::smoothstep(down(18.1), down(22), b.towardSun.y);
    const double dark = glm::smoothstep(down(3), down(9), b.towardSun.y);
    const double seen = dark * moonPhaseLight(b.moon.phase) * glm::smoothstep(-0.01, 0.03, b.moon.toward.y);
    b.moonlight = kMoonlight * float(seen * environment.moon.brightness) * environment.sun.irradiance;
    b.moonLights = b.towardSun.y < down(3) && std::max({b.moonlight.x, b.moonlight.y, b.moonlight.z}) > 1e-5f;
    return b;
}

// On rings of one height, each cut into as many whole steps as it is long: no history, so a still picture has none.
glm::dvec3 inSteps(const glm::dvec3& direction)
{
    constexpr double kStep = glm::radians(0.05), kTurn = 2 * std::numbers::pi;
    const double height = std::round(std::asin(std::clamp(direction.y, -1.0, 1.0)) / kStep) * kStep;
    const double step = kTurn / std::max(std::round(kTurn * std::cos(height) / kStep), 1.0);
    const double around = std::round(std::atan2(direction.x, direction.z) / step) * step;
    return {std::sin(around) * std::cos(height), std::sin(height), std::cos(around) * std::cos(height)};
}

glm::vec3 nightOnSurfaces(const Bodies& b)
{
    return kOnSurfaces * (float(b.night) + 0.6f * moonInSky(b));
}

glsl::Heavens heavensOf(const io::Environment& environment, const Bodies& b)
{
    glsl::Heavens h{};
    h.towardSun = glm::vec3{b.towardSun};
    h.aerial = std::max(environment.sky.aerial, 0.0f);
    h.towardMoon = glm::vec3{b.moon.toward};
    h.moonRadius = glm::radians(std::max(environment.moon.angularDiameter, 0.01f)) / 2;
    h.moonLitFrom = glm::vec3{b.moon.litFrom};
    h.moonRadiance = environment.sun.irradiance * float(kMoonReflects / std::numbers::pi * (1 - 0.75 * b.night) * std::min(environment.moon.brightness, 4.0f));
    h.stars = environment.sky.stars * kStar * float(b.glow);
    h.milkyWay = environment.sky.stars * kMilkyWay * float(b.deepNight);
    h.glow = kGlow * float(b.glow) * (1 + 0.8f * moonInSky(b));
    h.glowOverhead = kGlowOverhead * float(b.deepNight) * (1 + 2 * moonInSky(b));
    const glm::dmat3 rows = glm::transpose(io::equatorFromWorld(environment));
    for (int i = 0; i < 3; ++i)
        h.equatorFromWorld[i] = glm::vec4{rows[i], 0};
    return h;
}

} // namespace renderer
