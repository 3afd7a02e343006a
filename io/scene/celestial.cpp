#include "io/scene/celestial.h"

#include <cmath>

namespace io {
namespace {

constexpr double kJ2000 = 2451545.0; // noon of 1 January 2000

double sine(double degrees) { return std::sin(glm::radians(degrees)); }
double cosine(double degrees) { return std::cos(glm::radians(degrees)); }
double turned(double degrees) { return degrees - 360 * std::floor(degrees / 360); }
double centuries(double julianDate) { return (julianDate - kJ2000) / 36525; }

// East is +X, up +Y, north -Z.
glm::dvec3 direction(double azimuth, double elevation)
{
    return {sine(azimuth) * cosine(elevation), sine(elevation), -cosine(azimuth) * cosine(elevation)};
}

// Of a place on the celestial sphere: degrees west of the meridian and north of the equator.
glm::dvec3 fromHourAngle(double hourAngle, double declination, double latitude)
{
    const double east = -cosine(declination) * sine(hourAngle);
    const double north = sine(declination) * cosine(latitude) - cosine(declination) * sine(latitude) * cosine(hourAngle);
    const double up = sine(declination) * sine(latitude) + cosine(declination) * cosine(latitude) * cosine(hourAngle);
    return {east, up, -north};
}

double meanSiderealTime(double julianDate) // at Greenwich, degrees: Meeus, Astronomical Algorithms, 12.4
{
    return turned(280.46061837 + 360.98564736629 * (julianDate - kJ2000));
}

double midnight(const Environment& e)
{
    return julianDate(e.year, e.dayOfYear, 0);
}

} // namespace

double julianDate(int year, double dayOfYear, double hoursUt)
{
    const double before = year - 1; // the Gregorian calendar's years that are over
    const double newYear = 1721425.5 + 365 * before + std::floor(before / 4) - std::floor(before / 100) + std::floor(before / 400);
    return newYear + (dayOfYear - 1) + hoursUt / 24;
}

// Names of its sheet: Geom Mean Long Sun, Geom Mean Anom Sun, Eccent Earth Orbit, Sun Eq of Ctr, Sun App Long, Obliq Corr, Sun
// Declin, Eq of Time. The formulas are those of Meeus, chapters 25 and 28.
SunElements sunElements(double julianDate)
{
    const double t = centuries(julianDate);
    const double meanLongitude = turned(280.46646 + t * (36000.76983 + t * 0.0003032));
    const double anomaly = 357.52911 + t * (35999.05029 - 0.0001537 * t);
    const double eccentricity = 0.016708634 - t * (0.000042037 + 0.0000001267 * t);
    const double centre = sine(anomaly) * (1.914602 - t * (0.004817 + 0.000014 * t)) + sine(2 * anomaly) * (0.019993 - 0.000101 * t) +
                          sine(3 * anomaly) * 0.000289;
    const double node = 125.04 - 1934.136 * t;
    const double meanObliquity = 23 + (26 + (21.448 - t * (46.815 + t * (0.00059 - t * 0.001813))) / 60) / 60;

    SunElements sun;
    sun.longitude = meanLongitude + centre - 0.00569 - 0.00478 * sine(node);
    sun.obliquity = meanObliquity + 0.00256 * cosine(node);
    sun.declination = glm::degrees(std::asin(sine(sun.obliquity) * sine(sun.longitude)));
    const double y = std::pow(std::tan(glm::radians(sun.obliquity / 2)), 2);
    sun.equationOfTime = 4 * glm::degrees(y * sine(2 * meanLongitude) - 2 * eccentricity * sine(anomaly) +
                                          4 * eccentricity * y * sine(anomaly) * cosine(2 * meanLongitude) -
                                          0.5 * y * y * sine(4 * meanLongitude) - 1.25 * eccentricity * eccentricity * sine(2 * anomaly));
    return sun;
}

// The Astronomical Almanac, "Low precision formulae for geocentric coordinates of the Moon".
MoonElements moonElements(double julianDate)
{
    const double t = centuries(julianDate);
    MoonElements moon;
    moon.longitude = turned(218.32 + 481267.881 * t + 6.29 * sine(135.0 + 477198.87 * t) - 1.27 * sine(259.3 - 413335.36 * t) +
                            0.66 * sine(235.7 + 890534.22 * t) + 0.21 * sine(269.9 + 954397.74 * t) - 0.19 * sine(357.5 + 35999.05 * t) -
                            0.11 * sine(186.5 + 966404.03 * t));
    moon.latitude = 5.13 * sine(93.3 + 483202.02 * t) + 0.28 * sine(228.2 + 960400.89 * t) - 0.28 * sine(318.3 + 6003.15 * t) -
                    0.17 * sine(217.6 - 407332.21 * t);
    moon.parallax = 0.9508 + 0.0518 * cosine(135.0 + 477198.87 * t) + 0.0095 * cosine(259.3 - 413335.36 * t) +
                    0.0078 * cosine(235.7 + 890534.22 * t) + 0.0028 * cosine(269.9 + 954397.74 * t);
    return moon;
}

double julianDate(const Environment& e)
{
    if (e.clock == Clock::Zone) return midnight(e) + (double(e.time) - e.timeZone) / 24;
    // The sun's hours are a clock's at this longitude but for the equation of time, which an hour hardly changes.
    const double mean = midnight(e) + (double(e.time) - e.longitude / 15) / 24;
    return mean - sunElements(mean).equationOfTime / 1440;
}

double hourAngle(const Environment& e)
{
    if (e.clock == Clock::Solar) return 15 * (double(e.time) - 12);
    const double minutes = (double(e.time) - e.timeZone) * 60 + sunElements(julianDate(e)).equationOfTime + 4 * double(e.longitude);
    return turned(minutes / 4) - 180; // a whole turn more or less is none
}

Environment hoursLater(Environment environment, double hours)
{
    constexpr double kHoursADay = 24;
    const auto daysIn = [](int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0 ? 366 : 365; };
    const double then = double(environment.time) + hours, days = std::floor(then / kHoursADay);
    environment.time = float(then - days * kHoursADay);
    environment.dayOfYear += int(days);
    while (environment.dayOfYear > daysIn(environment.year)) {
        environment.dayOfYear -= daysIn(environment.year);
        ++environment.year;
    }
    return environment;
}

glm::dvec3 towardSun(const Environment& e)
{
    if (e.sun.mode == SunMode::Manual) return direction(e.sun.azimuth, e.sun.elevation);
    return glm::normalize(fromHourAngle(hourAngle(e), sunElements(julianDate(e)).declination, e.latitude));
}

glm::dmat3 equatorFromWorld(const Environment& e)
{
    const double sidereal = meanSiderealTime(julianDate(e)) + e.longitude;
    return glm::transpose(glm::dmat3{fromHourAngle(sidereal, 0, e.latitude), fromHourAngle(sidereal - 90, 0, e.latitude),
                                     fromHourAngle(0, 90, e.latitude)});
}

MoonPlace moonOf(const Environment& e)
{
    const glm::dvec3 sun = towardSun(e);
    MoonPlace place;
    if (e.moon.mode == SunMode::Manual) {
        place.toward = direction(e.moon.azimuth, e.moon.elevation);
        place.phase = e.moon.phase;
        // Lit from as far round as its phase says, on the side of the sun.
        glm::dvec3 side = sun - place.toward * glm::dot(sun, place.toward);
        if (glm::length(side) < 1e-3) side = glm::cross(place.toward, glm::dvec3{0.31, 0.92, -0.23});
        const double elongation = 180 * (1 - std::abs(1 - 2 * place.phase));
        place.litFrom = place.toward * cosine(elongation) + glm::normalize(side) * sine(elongation);
        return place;
    }
    const double instant = julianDate(e);
    const MoonElements moon = moonElements(instant);
    const SunElements sunNow = sunElements(instant);
    const glm::dvec3 ecliptic{cosine(moon.latitude) * cosine(moon.longitude), cosine(moon.latitude) * sine(moon.longitude), sine(moon.latitude)};
    const double c = cosine(sunNow.obliquity), s = sine(sunNow.obliquity);
    const glm::dvec3 equator{ecliptic.x, ecliptic.y * c - ecliptic.z * s, ecliptic.y * s + ecliptic.z * c};
    const glm::dvec3 geocentric = glm::transpose(equatorFromWorld(e)) * equator;
    // Seen from the ground, not from the middle of the earth.
    place.toward = glm::normalize(geocentric / sine(moon.parallax) - glm::dvec3{0, 1, 0});
    place.phase = turned(moon.longitude - sunNow.longitude) / 360;
    const glm::dvec3 sunward{cosine(sunNow.longitude), sine(sunNow.longitude) * c, sine(sunNow.longitude) * s};
    place.litFrom = glm::transpose(equatorFromWorld(e)) * sunward;
    return place;
}

} // namespace io
