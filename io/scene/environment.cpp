#include "io/scene/environment.h"

#include <cmath>

namespace io {
namespace {

// Azimuth clockwise from north; north is -Z, east +X.
glm::dvec3 direction(double azimuth, double elevation)
{
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation)};
}

} // namespace

glm::dvec3 towardSun(const Environment& environment)
{
    if (environment.sun.mode == SunMode::Manual)
        return direction(glm::radians(double(environment.sun.azimuth)), glm::radians(double(environment.sun.elevation)));

    // Declination after Cooper (1969); the hour angle is 0 at local solar noon and grows 15 degrees an hour.
    const double declination =
        glm::radians(23.45) * std::sin(glm::radians(360.0 * (284.0 + environment.dayOfYear) / 365.0));
    const double hourAngle = glm::radians(15.0 * (double(environment.time) - 12.0));
    const double latitude = glm::radians(double(environment.latitude));
    const double east = -std::cos(declination) * std::sin(hourAngle);
    const double north = std::sin(declination) * std::cos(latitude) -
                         std::cos(declination) * std::sin(latitude) * std::cos(hourAngle);
    const double up = std::sin(declination) * std::sin(latitude) +
                      std::cos(declination) * std::cos(latitude) * std::cos(hourAngle);
    return glm::normalize(glm::dvec3{east, up, -north});
}

} // namespace io
