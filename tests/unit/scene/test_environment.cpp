#include "io/scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace io {
namespace {

double degreesAbove(const glm::dvec3& direction)
{
    return glm::degrees(std::asin(direction.y));
}

TEST(Sun, ByHandFollowsAzimuthAndElevation)
{
    Environment environment;
    environment.sun.mode = SunMode::Manual;
    environment.sun.azimuth = 90;
    environment.sun.elevation = 0;
    EXPECT_NEAR(towardSun(environment).x, 1, 1e-12); // east
    environment.sun.azimuth = 0;
    environment.sun.elevation = 30;
    EXPECT_NEAR(towardSun(environment).z, -std::cos(glm::radians(30.0)), 1e-7); // north
    EXPECT_NEAR(degreesAbove(towardSun(environment)), 30, 1e-5);
}

TEST(Sun, StandsInTheSouthAtNoon)
{
    Environment environment; // 21 June, 49 degrees north
    environment.time = 12;
    const glm::dvec3 sun = towardSun(environment);
    EXPECT_NEAR(sun.x, 0, 1e-9);
    EXPECT_GT(sun.z, 0);
    EXPECT_NEAR(degreesAbove(sun), 90 - 49 + 23.45, 0.05);
}

TEST(Sun, RisesInTheEastAndSetsInTheWest)
{
    Environment environment;
    environment.dayOfYear = 81; // equinox
    environment.time = 6;
    EXPECT_NEAR(towardSun(environment).x, 1, 0.01);
    EXPECT_NEAR(towardSun(environment).y, 0, 0.01);
    environment.time = 18;
    EXPECT_NEAR(towardSun(environment).x, -1, 0.01);
}

TEST(Sun, IsBelowTheHorizonAtMidnightAndInTheNorthAtNoonDownUnder)
{
    Environment environment;
    environment.time = 0;
    EXPECT_LT(towardSun(environment).y, 0);
    environment.time = 12;
    environment.latitude = -35;
    EXPECT_LT(towardSun(environment).z, 0);
}

} // namespace
} // namespace io
