#include "renderer/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer {
namespace {

// A finite value within its range, whatever the scene says.
float sane(float value, float low, float high, float otherwise)
{
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

glm::vec3 sane(const glm::vec3& value, float high, const glm::vec3& otherwise)
{
    return {sane(value.x, 0, high, otherwise.x), sane(value.y, 0, high, otherwise.y), sane(value.z, 0, high, otherwise.z)};
}

void addFog(glsl::Light& light, const io::Fog& fog, bool on, double eyeHeight)
{
    const double height = std::max(double(fog.height), 1.0);
    const double exponent = std::clamp(-(eyeHeight - fog.base) / height, -60.0, 6.0);
    light.fogTint = fog.tint;
    light.fogHeight = float(height);
    light.fogDensity = on ? float(fog.density * std::exp(exponent)) : 0.0f;
}

} // namespace

namespace {

// km, at least a metre above the ground and within the air
float altitudeOf(const glsl::Atmosphere& air, double height)
{
    const double metres = std::isfinite(height) ? height : 0.0;
    return float(std::clamp(metres * 1e-3, 1e-3, 0.98 * double(air.airDepth)));
}

} // namespace

glsl::Atmosphere atmosphereOf(const io::Sky& sky, double eyeHeight)
{
    constexpr float kPerKm = 1e-3f; // from 1e-6 per m
    constexpr float kThickest = 1000; // 1e-6 per m
    const io::Sky usual;
    glsl::Atmosphere air{};
    air.groundRadius = sane(sky.planetRadius, 100, 1e5f, usual.planetRadius);
    air.airDepth = sane(sky.airDepth, 10, 1000, usual.airDepth);
    air.rayleigh = sane(sky.rayleigh, kThickest, usual.rayleigh) * kPerKm;
    air.rayleighHeight = sane(sky.rayleighHeight, 100, 1e5f, usual.rayleighHeight) * 1e-3f;
    air.ozone = sane(sky.ozone, kThickest, usual.ozone) * kPerKm;
    air.mieHeight = sane(sky.mieHeight, 50, 1e5f, usual.mieHeight) * 1e-3f;
    air.mieScattering = sane(sky.mieScattering, 0, kThickest, usual.mieScattering) * kPerKm;
    air.mieExtinction = std::max(sane(sky.mieExtinction, 0, kThickest, usual.mieExtinction) * kPerKm, air.mieScattering);
    air.mieG = sane(sky.mieG, -0.99f, 0.99f, usual.mieG);
    air.groundAlbedo = sane(sky.groundAlbedo, 0, 1, usual.groundAlbedo);
    air.eyeAltitude = altitudeOf(air, eyeHeight);
    air.horizon = std::asin(glsl::horizonCosine(air, air.eyeAltitude));
    return air;
}

glm::vec3 sunThrough(const glsl::Atmosphere& air, double height, const glm::dvec3& towardSun, double sunRadius)
{
    const float altitude = altitudeOf(air, height);
    const auto mu = float(towardSun.y);
    const float seen = glsl::sunAboveHorizon(air, altitude, mu, float(sunRadius));
    if (seen <= 0) return glm::vec3{0};
    return glsl::integrateTransmittance(air, altitude, std::max(mu, glsl::horizonCosine(air, altitude)), 64) * seen;
}

glsl::Light lightOf(const LightInput& input)
{
    const io::Environment& e = input.environment;
    const glm::dvec3 toward = input.bodies.towardLight();
    const double radius = glm::radians(std::max(double(e.sun.angularDiameter), 0.01)) / 2;
    const double eyeHeight = input.eye.position.y;

    glsl::Light light{};
    light.atmosphere = atmosphereOf(e.sky, eyeHeight);
    light.towardSun = glm::vec3{toward};
    light.ambient = e.sky.ambient;
    light.sunAbove = e.sun.irradiance;
    const glm::vec3 above = input.bodies.moonLights ? input.bodies.moonlight : e.sun.irradiance;
    light.sunIrradiance = above * sunThrough(light.atmosphere, eyeHeight, toward, radius);
    for (int i = 0; i < SUN_HEIGHTS; ++i)
        light.sunAt[i] = glm::vec4{above * sunThrough(light.atmosphere, glsl::sunHeightOf(i), toward, radius), 0};
    light.sunAtClouds = above * sunThrough(light.atmosphere, e.clouds.altitude, toward, radius);
    light.cloudsOn = input.settings.clouds ? glm::smoothstep(0.0f, 0.08f, e.clouds.coverage) : 0.0f;
    light.sunRadius = float(radius);
    light.sunSolidAngle = float(4 * std::numbers::pi * std::pow(std::sin(radius / 2), 2));
    light.skyFloor = nightOnSurfaces(input.bodies);
    light.groundShadow = input.groundShadow;
    addFog(light, e.fog, input.settings.fog, eyeHeight);
    return light;
}

bool sunReaches(const glsl::Light& light)
{
    const glm::vec4& highest = light.sunAt[SUN_HEIGHTS - 1];
    return std::max({highest.x, highest.y, highest.z}) > 0;
}

} // namespace renderer
