#include "io/scene/environment_mix.h"

#include "io/scene/field_value.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace io {
namespace {

// Each field somewhere in its range, which is cut where it has none.
struct Scatter {
    std::mt19937& random;
    double part(double low, double high) { return std::uniform_real_distribution<double>{low, high}(random); }
    template <class T> void operator()(const char*, T& value, const Hint& hint) { set(value, hint); }
    template <class T> void set(T& value, const Hint& hint)
    {
        if constexpr (Section<T>) fields(*this, value);
        else if constexpr (std::is_same_v<T, bool>) value = part(0, 1) < 0.5;
        else if constexpr (NamedEnum<T>) value = T(part(0, double(enumNames(value).size()) - 0.01));
        else if constexpr (GlmVector<T>)
            for (int i = 0; i < VectorTraits<T>::kSize; ++i) set(value[i], hint);
        else value = T(part(std::max(hint.min, -1e6), std::min(hint.max, 1e6)));
    }
};

Environment scattered(unsigned seed)
{
    std::mt19937 random{seed};
    Environment environment;
    Scatter scatter{random};
    fields(scatter, environment);
    return environment;
}

TEST(EnvironmentMix, EndsAreExact)
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Environment a = scattered(seed), b = scattered(seed + 1000);
        EXPECT_EQ(mixed(a, b, 0), a);
        EXPECT_EQ(mixed(a, b, 1), b);
        EXPECT_EQ(mixed(a, b, -3), a);
        EXPECT_EQ(mixed(a, b, 7), b);
        EXPECT_EQ(mixed(a, b, std::numeric_limits<double>::quiet_NaN()), a);
        EXPECT_EQ(mixed(a, a, 0.37), a);
    }
}

// Range and direction of every number of every field: what lies within its range stays there, and what does not turn round
// moves one way only.
TEST(EnvironmentMix, EveryNumberGoesOneWayAndStaysInItsRange)
{
    struct Check {
        const Environment &from, &to, &before, &now;
        void operator()(const std::string& path) const
        {
            const auto number = [&](const Environment& e) { return *readNumber(*getField(e, path), false); };
            const double a = number(from), b = number(to), x0 = number(before), x1 = number(now);
            const double slack = 1e-5 * std::max(std::abs(a), std::abs(b));
            if (a <= b) EXPECT_TRUE(x1 >= x0 - slack && x1 <= b + slack) << path;
            else EXPECT_TRUE(x1 <= x0 + slack && x1 >= b - slack) << path;
        }
    };
    const std::vector<std::string> turning{"time", "longitude", "sun.azimuth", "moon.azimuth", "clouds.direction", "wind.direction"};
    const Environment a = scattered(3), b = scattered(4);
    Environment before = a;
    int numbers = 0;
    for (int step = 1; step <= 40; ++step) {
        const Environment now = mixed(a, b, step / 40.0);
        for (const std::string& path : fieldPaths(now)) {
            const Value value = *getField(now, path);
            Environment again;
            EXPECT_TRUE(setField(again, path, value)) << path; // within its range
            if (!readNumber(value, false) || std::ranges::count(turning, path)) continue;
            Check{a, b, before, now}(path);
            ++numbers;
        }
        before = now;
    }
    EXPECT_GT(numbers, 40 * 50);
}

TEST(EnvironmentMix, DirectionsTurnTheShorterWay)
{
    Environment a, b;
    a.wind.direction = 350, b.wind.direction = 10;
    EXPECT_NEAR(std::remainder(mixed(a, b, 0.25).wind.direction - 355.0, 360), 0, 1e-4);
    EXPECT_NEAR(std::remainder(mixed(a, b, 0.75).wind.direction - 5.0, 360), 0, 1e-4);
    a.longitude = 170, b.longitude = -170;
    EXPECT_NEAR(mixed(a, b, 0.75).longitude, -175, 1e-4);
    a.sun.elevation = -60, b.sun.elevation = 60; // no way round there
    EXPECT_NEAR(mixed(a, b, 0.5).sun.elevation, 0, 1e-4);
}

TEST(EnvironmentMix, HoursGoThroughMidnight)
{
    Environment a, b;
    a.time = 22, b.time = 2;
    EXPECT_NEAR(mixed(a, b, 0.25).time, 23, 1e-4);
    EXPECT_NEAR(mixed(a, b, 0.75).time, 1, 1e-4);
    a.time = 9, b.time = 15;
    EXPECT_NEAR(mixed(a, b, 0.5).time, 12, 1e-4);
}

TEST(EnvironmentMix, DensitiesGrowByFactors)
{
    Environment a, b;
    a.fog.density = 1e-5f, b.fog.density = 1e-3f;
    EXPECT_NEAR(mixed(a, b, 0.5).fog.density, 1e-4, 1e-9);
    a.fog.density = 0; // has no logarithm
    EXPECT_NEAR(mixed(a, b, 0.5).fog.density, 5e-4, 1e-9);
    a.clouds.coverage = 0.2f, b.clouds.coverage = 0.8f;
    EXPECT_NEAR(mixed(a, b, 0.5).clouds.coverage, 0.5, 1e-6);
}

TEST(EnvironmentMix, ChoicesAndNamesChangeAtHalf)
{
    Environment a, b;
    a.shadows.filter = ShadowFilter::Pcf3, b.shadows.filter = ShadowFilter::Pcf7;
    b.water.on = true, b.clouds.seed = 900, b.shadows.resolution = 4096, b.dayOfYear = 182;
    const Environment early = mixed(a, b, 0.49), late = mixed(a, b, 0.5);
    EXPECT_EQ(early.shadows.filter, ShadowFilter::Pcf3);
    EXPECT_EQ(late.shadows.filter, ShadowFilter::Pcf7);
    EXPECT_FALSE(early.water.on);
    EXPECT_TRUE(late.water.on);
    EXPECT_EQ(early.clouds.seed, 0);
    EXPECT_EQ(late.clouds.seed, 900);
    EXPECT_EQ(early.shadows.resolution, 2048);
    EXPECT_EQ(late.shadows.resolution, 4096);
    EXPECT_EQ(late.dayOfYear, 177); // days pass
}

TEST(EnvironmentMix, KeysOfAnotherVersionStayWithTheirFile)
{
    Environment a, b;
    a.extra.add("sun.corona", "3");
    b.extra.add("moon.halo", "true");
    for (const double share : {0.0, 0.3, 1.0})
        EXPECT_EQ(mixed(a, b, share).extra, a.extra) << share;
}

} // namespace
} // namespace io
