#include "io/scene/environment_presets.h"
#include "io/scene/fields.h"

#include <cmath>
#include <gtest/gtest.h>

namespace io {
namespace {

// Counts the numbers that lie outside of what their field allows.
struct OutOfRange {
    int count = 0;
    template <class T> void operator()(const char*, const T& value, const Hint& hint)
    {
        if constexpr (requires { fields(*this, value); }) fields(*this, value);
        else if constexpr (std::is_arithmetic_v<T>) count += double(value) < hint.min || double(value) > hint.max;
    }
};

std::array<Preset, enumNames(Preset{}).size()> presets()
{
    std::array<Preset, enumNames(Preset{}).size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = Preset(i);
    return all;
}

double elevation(const Environment& environment)
{
    return glm::degrees(std::asin(towardSun(environment).y));
}

TEST(Presets, KeepThePlaceAndWhatAMachineCanBear)
{
    Environment own;
    own.latitude = -33;
    own.longitude = 151;
    own.dayOfYear = 20;
    own.water = {.on = true, .level = 12};
    own.shadows.cascades = 2;
    own.clouds.seed = 7;
    for (const Preset preset : presets()) {
        const Environment e = withPreset(own, preset);
        EXPECT_EQ(e.latitude, own.latitude);
        EXPECT_EQ(e.longitude, own.longitude);
        EXPECT_EQ(e.dayOfYear, own.dayOfYear);
        EXPECT_TRUE(e.water == own.water);
        EXPECT_TRUE(e.shadows == own.shadows);
        EXPECT_EQ(e.clouds.seed, 7);
        OutOfRange outside;
        fields(outside, e);
        EXPECT_EQ(outside.count, 0) << enumNames(preset)[std::size_t(preset)];
    }
}

TEST(Presets, LooksOfAPersonsOwnHaveTheirShadows)
{
    Environment own, look;
    own.latitude = -33;
    look.shadows.softness = 3;
    look.occlusion.strength = 0.5f;
    const Environment e = withLook(own, look);
    EXPECT_EQ(e.latitude, -33);
    EXPECT_TRUE(e.shadows == look.shadows);
    EXPECT_TRUE(e.occlusion == look.occlusion);
}

TEST(Presets, DifferFromEachOther)
{
    for (const Preset a : presets())
        for (const Preset b : presets())
            EXPECT_EQ(withPreset({}, a) == withPreset({}, b), a == b);
}

TEST(Presets, PlaceTheSunByTheHourWhereTheDayHasOne)
{
    const Environment dawn = withPreset({}, Preset::Dawn), golden = withPreset({}, Preset::GoldenHour), noon = withPreset({}, Preset::Noon);
    EXPECT_EQ(dawn.sun.mode, SunMode::Time);
    EXPECT_NEAR(elevation(dawn), 2.5, 0.01);
    EXPECT_LT(dawn.time, 12);
    EXPECT_NEAR(elevation(golden), 12, 0.01);
    EXPECT_GT(golden.time, 12);
    EXPECT_NEAR(noon.time, 12, 0.05);
    EXPECT_LT(elevation(withPreset({}, Preset::Night)), -10);

    Environment pole;
    pole.latitude = 88;
    const Environment bright = withPreset(pole, Preset::Dawn); // the sun stands high all of that day
    EXPECT_EQ(bright.sun.mode, SunMode::Manual);
    EXPECT_NEAR(elevation(bright), 2.5, 0.01);
}

TEST(Presets, HoursAreThoseOfTheSunsHeight)
{
    Environment environment;
    for (const double latitude : {-50.0, 0.0, 40.0})
        for (const bool rising : {false, true}) {
            environment.latitude = float(latitude);
            const auto hour = hourOf(environment, 10, rising);
            ASSERT_TRUE(hour);
            environment.time = *hour;
            EXPECT_NEAR(elevation(environment), 10, 0.01);
            const double then = elevation(environment);
            environment.time += 0.1f;
            EXPECT_EQ(elevation(environment) > then, rising);
        }
    EXPECT_FALSE(hourOf(environment, 89.9, true));
}

} // namespace
} // namespace io
