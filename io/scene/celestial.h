// Where sun, moon and stars stand: NOAA's solar calculator for the sun, the Astronomical Almanac's low-precision series for the
// moon (0.3 degrees). As the air is drawn without refraction, places are without it too: a real sun at the horizon is seen half a
// degree higher.
#pragma once

#include "io/scene/environment.h"

namespace io {

double julianDate(int year, double dayOfYear, double hoursUt); // days; 1 January is day 1

struct SunElements { // of the ecliptic, for the sun's middle
    double longitude = 0;      // degrees, apparent
    double obliquity = 0;      // degrees
    double declination = 0;    // degrees
    double equationOfTime = 0; // minutes that a sundial is ahead of a clock
};
SunElements sunElements(double julianDate);

struct MoonElements { // seen from the middle of the earth
    double longitude = 0, latitude = 0; // degrees, ecliptic
    double parallax = 0;                // degrees
};
MoonElements moonElements(double julianDate);

// The instant that the environment's clock shows: `time` is the sun's own hours or those of its time zone.
double julianDate(const Environment& environment);
double hourAngle(const Environment& environment); // of the sun: degrees, 0 at its highest, positive after that

// Rows: towards the equinox of spring, 90 degrees east of it, and the celestial pole; turns with the sidereal day.
glm::dmat3 equatorFromWorld(const Environment& environment);

struct MoonPlace {
    glm::dvec3 toward{0, 1, 0};  // unit
    glm::dvec3 litFrom{0, 1, 0}; // unit; whence its light comes, as seen from there
    double phase = 0;            // 0 new, 0.25 first quarter, 0.5 full
};
MoonPlace moonOf(const Environment& environment); // by time or by hand

} // namespace io
