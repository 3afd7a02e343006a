#include "app/sound/wind_sound.h"

#include "io/base/noise.h"
#include "io/scene/ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double kAround = 120;   // m
constexpr float kFullSpeed = 22;  // m/s, where it is as loud as it gets
constexpr float kStormWeather = 2; // mm an hour

} // namespace

double exposedHeight(const io::Scene& scene, const glm::dvec3& ear)
{
    const std::optional<double> below = io::groundHeight(scene, ear.x, ear.z);
    if (!below) return 10;
    double sum = *below;
    int count = 1;
    for (int i = 0; i < 8; ++i) {
        const double angle = i * std::numbers::pi / 4;
        if (const auto height = io::groundHeight(scene, ear.x + std::cos(angle) * kAround, ear.z + std::sin(angle) * kAround)) {
            sum += *height;
            ++count;
        }
    }
    return std::max(1.0, ear.y - std::min(sum / count, *below));
}

WindSound windAt(const io::Scene& scene, const io::Environment& environment, const glm::dvec3& ear, double seconds)
{
    const io::Wind& wind = environment.wind;
    // The speed is that ten metres up; below and above it goes by a power of the height (the seventh root over open land).
    const double profile = std::clamp(std::pow(exposedHeight(scene, ear) / 10, 1.0 / 7), 0.6, 1.9);
    // Gusts come every few seconds, and some of them every half minute.
    const auto time = float(std::fmod(seconds, 36000.0));
    const float gust = io::noise(glm::vec2{time * 0.21f, 0.5f}, 77) + 0.6f * io::noise(glm::vec2{time * 0.05f, 0.5f}, 78);
    const float speed = wind.speed * float(profile) * std::max(0.1f, 1 + wind.gustiness * gust);
    const float wet = std::max(environment.weather.rain, environment.weather.snow);
    const float storm = wind.speed > 12 ? std::min(1.0f, wet / kStormWeather) : 0; // rain lashes, and it howls
    const float strength = std::min(1.0f, speed / kFullSpeed);
    return {.level = std::min(1.0f, std::pow(strength, 1.2f) * (1 + 0.5f * storm)),
            .pitch = 0.85f + 0.35f * strength + 0.1f * storm,
            .treble = std::min(1.0f, 0.35f + 0.65f * strength + 0.2f * storm)};
}

} // namespace app
