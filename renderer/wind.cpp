#include "renderer/wind.h"

#include <cmath>

namespace renderer {
namespace {

constexpr double kAnchorStep = 1024; // m; floats hold multiples of it exactly

double wrapped(double value, double period)
{
    return value - std::floor(value / period) * period;
}

} // namespace

glsl::Wind windOf(const io::Wind& wind, bool on, const glm::dvec3& eye, double time)
{
    const double direction = glm::radians(double(wind.direction));
    const glm::dvec2 towards{std::sin(direction), -std::cos(direction)}; // clockwise from north, -Z
    const glm::dvec2 anchor = glm::round(glm::dvec2{eye.x, eye.z} / kAnchorStep) * kAnchorStep;
    const double along = glm::dot(anchor, towards) - double(wind.speed) * time;
    const double across = anchor.y * towards.x - anchor.x * towards.y;
    const glm::dvec2 origin{wrapped(along, double(WIND_GUST_PERIOD)), wrapped(across, double(WIND_GUST_PERIOD))};
    return {.towards = glm::vec2{towards},
            .speed = on ? wind.speed : 0.0f,
            .gustiness = wind.gustiness,
            .anchor = glm::vec2{anchor},
            .origin = glm::vec2{origin},
            .time = float(wrapped(time, double(WIND_PERIOD)))};
}

} // namespace renderer
