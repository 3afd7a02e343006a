#include "app/sound/sound_sources.h"
#include "app/sound/wind_sound.h"
#include "io/scene/instances.h"

#include <gtest/gtest.h>

namespace {

TEST(SoundSources, LevelsLieOnStraightLinesBetweenKeys)
{
    const io::SoundSource source{.radius = 10, .falloff = {{0.2f, 1}, {0.6f, 0.5f}}};
    EXPECT_FLOAT_EQ(app::levelAt(source, 0), 1);
    EXPECT_FLOAT_EQ(app::levelAt(source, 4), 0.75f);
    EXPECT_FLOAT_EQ(app::levelAt(source, 8), 0.5f);
    EXPECT_FLOAT_EQ(app::levelAt(source, 10), 0); // whatever the last key says
    EXPECT_FLOAT_EQ(app::levelAt({.radius = 10, .falloff = {{1, 0}, {0, 1}}}, 5), 0.5f); // in disorder
    EXPECT_FLOAT_EQ(app::levelAt({.radius = 10, .falloff = {{0.5f, 1}, {0.5f, 0}}}, 7), 0);
    EXPECT_FLOAT_EQ(app::levelAt({.radius = 10}, 5), 0.25f);
    EXPECT_EQ(app::levelAt({.radius = 10}, std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(SoundSources, HoursAndWeather)
{
    io::Environment now;
    now.time = 24; // midnight
    EXPECT_TRUE(app::heardAt({}, now));
    EXPECT_TRUE(app::heardAt({.hours = {22, 4}}, now));
    EXPECT_FALSE(app::heardAt({.hours = {4, 22}}, now));
    now.time = 4;
    EXPECT_FALSE(app::heardAt({.hours = {22, 4}}, now));
    EXPECT_TRUE(app::heardAt({.hours = {4, 22}}, now));
    EXPECT_TRUE(app::heardAt({.weather = io::SoundWeather::Dry}, now));
    EXPECT_FALSE(app::heardAt({.weather = io::SoundWeather::Wet}, now));
    now.weather.snow = 0.1f;
    EXPECT_FALSE(app::heardAt({.weather = io::SoundWeather::Dry}, now));
    EXPECT_TRUE(app::heardAt({.weather = io::SoundWeather::Wet}, now));
    now.wind.speed = 13;
    EXPECT_TRUE(app::heardAt({.weather = io::SoundWeather::Storm}, now));
}

TEST(SoundSources, KeepsOnlyWhatSoundsAndFollowsIt)
{
    io::Scene scene;
    const io::TemplateId rock = scene.templateSlot("rock"), fire = scene.templateSlot("fire");
    scene.exchange(rock, io::Template{.name = "rock"});
    scene.exchange(fire, io::Template{.name = "fire", .sound = {.file = "sounds/fire.ogg"}});
    std::vector<io::ObjectId> ids;
    for (int i = 0; i < 10; ++i) {
        ids.push_back(scene.freshId());
        scene.exchange(ids.back(), io::Object{.id = ids.back(), .templateId = i % 2 ? rock : fire, .transform = {.position = {double(i), 0, 0}}});
    }
    app::SoundSources sources;
    sources.follow(scene, {});
    EXPECT_EQ(sources.places().size(), 5u);
    scene.exchange(ids[0], std::nullopt);
    sources.follow(scene, {.objects = {ids[0], ids[0]}});
    EXPECT_EQ(sources.places().size(), 4u);
    for (const app::SoundSources::Place& place : sources.places())
        EXPECT_EQ(place.at.x, scene.at(place.object).transform.position.x);
    scene.exchange(rock, io::Template{.name = "rock", .sound = {.file = "sounds/hum.ogg"}});
    sources.follow(scene, {.templates = {rock}});
    EXPECT_EQ(sources.places().size(), 9u);
    scene.exchange(fire, std::nullopt);
    sources.follow(scene, {.templates = {fire}});
    EXPECT_EQ(sources.places().size(), 5u);
}

TEST(SoundSources, PlantedCopiesSoundToo)
{
    io::Scene scene;
    const io::TemplateId reed = scene.templateSlot("reed");
    scene.exchange(reed, io::Template{.name = "reed", .sound = {.file = "sounds/frogs.ogg", .radius = 8}});
    const io::ScatterId layer{1};
    scene.exchange(std::vector<io::ScatterLayer>{{.id = layer, .name = "shore", .species = {{.templateName = "reed"}}}});
    const auto plant = [&](int count) {
        std::vector<io::Instance> instances;
        for (int i = 0; i < count; ++i)
            instances.push_back(io::instanceAt({.position = {double(i), 2, 3}}, 0).instance);
        scene.exchange(io::LayerTile{layer, {0, 0}}, std::make_shared<const io::InstanceTile>(io::InstanceTile{.instances = instances}));
    };
    plant(4);
    app::SoundSources sources;
    sources.follow(scene, {});
    ASSERT_EQ(sources.places().size(), 4u);
    EXPECT_NEAR(sources.places()[3].at.x, 3, 1e-3);
    EXPECT_EQ(sources.places()[3].what, reed);
    EXPECT_EQ(sources.places()[3].radius, 8);
    plant(2);
    sources.follow(scene, {.instances = {{layer, {0, 0}}}});
    EXPECT_EQ(sources.places().size(), 2u);
    const io::ObjectId object = scene.freshId();
    scene.exchange(object, io::Object{.id = object, .templateId = reed});
    sources.follow(scene, {.objects = {object}});
    EXPECT_EQ(sources.places().size(), 3u);
    scene.exchange(object, std::nullopt);
    sources.follow(scene, {.objects = {object}});
    EXPECT_EQ(sources.places().size(), 2u);
}

TEST(WindSound, GrowsWithSpeedHeightAndStorm)
{
    const io::Scene scene;
    io::Environment now;
    now.wind.gustiness = 0;
    const auto level = [&](float speed, double height, float rain) {
        io::Scene land;
        land.exchange(std::make_shared<const io::HeightMap>(io::HeightMap{[] {
            io::HeightGrid grid;
            grid.size = {401, 401};
            grid.origin = {-200, -200};
            grid.metres.assign(401 * 401, 0.0f);
            return grid;
        }()}));
        now.wind.speed = speed;
        now.weather.rain = rain;
        return app::windAt(land, now, {0, height, 0}, 5).level;
    };
    EXPECT_EQ(level(0, 2, 0), 0);
    EXPECT_GT(level(6, 2, 0), level(3, 2, 0));
    EXPECT_GT(level(6, 80, 0), 1.3f * level(6, 2, 0));
    EXPECT_GT(level(14, 2, 5), 1.3f * level(14, 2, 0));
    EXPECT_LE(level(60, 1000, 50), 1);
}

} // namespace
