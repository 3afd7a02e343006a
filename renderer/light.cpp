#include "renderer/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer {
namespace {

constexpr double kCloudTile = 11000.0; // m, as in clouds.glsl
constexpr double kCloudPeriod = kCloudTile * 100; // a whole number of repeats of every octave, nearly

// Stars and airglow: enough to see shapes by, grown in while the sun sinks from 5 to 14 degrees below the horizon.
glm::vec3 nightSky(double sunHeight)
{
    const double night = glm::smoothstep(-std::sin(glm::radians(5.0)), -std::sin(glm::radians(14.0)), sunHeight);
    return glm::vec3{0.0021f, 0.0034f, 0.0064f} * float(night);
}

void addFog(glsl::Light& light, const io::Fog& fog, bool on, double eyeHeight)
{
    const double height = std::max(double(fog.height), 1.0);
    const double exponent = std::clamp(-(eyeHeight - fog.base) / height, -60.0, 6.0);
    light.fogTint = fog.tint;
    light.fogHeight = float(height);
    light.fogDensity = on ? float(fog.density * std::exp(exponent)) : 0.0f;
}

// The value that a share `coverage` of the cloud field exceeds; the field's values lie about as a logistic curve does.
float cloudEdge(float coverage)
{
    const float share = glm::clamp(coverage, 0.005f, 0.995f);
    return 0.53f - 0.043f * std::log(share / (1 - share));
}

void addClouds(glsl::Light& light, const io::Clouds& clouds, bool on, const Eye& eye, double time)
{
    const double towards = glm::radians(double(clouds.direction));
    const glm::dvec2 wind{std::sin(towards), -std::cos(towards)}; // clockwise from north, -Z
    const glm::dvec2 drifted = glm::dvec2{eye.position.x, eye.position.z} - wind * (double(clouds.speed) * time);
    light.cloudsOn = on && clouds.coverage > 0 ? glm::smoothstep(0.0f, 0.08f, clouds.coverage) : 0.0f;
    light.cloudAltitude = float(clouds.altitude - eye.position.y);
    light.cloudEdge = cloudEdge(clouds.coverage);
    light.cloudWidth = 0.035f + 0.22f * clouds.softness;
    light.cloudOrigin = glm::vec2{drifted - glm::floor(drifted / kCloudPeriod) * kCloudPeriod};
    light.cloudWind = glm::vec2{wind};

    // The map moves by whole texels of the field, so that shadows do not swim.
    const glm::dvec2 shift = glm::dvec2{light.towardSun.x, light.towardSun.z} / std::max(double(light.towardSun.y), 0.12);
    const glm::dvec2 seen = glm::dvec2{light.cloudOrigin} + shift * double(light.cloudAltitude);
    constexpr double kTexel = double(CLOUD_MAP_METRES) / CLOUD_MAP_SIZE;
    const glm::dvec2 middle = glm::floor(seen / kTexel) * kTexel;
    light.cloudMap = glm::vec4{middle, (seen - middle) / double(CLOUD_MAP_METRES) + 0.5};
}

} // namespace

glsl::Atmosphere atmosphereOf(const io::Sky& sky, double eyeHeight)
{
    constexpr float kPerKm = 1e-3f; // from 1e-6 per m
    glsl::Atmosphere air{};
    air.rayleigh = sky.rayleigh * kPerKm;
    air.rayleighHeight = std::max(sky.rayleighHeight, 1.0f) * 1e-3f;
    air.ozone = sky.ozone * kPerKm;
    air.mieHeight = std::max(sky.mieHeight, 1.0f) * 1e-3f;
    air.mieScattering = sky.mieScattering * kPerKm;
    air.mieExtinction = std::max(sky.mieExtinction, sky.mieScattering) * kPerKm;
    air.mieG = sky.mieG;
    air.groundAlbedo = sky.groundAlbedo;
    air.eyeAltitude = float(std::clamp(eyeHeight, 1.0, 60000.0) * 1e-3);
    air.horizon = std::asin(glsl::horizonCosine(air.eyeAltitude));
    return air;
}

glm::vec3 sunThrough(const glsl::Atmosphere& air, double height, const glm::dvec3& towardSun, double sunRadius)
{
    const auto altitude = float(std::clamp(height, 1.0, 60000.0) * 1e-3);
    const auto mu = float(towardSun.y);
    const float seen = glsl::sunAboveHorizon(altitude, mu, float(sunRadius));
    if (seen <= 0) return glm::vec3{0};
    return glsl::integrateTransmittance(air, altitude, std::max(mu, glsl::horizonCosine(altitude)), 64) * seen;
}

glsl::Light lightOf(const LightInput& input)
{
    const io::Environment& e = input.environment;
    const glm::dvec3 towardSun = io::towardSun(e);
    const double radius = glm::radians(std::max(double(e.sun.angularDiameter), 0.01)) / 2;
    const double eyeHeight = input.eye.position.y;

    glsl::Light light{};
    light.atmosphere = atmosphereOf(e.sky, eyeHeight);
    light.towardSun = glm::vec3{towardSun};
    light.ambient = e.sky.ambient;
    light.sunAbove = e.sun.irradiance;
    light.sunIrradiance = e.sun.irradiance * sunThrough(light.atmosphere, eyeHeight, towardSun, radius);
    light.sunAtClouds = e.sun.irradiance * sunThrough(light.atmosphere, e.clouds.altitude, towardSun, radius);
    light.sunRadius = float(radius);
    light.sunSolidAngle = float(4 * std::numbers::pi * std::pow(std::sin(radius / 2), 2));
    light.skyFloor = nightSky(towardSun.y);
    light.groundShadow = input.groundShadow;
    addFog(light, e.fog, input.settings.fog, eyeHeight);
    addClouds(light, e.clouds, input.settings.clouds, input.eye, input.time);
    return light;
}

} // namespace renderer
