#include "io/scene/environment_presets.h"

#include <cmath>

namespace io {
namespace {

constexpr int kSteps = 288; // of a day: five minutes, in which the sun does not rise and set

double elevationAt(Environment environment, double hour)
{
    environment.sun.mode = SunMode::Time;
    environment.time = float(hour);
    return glm::degrees(std::asin(glm::clamp(towardSun(environment).y, -1.0, 1.0)));
}

// By the hour where the day has one, so that it can go on from there; by hand in a summer or winter without.
void placeSun(Environment& e, double elevation, bool rising)
{
    if (const std::optional<float> hour = hourOf(e, elevation, rising)) {
        e.sun.mode = SunMode::Time;
        e.time = *hour;
        return;
    }
    e.sun.mode = SunMode::Manual;
    e.sun.azimuth = rising ? 95.0f : 265.0f;
    e.sun.elevation = float(elevation);
}

void placeAtNoon(Environment& e)
{
    e.sun.mode = SunMode::Time;
    double best = -90;
    for (int i = 0; i < kSteps; ++i) {
        const double hour = 24.0 * i / kSteps, elevation = elevationAt(e, hour);
        if (elevation <= best) continue;
        best = elevation;
        e.time = float(hour);
    }
}

// What a clear day has in common.
Environment fairWeather(const Environment& own)
{
    const Environment fair;
    Environment e = withLook(own, fair);
    e.sun.irradiance = own.sun.irradiance;
    e.shadows = own.shadows;
    e.occlusion = own.occlusion;
    e.wind.direction = own.wind.direction;
    e.clouds.direction = own.clouds.direction;
    e.clouds.seed = own.clouds.seed;
    // How a picture is made is no weather.
    e.sky.method = own.sky.method;
    e.clouds.kind = own.clouds.kind;
    e.grading.antiAliasing = own.grading.antiAliasing;
    e.grading.shading = own.grading.shading;
    e.grading.dither = own.grading.dither;
    return e;
}

} // namespace

std::optional<float> hourOf(const Environment& environment, double elevation, bool rising)
{
    const auto above = [&](double hour) { return elevationAt(environment, hour) >= elevation; };
    for (int i = 0; i < kSteps; ++i) {
        double from = 24.0 * i / kSteps, to = 24.0 * (i + 1) / kSteps;
        const bool before = above(from);
        if (before == rising || above(to) == before) continue;
        for (int halving = 0; halving < 20; ++halving) {
            const double middle = (from + to) / 2;
            (above(middle) == before ? from : to) = middle;
        }
        return float(to);
    }
    return std::nullopt;
}

Environment withLook(const Environment& own, const Environment& look)
{
    Environment e = look;
    e.clock = own.clock;
    e.timeZone = own.timeZone;
    e.dayOfYear = own.dayOfYear;
    e.year = own.year;
    e.latitude = own.latitude;
    e.longitude = own.longitude;
    e.daySpeed = own.daySpeed;
    e.dayRuns = own.dayRuns;
    e.sky.planetRadius = own.sky.planetRadius;
    e.sky.airDepth = own.sky.airDepth;
    e.sky.groundAlbedo = own.sky.groundAlbedo;
    e.water = own.water;
    e.extra = own.extra;
    return e;
}

Environment withPreset(const Environment& own, Preset preset)
{
    Environment e = fairWeather(own);
    switch (preset) {
    case Preset::Dawn:
        placeSun(e, 2.5, true);
        e.clouds.coverage = 0.3f;
        e.clouds.softness = 0.45f;
        e.fog = {.density = 0.0005f, .height = 70, .base = own.fog.base, .shafts = 1};
        e.wind.speed = 1;
        e.exposure = 4.7f;
        break;
    case Preset::Noon:
        placeAtNoon(e);
        e.fog.base = own.fog.base;
        e.clouds.coverage = 0.3f;
        break;
    case Preset::GoldenHour:
        placeSun(e, 12, false); // mountains leave most valleys lit, and the light is warm already
        e.clouds.coverage = 0.15f;  // so low a sun finds few gaps between more of them,
        e.clouds.thickness = 500;   // nor between higher ones
        e.fog = {.density = 0.00022f, .height = 200, .base = own.fog.base, .shafts = 1};
        e.exposure = 4.5f;
        break;
    case Preset::Dusk:
        placeSun(e, -2, false);
        e.clouds.coverage = 0.4f;
        e.fog = {.density = 0.0002f, .height = 150, .base = own.fog.base, .shafts = 1};
        e.wind.speed = 1.5f;
        e.grading.temperature = 5200; // as a camera set for daylight sees it: the hour is blue
        e.grading.tint = -0.5f;
        e.grading.saturation = 0.85f;
        e.exposure = 5.1f;
        break;
    case Preset::Overcast:
        placeSun(e, 35, false);
        e.clouds.coverage = 0.97f;
        e.clouds.softness = 0.6f;
        e.clouds.altitude = 1400;
        e.fog = {.density = 0.0003f, .height = 500, .base = own.fog.base, .shafts = 0.5f};
        e.wind.speed = 5;
        e.grading.temperature = 5400;
        e.exposure = 4.3f;
        break;
    case Preset::Storm:
        placeSun(e, 32, false);
        e.clouds.coverage = 1;
        e.clouds.softness = 0.35f;
        e.clouds.altitude = 900;
        e.clouds.thickness = 3500;
        e.clouds.density = 0.09f;
        e.clouds.speed = 25;
        e.clouds.change = 3;
        e.weather.rain = 10;
        e.fog = {.density = 0.0009f, .height = 600, .base = own.fog.base, .shafts = 0.3f};
        e.wind.speed = 13;
        e.wind.gustiness = 0.7f;
        e.grading.temperature = 4900;
        e.grading.saturation = 0.9f;
        e.exposure = 5.6f;
        break;
    case Preset::Night:
        placeSun(e, -25, false);
        e.moon.mode = SunMode::Manual;
        e.moon.azimuth = 150;
        e.moon.elevation = 38;
        e.moon.phase = 0.45f;
        e.clouds.coverage = 0.2f;
        e.fog = {.density = 0.0002f, .height = 90, .base = own.fog.base, .shafts = 1};
        e.wind.speed = 1;
        e.grading.saturation = 0.75f; // by moonlight eyes see little colour
        e.exposure = 3.9f;
        break;
    }
    return e;
}

} // namespace io
