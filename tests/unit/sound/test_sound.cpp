// What comes out of the loopback device.
#include "tests/unit/sound/heard.h"

#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using app::Sound;
using tests::decibels;
using tests::Loudness;
using tests::SoundWorld;
using tests::tone;

class Heard : public testing::Test, public SoundWorld {
protected:
    Heard()
    {
        write("sounds/tone.wav", 1, tone);
        Sound made{folder, {.voices = 8, .loopback = true}};
        sound.emplace(std::move(made));
    }
    io::TemplateId source(const io::SoundSource& source)
    {
        return addTemplate({.name = "source" + std::to_string(scene.templates().size()), .sound = source});
    }
    std::optional<Sound> sound;
};

TEST_F(Heard, FallsWithDistanceAsTheCurveSays)
{
    const io::TemplateId what = source({.file = "sounds/tone.wav", .radius = 40, .falloff = {{0, 1}, {0.25f, 0.5f}, {1, 0}}});
    add(what, {0, 0, 0});
    const double near = listen(*sound, {.ear = {0, 0, 2}}).all(); // at 0.05 of the radius: 0.9
    ASSERT_GT(near, 0.05);
    for (const auto& [metres, level] : {std::pair{5.0, 0.75}, {10.0, 0.5}, {25.0, 0.25}, {37.0, 0.05}})
        EXPECT_NEAR(listen(*sound, {.ear = {0, 0, metres}}).all() / near, level / 0.9, 0.02) << metres << " m";
}

TEST_F(Heard, WithoutKeysTheCurveIsTheSquareOfWhatIsLeft)
{
    add(source({.file = "sounds/tone.wav", .radius = 20}), {0, 0, 0});
    const double near = listen(*sound, {.ear = {0, 0, 2}}).all();
    EXPECT_NEAR(listen(*sound, {.ear = {0, 0, 10}}).all() / near, 0.25 / 0.81, 0.01);
}

TEST_F(Heard, IsSilentOutsideItsRadius)
{
    add(source({.file = "sounds/tone.wav", .radius = 12}), {1000, 50, -3000});
    EXPECT_GT(listen(*sound, {.ear = {1000, 50, -2995}}).all(), 0.05);
    EXPECT_EQ(listen(*sound, {.ear = {1000, 50, -2987.9}}).all(), 0);
    EXPECT_EQ(sound->voices(), 0u);
}

TEST_F(Heard, ComesFromTheSideThatTheListenerTurnsToIt)
{
    add(source({.file = "sounds/tone.wav", .radius = 40}), {5, 0, 0}); // east
    const Loudness north = listen(*sound, {.ear = {0, 0, 0}, .yaw = 0});
    EXPECT_GT(decibels(north.right, north.left), 12);
    const Loudness south = listen(*sound, {.ear = {0, 0, 0}, .yaw = 180});
    EXPECT_GT(decibels(south.left, south.right), 12);
    const Loudness east = listen(*sound, {.ear = {0, 0, 0}, .yaw = -90});
    EXPECT_NEAR(decibels(east.left, east.right), 0, 0.5);
    const Loudness half = listen(*sound, {.ear = {5, 0, 5}, .yaw = 90}); // it lies north, and one looks west
    EXPECT_GT(decibels(half.right, half.left), 12);
    const Loudness above = listen(*sound, {.ear = {5, 0, 5}, .yaw = -90, .pitch = 60});
    EXPECT_GT(decibels(above.left, above.right), 12);
    const Loudness between = listen(*sound, {.ear = {0, 0, 0}, .yaw = -60});
    EXPECT_GT(decibels(between.right, between.left), 1);
    EXPECT_LT(decibels(between.right, between.left), decibels(north.right, north.left));
}

TEST_F(Heard, IsWhereItsOffsetPutsItOnATurnedCopy)
{
    const io::ObjectId id = add(source({.file = "sounds/tone.wav", .radius = 40, .offset = {0, 0, -5}}), {0, 0, 0});
    io::Object turned = scene.at(id);
    turned.transform.rotation.y = -90; // its -Z is east
    scene.exchange(id, turned);
    const Loudness heard = listen(*sound, {.ear = {0, 0, 0}});
    EXPECT_GT(decibels(heard.right, heard.left), 12);
}

TEST_F(Heard, FlatSoundsHaveNoDirection)
{
    add(source({.file = "sounds/tone.wav", .radius = 40, .falloff = {{0, 1}}, .flat = true}), {5, 0, 0});
    const Loudness flat = listen(*sound, {.ear = {0, 0, 0}});
    EXPECT_NEAR(flat.left, flat.right, 1e-4);
    EXPECT_GT(flat.all(), 0.1);
}

TEST_F(Heard, WhatStandsInTheWayMufflesIt)
{
    write("sounds/hiss.wav", 1, [](double s) { return 0.3f * float(std::sin(2 * std::numbers::pi * 9000 * s)); });
    const io::TemplateId low = source({.file = "sounds/tone.wav", .radius = 40});
    add(low, {0, 0, -5});
    const io::TemplateId high = source({.file = "sounds/hiss.wav", .radius = 40});
    const double open = listen(*sound, {}).all();
    bool wall = true;
    io::ObjectId asked = io::ObjectId::None;
    sound->setBlocked([&](const glm::dvec3& ear, const glm::dvec3& place, io::ObjectId object) {
        asked = object;
        EXPECT_EQ(ear, glm::dvec3(0));
        EXPECT_NEAR(place.z, -4.7, 0.01); // not quite to it
        return wall;
    });
    const double muffled = listen(*sound, {}).all();
    EXPECT_EQ(asked, io::ObjectId{1});
    EXPECT_NEAR(muffled / open, 0.4, 0.05);
    edit(low, [](io::Template& t) { t.sound.occluded = false; });
    EXPECT_NEAR(listen(*sound, {}).all() / open, 1, 0.02);

    edit(low, [](io::Template& t) { t.sound.volume = 0; });
    add(high, {0, 0, -5});
    const double muffledHiss = listen(*sound, {}).all();
    wall = false;
    EXPECT_LT(muffledHiss / listen(*sound, {}).all(), 0.2); // treble goes first
}

TEST_F(Heard, HoursGoOverMidnight)
{
    add(source({.file = "sounds/tone.wav", .flat = true, .hours = {21, 5}}), {0, 0, 0});
    for (const auto& [hour, heard] : {std::pair{22.0f, true}, {23.9f, true}, {4.5f, true}, {5.5f, false}, {12.0f, false}}) {
        setEnvironment([&](io::Environment& e) { e.time = hour; });
        EXPECT_EQ(listen(*sound, {}).all() > 0.05, heard) << hour;
    }
}

TEST_F(Heard, WeatherChooses)
{
    add(source({.file = "sounds/tone.wav", .flat = true, .weather = io::SoundWeather::Storm}), {0, 0, 0});
    EXPECT_EQ(listen(*sound, {}).all(), 0);
    setEnvironment([](io::Environment& e) {
        e.weather.rain = 4;
        e.wind.speed = 15;
    });
    EXPECT_GT(listen(*sound, {}).all(), 0.05);
    setEnvironment([](io::Environment& e) { e.wind.speed = 5; });
    EXPECT_LT(listen(*sound, {}).all(), 1e-4);
}

TEST_F(Heard, GroupsHaveVolumes)
{
    add(source({.file = "sounds/tone.wav", .group = io::SoundGroup::Music, .flat = true}), {0, 0, 0});
    const double full = listen(*sound, {}, 4).all();
    sound->setVolume(io::SoundGroup::Music, 0.25f);
    EXPECT_NEAR(listen(*sound, {}).all() / full, 0.25, 0.005);
    sound->setVolume(io::SoundGroup::Effects, 0);
    EXPECT_NEAR(listen(*sound, {}).all() / full, 0.25, 0.005);
    sound->setMasterVolume(0);
    EXPECT_LT(listen(*sound, {}).all(), 1e-4);
}

TEST_F(Heard, AVolumeAboveOneIsLouder)
{
    const io::TemplateId what = source({.file = "sounds/tone.wav", .volume = 0.25f, .flat = true});
    add(what, {0, 0, 0});
    const double soft = listen(*sound, {}).all();
    edit(what, [](io::Template& t) { t.sound.volume = 2; });
    EXPECT_NEAR(listen(*sound, {}).all() / soft, 8, 0.1);
}

// The largest step from one sample to the next: a click is a step.
double largestStep(const std::vector<float>& stereo)
{
    double most = 0;
    for (std::size_t i = 2; i < stereo.size(); ++i)
        most = std::max(most, double(std::abs(stereo[i] - stereo[i - 2])));
    return most;
}

TEST_F(Heard, BeginsStopsAndRepeatsWithoutAClick)
{
    write("sounds/low.wav", 1, [](double s) { return 0.5f * float(std::cos(2 * std::numbers::pi * 60 * s)); });
    const io::TemplateId what = source({.file = "sounds/low.wav", .flat = true});
    const io::ObjectId id = add(what, {0, 0, 0});
    const double smooth = 0.5 * 2 * std::numbers::pi * 60 / Sound::kLoopbackRate; // of the wave itself
    EXPECT_GT(listen(*sound, {}).all(), 0.1); // two and a half rounds
    EXPECT_LT(largestStep(last), 2 * smooth);
    remove(id);
    EXPECT_LT(listen(*sound, {}).all(), 1e-6);
    EXPECT_LT(largestStep(last), 2 * smooth);
}

TEST_F(Heard, FollowsMovesAndEdits)
{
    const io::TemplateId what = source({.file = "sounds/tone.wav", .radius = 10});
    const io::ObjectId id = add(what, {0, 0, -3});
    EXPECT_GT(listen(*sound, {}).all(), 0.05);
    move(id, {0, 0, -30});
    EXPECT_LT(listen(*sound, {}).all(), 1e-6);
    edit(what, [](io::Template& t) { t.sound.radius = 100; });
    EXPECT_GT(listen(*sound, {}).all(), 0.05);
    edit(what, [](io::Template& t) { t.sound.file.clear(); });
    EXPECT_LT(listen(*sound, {}).all(), 1e-6);
}

TEST_F(Heard, PausesAndGoesOn)
{
    add(source({.file = "sounds/tone.wav", .flat = true}), {0, 0, 0});
    const double playing = listen(*sound, {}).all();
    sound->pause(true);
    EXPECT_EQ(listen(*sound, {}).all(), 0);
    sound->pause(false);
    EXPECT_NEAR(listen(*sound, {}).all(), playing, 1e-3);
}

TEST_F(Heard, PlaysOnce)
{
    listen(*sound, {});
    sound->play("sounds/tone.wav");
    EXPECT_GT(listen(*sound, {}, 0.5).all(), 0.1);
    EXPECT_EQ(listen(*sound, {}, 1.5).all(), 0);
    EXPECT_EQ(sound->voices(), 0u);
    sound->play("sounds/tone.wav", {-5, 0, 0}, 40);
    const Loudness west = listen(*sound, {}, 0.5);
    EXPECT_GT(decibels(west.left, west.right), 12);
}

TEST_F(Heard, ASourceThatDoesNotRepeatSoundsOnceForEachVisit)
{
    add(source({.file = "sounds/tone.wav", .radius = 10, .loop = false}), {0, 0, 0});
    EXPECT_GT(listen(*sound, {.ear = {0, 0, 3}}, 0.6).all(), 0.05);
    EXPECT_EQ(listen(*sound, {.ear = {0, 0, 3}}).all(), 0);
    listen(*sound, {.ear = {0, 0, 30}});
    EXPECT_GT(listen(*sound, {.ear = {0, 0, 3}}, 0.6).all(), 0.05);
}

TEST_F(Heard, StepsSoundAsOneWalks)
{
    write("sounds/step.wav", 0.1, tone);
    const io::TemplateId plank = addTemplate({.name = "plank", .steps = "sounds/step.wav"});
    int steps = 0;
    for (int i = 0; i < 250; ++i) { // 5 s at 2 m/s
        sound->walk(scene, {.at = {0, -1.7, 0}, .walked = 0.04, .speed = 2, .on = plank});
        const std::size_t before = sound->voices();
        listen(*sound, {}, 0.02);
        steps += before > 0 && last.size() > 2 && sound->voices() > 0;
    }
    EXPECT_GT(steps, 20); // pictures with a step in them
    EXPECT_LT(steps, 100);
}

TEST_F(Heard, TheWindIsLouderInAStormAndHighUp)
{
    write("sounds/wind.wav", 2, tone);
    sound->forgetFiles();
    const double calm = listen(*sound, {.ear = {0, 1.7, 0}}, 4, 3).all();
    setEnvironment([](io::Environment& e) {
        e.wind.speed = 16;
        e.weather.rain = 5;
    });
    const double storm = listen(*sound, {.ear = {0, 1.7, 0}}, 4, 3).all();
    EXPECT_GT(calm, 0.001);
    EXPECT_GT(decibels(storm, calm), 12);
    setEnvironment([](io::Environment& e) { e.wind.speed = 0; });
    EXPECT_LT(listen(*sound, {}, 4, 1).all(), 1e-3);
}

TEST_F(Heard, AHundredThousandSourcesCostLittle)
{
    const io::TemplateId what = source({.file = "sounds/tone.wav", .radius = 15});
    for (int i = 0; i < 100000; ++i)
        add(what, {double(i % 400) * 5, 0, double(i / 400) * 5});
    const app::Listener listener{.ear = {1000, 1, 600}};
    listen(*sound, listener, 0.5);
    EXPECT_EQ(sound->voices(), 8u);
    const io::Changes none;
    const auto begun = std::chrono::steady_clock::now();
    for (int i = 0; i < 200; ++i)
        sound->update({.scene = scene, .changes = none, .listener = listener, .seconds = 0.016});
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
    RecordProperty("ms_per_update", std::to_string(took.count() / 200));
    std::printf("update of 100,000 sources: %.3f ms\n", took.count() / 200);
    EXPECT_LT(took.count() / 200, 2); // a machine under load included
}

TEST(NoDevice, IsSilentAndSaysSoOnce)
{
    SoundWorld world;
    world.write("sounds/tone.wav", 1, tone);
    const io::TemplateId what = world.addTemplate({.name = "fire", .sound = {.file = "sounds/tone.wav", .flat = true}});
    world.add(what, {0, 0, 0});
    Sound sound{world.folder, {.device = "no device has this name"}};
    EXPECT_FALSE(sound.on());
    EXPECT_EQ(world.listen(sound, {}).all(), 0);
    sound.play("sounds/tone.wav");
    sound.play("sounds/tone.wav", {1, 2, 3}, 10);
    sound.walk(world.scene, {.walked = 10});
    sound.setVolume(io::SoundGroup::Music, 1);
    sound.pause(true);
    sound.forgetFiles();
    world.listen(sound, {});
    const io::Complaints notices = sound.takeNotices();
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_NE(notices[0].what.find("no device has this name"), std::string::npos);
    EXPECT_TRUE(sound.takeNotices().empty());
}

TEST_F(Heard, ASoundThatIsNoneIsSaidOnce)
{
    writeText("sounds/text.ogg", "this is no sound at all\n");
    const io::TemplateId broken = source({.file = "sounds/text.ogg", .radius = 100});
    for (int i = 0; i < 5; ++i)
        add(broken, {double(i), 0, 0});
    add(source({.file = "sounds/missing.ogg", .radius = 100}), {0, 0, 0});
    add(source({.file = "../outside.ogg", .radius = 100}), {0, 0, 0});
    add(source({.file = "sounds/tone.wav", .flat = true}), {0, 0, 0});
    EXPECT_GT(listen(*sound, {}).all(), 0.05); // the others go on
    sound->play("sounds/text.ogg");
    const io::Complaints notices = sound->takeNotices();
    ASSERT_EQ(notices.size(), 3u);
    for (const io::Complaint& notice : notices) {
        if (notice.where == "sounds/text.ogg") {
            EXPECT_NE(notice.what.find("is no WAV, OGG or FLAC sound"), std::string::npos) << notice.what;
        } else if (notice.where == "sounds/missing.ogg") {
            EXPECT_EQ(notice.what, "does not exist");
        }
    }
    listen(*sound, {});
    EXPECT_TRUE(sound->takeNotices().empty());
}

} // namespace
