#include "renderer/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer {
namespace {

// Stars and airglow: enough to see shapes by, grown in while the sun sinks from 5 to 14 degrees below the horizon.
glm::vec3 nightSky(double sunHeight)
{
    const double night = glm::smoothstep(-std::sin(glm::radians(5.0)), -std::sin(glm::radians(14.0)), sunHeight);
    return glm::vec3{0.0021f, 0.0034f, 0.0064f} * float(night);
}

void addShadows(glsl::Light& light, const io::Shadows& shadows, std::span<const Cascade> cascades)
{
    light.cascades = std::max(int(cascades.size()), 1);
    light.shadowSoftness = shadows.softness;
    light.shadowBias = shadows.bias;
    light.shadowTexel = 1.0f / float(std::max(shadows.resolution, 1));
    for (std::size_t i = 0; i < cascades.size(); ++i) {
        light.shadowFromRelative[i] = glm::mat4{cascades[i].textureFromRelative};
        light.cascadeEnd[int(i)] = float(cascades[i].endDepth);
        light.cascadeTexel[int(i)] = float(cascades[i].texel);
    }
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
    light.cloudsOn = input.settings.clouds ? glm::smoothstep(0.0f, 0.08f, e.clouds.coverage) : 0.0f;
    light.sunRadius = float(radius);
    light.sunSolidAngle = float(4 * std::numbers::pi * std::pow(std::sin(radius / 2), 2));
    light.skyFloor = nightSky(towardSun.y);
    light.groundShadow = input.groundShadow;
    addShadows(light, e.shadows, input.cascades);
    addFog(light, e.fog, input.settings.fog, eyeHeight);
    return light;
}

} // namespace renderer
