// Sun, moon and stars against published places.
#include "io/scene/celestial.h"

#include <gtest/gtest.h>

#include <cmath>

namespace io {
namespace {

double elevation(const glm::dvec3& d)
{
    return glm::degrees(std::asin(d.y));
}

double azimuth(const glm::dvec3& d)
{
    const double a = glm::degrees(std::atan2(d.x, -d.z));
    return a < 0 ? a + 360 : a;
}

double between(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)));
}

Environment at(int year, int day, double hour, double zone, double latitude, double longitude)
{
    Environment e;
    e.clock = Clock::Zone;
    e.year = year;
    e.dayOfYear = day;
    e.time = float(hour);
    e.timeZone = float(zone);
    e.latitude = float(latitude);
    e.longitude = float(longitude);
    return e;
}

// Meeus, Astronomical Algorithms, chapter 7.
TEST(Celestial, JulianDates)
{
    EXPECT_DOUBLE_EQ(julianDate(2000, 1, 12), 2451545.0);
    EXPECT_DOUBLE_EQ(julianDate(1999, 1, 0), 2451179.5);
    EXPECT_DOUBLE_EQ(julianDate(1988, 171, 12), 2447332.0); // 19 June
    EXPECT_DOUBLE_EQ(julianDate(1900, 1, 0), 2415020.5);
}

// Meeus, examples 25.a and 28.b: 13 October 1992, 0 h. The sheet of NOAA follows his low accuracy: 0.01 degrees.
TEST(Celestial, SunElementsAreThoseOfMeeus)
{
    const SunElements sun = sunElements(2448908.5);
    EXPECT_NEAR(sun.longitude - 360 * std::floor(sun.longitude / 360), 199.90895, 0.01);
    EXPECT_NEAR(sun.declination, -7.78507, 0.01);
    EXPECT_NEAR(sun.obliquity, 23.43999, 0.001);
    EXPECT_NEAR(sun.equationOfTime, 13 + 42.6 / 60, 0.05);
}

// Rows of NOAA's own sheet, "NOAA_Solar_Calculations_day": 21 June 2010, 0:06 at UT-6, and 21 September 2023, 5:33 at UT-8.
TEST(Celestial, SunElementsAreThoseOfNoaasSheet)
{
    const SunElements june = sunElements(2455368.75416667), september = sunElements(2460209.06458333);
    EXPECT_NEAR(june.longitude - 360 * std::floor(june.longitude / 360), 89.7854391815, 1e-5);
    EXPECT_NEAR(june.obliquity, 23.4384863294, 1e-6);
    EXPECT_NEAR(september.longitude - 360 * std::floor(september.longitude / 360), 178.3169803107, 1e-5);
    EXPECT_NEAR(september.obliquity, 23.4385024898, 1e-6);
}

// Reda and Andreas, "Solar Position Algorithm for Solar Radiation Applications" (NREL 2004), appendix A.5: 17 October 2003,
// 12:30:30 at UT-7, 39.742476 north, 105.1786 west. Without refraction.
TEST(Celestial, SunStandsWhereNrelSays)
{
    const Environment e = at(2003, 290, 12 + 30.5 / 60, -7, 39.742476, -105.1786);
    EXPECT_NEAR(elevation(towardSun(e)), 39.872046, 0.01);
    EXPECT_NEAR(azimuth(towardSun(e)), 194.340241, 0.02);
    EXPECT_NEAR(sunElements(julianDate(e)).declination, -9.314340, 0.005);
    EXPECT_NEAR(sunElements(julianDate(e)).equationOfTime, 14.641503, 0.05);
}

// The instants of the United States Naval Observatory's "Earth's Seasons": the ecliptic's longitude is a multiple of 90 degrees.
TEST(Celestial, SeasonsBeginWhenTheObservatorySays)
{
    struct Season {
        int year, day;
        double hour, longitude;
    };
    for (const Season s : {Season{2000, 80, 7 + 35 / 60.0, 0}, Season{2000, 173, 1 + 48 / 60.0, 90}, Season{2000, 266, 17 + 28 / 60.0, 180},
                           Season{2000, 356, 13 + 37 / 60.0, 270}, Season{2024, 80, 3 + 6 / 60.0, 0}, Season{2024, 172, 20 + 51 / 60.0, 90},
                           Season{2024, 266, 12 + 44 / 60.0, 180}, Season{2024, 356, 9 + 21 / 60.0, 270}}) {
        const double error = sunElements(julianDate(s.year, s.day, s.hour)).longitude - s.longitude;
        EXPECT_NEAR(error - 360 * std::round(error / 360), 0, 0.01) << s.year << " " << s.longitude;
    }
}

// At those instants the sun is overhead where it is noon: the equator in spring and autumn, the tropics between.
TEST(Celestial, SunIsOverheadAtTheTropics)
{
    Environment e;
    e.year = 2024;
    e.time = 12;
    e.dayOfYear = 172;
    e.latitude = 23.44f;
    EXPECT_NEAR(elevation(towardSun(e)), 90, 0.05);
    e.dayOfYear = 356;
    e.latitude = -23.44f;
    EXPECT_NEAR(elevation(towardSun(e)), 90, 0.05);
}

TEST(Celestial, SolarHoursKeepTheirPromise)
{
    for (const float longitude : {-120.0f, 0.0f, 77.5f})
        for (const int day : {42, 172, 308}) {
            Environment e;
            e.longitude = longitude;
            e.dayOfYear = day;
            e.time = 12;
            EXPECT_NEAR(towardSun(e).x, 0, 1e-9); // on the meridian whatever the equation of time
            e.time = 15.5f;
            EXPECT_DOUBLE_EQ(hourAngle(e), 52.5);
        }
}

TEST(Celestial, BothClocksAgreeAboutTheSameInstant)
{
    Environment solar;
    solar.longitude = 14.4f;
    solar.latitude = 50.1f;
    solar.year = 2025;
    solar.dayOfYear = 35;
    solar.time = 9;
    Environment zone = solar;
    zone.clock = Clock::Zone;
    zone.timeZone = 1;
    zone.time = float((julianDate(solar) - julianDate(2025, 35, 0)) * 24 + 1);
    EXPECT_LT(between(towardSun(solar), towardSun(zone)), 0.01);
    EXPECT_LT(between(moonOf(solar).toward, moonOf(zone).toward), 0.01);
    EXPECT_GT(std::abs(zone.time - solar.time), 0.2); // 14 minutes of the equation of time
}

// Meeus, example 47.a: 12 April 1992, 0 h. The short series is good to 0.3 degrees.
TEST(Celestial, MoonElementsAreThoseOfMeeus)
{
    const MoonElements moon = moonElements(2448724.5);
    EXPECT_NEAR(moon.longitude, 133.162655, 0.3);
    EXPECT_NEAR(moon.latitude, -3.229126, 0.2);
    EXPECT_NEAR(moon.parallax, 0.991990, 0.01);
}

// Phases of 2024 as the observatory lists them.
TEST(Celestial, MoonHasItsPhases)
{
    const double isNew = moonOf(at(2024, 11, 11 + 57 / 60.0, 0, 50, 0)).phase; // 11 January
    EXPECT_NEAR(isNew - std::round(isNew), 0, 0.005);
    EXPECT_NEAR(moonOf(at(2024, 18, 3 + 53 / 60.0, 0, 50, 0)).phase, 0.25, 0.005);     // first quarter
    EXPECT_NEAR(moonOf(at(2024, 25, 17 + 54 / 60.0, 0, 50, 0)).phase, 0.5, 0.005);     // full
    EXPECT_NEAR(moonOf(at(2024, 33, 23 + 18 / 60.0, 0, 50, 0)).phase, 0.75, 0.005);    // last quarter, 2 February
    const Environment full = at(2024, 25, 17 + 54 / 60.0, 0, 50, 0);
    EXPECT_GT(between(moonOf(full).toward, towardSun(full)), 170);
}

// The eclipse of 8 April 2024 at its greatest, 18:17:18 UT, 25.3 north, 104.1 west: the moon stood before the sun.
TEST(Celestial, MoonStoodBeforeTheSun)
{
    const Environment e = at(2024, 99, 18 + 17.3 / 60, 0, 25.3, -104.1);
    EXPECT_LT(between(moonOf(e).toward, towardSun(e)), 0.4);
}

TEST(Celestial, StarsTurnAroundThePole)
{
    Environment e = at(2025, 100, 22, 0, 49, 0);
    const glm::dvec3 pole{0, std::sin(glm::radians(49.0)), -std::cos(glm::radians(49.0))};
    const glm::dmat3 before = equatorFromWorld(e);
    EXPECT_NEAR((before * pole).z, 1, 1e-9);
    e.time = 23;
    const glm::dmat3 after = equatorFromWorld(e);
    EXPECT_NEAR((after * pole).z, 1, 1e-9);
    const glm::dvec3 east{1, 0, 0};
    EXPECT_NEAR(between(before * east, after * east), 15.041, 0.001); // degrees in an hour
    e.dayOfYear = 101;
    e.time = float(22 - 3.0 / 60 - 55.909 / 3600); // a sidereal day after the first
    EXPECT_LT(between(equatorFromWorld(e) * east, before * east), 0.002);
}

TEST(Celestial, MoonByHandHasThePhaseItIsTold)
{
    Environment e;
    e.sun.mode = SunMode::Manual;
    e.sun.azimuth = 250;
    e.sun.elevation = -15;
    e.moon.mode = SunMode::Manual;
    e.moon.azimuth = 120;
    e.moon.elevation = 40;
    for (const float phase : {0.0f, 0.25f, 0.5f, 0.9f}) {
        e.moon.phase = phase;
        const MoonPlace moon = moonOf(e);
        EXPECT_NEAR(azimuth(moon.toward), 120, 1e-4);
        EXPECT_NEAR(between(moon.litFrom, moon.toward), 180 * (1 - std::abs(1 - 2 * double(phase))), 0.01);
    }
}

} // namespace
} // namespace io
