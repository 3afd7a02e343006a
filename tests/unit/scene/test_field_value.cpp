#include "io/scene/field_value.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace io {
namespace {

std::string faultOf(const Status& status)
{
    return status ? "" : status.error().text();
}

TEST(FieldValue, EveryPathCanBeReadAndSetToItself)
{
    Environment environment;
    const std::vector<std::string> paths = fieldPaths(environment);
    EXPECT_NE(std::find(paths.begin(), paths.end(), "sun.azimuth"), paths.end());
    EXPECT_NE(std::find(paths.begin(), paths.end(), "fog.tint"), paths.end());
    for (const std::string& path : paths) {
        const Result<Value> value = getField(environment, path);
        ASSERT_TRUE(value) << path;
        EXPECT_EQ(faultOf(setField(environment, path, *value)), "");
    }
    EXPECT_EQ(environment, Environment{});
}

TEST(FieldValue, FloatsShowTheirShortestDecimal)
{
    EXPECT_EQ(*getField(Environment{}, "fog.density")->asNumber(), 0.00012);
    EXPECT_EQ(*getField(Environment{}, "sun.angular_diameter")->asNumber(), 0.53);
}

TEST(FieldValue, PeopleMayTypeWords)
{
    Environment environment;
    EXPECT_EQ(faultOf(setField(environment, "sun.irradiance", "1, 0.5,2")), "");
    EXPECT_EQ(environment.sun.irradiance, glm::vec3(1, 0.5f, 2));
    EXPECT_EQ(faultOf(setField(environment, "sun.irradiance.g", "3")), "");
    EXPECT_EQ(environment.sun.irradiance.y, 3);
    EXPECT_EQ(faultOf(setField(environment, "sun.mode", "manual")), "");
    EXPECT_EQ(environment.sun.mode, SunMode::Manual);
    EXPECT_EQ(faultOf(setField(environment, "time", "+6.25")), "");
    EXPECT_EQ(environment.time, 6.25f);
    Template thing;
    EXPECT_EQ(faultOf(setField(thing, "cast_shadow", "off")), "");
    EXPECT_FALSE(thing.castShadow);
}

TEST(FieldValue, FaultsNameTheKeyAndWhatIsExpected)
{
    Environment e;
    EXPECT_EQ(faultOf(setField(e, "time", 30)), "time: 30 is outside 0 to 24 h");
    EXPECT_EQ(faultOf(setField(e, "sun.mode", "noon")), "sun.mode: expected time or manual, found \"noon\"");
    EXPECT_EQ(faultOf(setField(e, "shadows.cascades", 2.5)), "shadows.cascades: 2.5 must be a whole number");
    EXPECT_EQ(faultOf(setField(e, "fog.tint", Value::Array{1, 2})),
              "fog.tint: expected 3 numbers in brackets, found a list of 2");
    EXPECT_EQ(faultOf(setField(e, "time", "6,5")), "time: expected a number, found \"6,5\"");
    EXPECT_EQ(faultOf(setField(e, "time", "nan")), "time: must be a finite number");
    EXPECT_EQ(faultOf(setField(e, "time", nullptr)), "time: expected a number, found null");
    EXPECT_EQ(faultOf(setField(e, "sun", 1)), "sun: is a group of keys; name one of them");
    EXPECT_EQ(e, Environment{}); // a fault changes nothing
}

// A planet of radius 0, air that is not there or less than that.
TEST(FieldValue, BadAirIsRefusedByName)
{
    Environment e;
    for (const char* const path : {"sky.planet_radius", "sky.air_depth", "sky.rayleigh_height", "sky.mie_height"}) {
        EXPECT_TRUE(faultOf(setField(e, path, 0)).starts_with(std::string{path} + ": 0 is outside ")) << path;
        EXPECT_EQ(faultOf(setField(e, path, "nan")), std::string{path} + ": must be a finite number");
    }
    for (const char* const path : {"sky.mie_scattering", "sky.mie_extinction", "sky.ground_albedo", "sky.aerial", "sky.stars", "moon.brightness"})
        EXPECT_TRUE(faultOf(setField(e, path, -1)).starts_with(std::string{path} + ": -1 is outside ")) << path;
    EXPECT_NE(faultOf(setField(e, "sky.rayleigh", "1,-1,1")).find("sky.rayleigh"), std::string::npos);
    EXPECT_NE(faultOf(setField(e, "sky.ozone.b", -1)).find("sky.ozone"), std::string::npos);
    EXPECT_NE(faultOf(setField(e, "moon.phase", 1.5)).find("moon.phase"), std::string::npos);
    EXPECT_EQ(e, Environment{});
}

TEST(FieldValue, UnknownKeysNameThoseThatAreNear)
{
    Environment e;
    EXPECT_EQ(faultOf(setField(e, "sun.azimut", 1)), "sun.azimut: unknown key; did you mean sun.azimuth or moon.azimuth?");
    EXPECT_EQ(faultOf(setField(e, "density", 1)), "density: unknown key; did you mean clouds.density or fog.density?");
    EXPECT_EQ(faultOf(setField(e, "entirely.else", 1)), "entirely.else: unknown key");
    EXPECT_FALSE(getField(e, "sun."));
    EXPECT_FALSE(getField(e, ""));
}

TEST(FieldValue, ListsAreReachedByNumber)
{
    Terrain terrain;
    terrain.layers.resize(2);
    EXPECT_EQ(faultOf(setField(terrain, "layers.1.colour", "0,1,0")), "");
    EXPECT_EQ(terrain.layers[1].colour, glm::vec3(0, 1, 0));
    EXPECT_FALSE(setField(terrain, "layers.2.colour", "0,1,0"));
    EXPECT_FALSE(setField(terrain, "layers.x.colour", "0,1,0"));
}

TEST(FieldValue, SectionsBecomeObjects)
{
    const Value value = toValue(Object{});
    ASSERT_NE(value.find("position"), nullptr);
    EXPECT_EQ(value.find("position")->asArray()->size(), 3u);
    EXPECT_EQ(*value.find("parent")->asNumber(), 0);
}

TEST(FieldValue, ClampingMovesToTheNearestEnd)
{
    glm::vec3 tint{1};
    clampToHint(tint, Value::Array{9, -3, 0.5}, Hint{.min = 0, .max = 4});
    EXPECT_EQ(tint, glm::vec3(4, 0, 0.5f));
}

} // namespace
} // namespace io
