// Voices: no more than there may be, the loudest first, and long sounds out of their files.
#include "tests/unit/sound/heard.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using app::Sound;
using tests::SoundWorld;
using tests::tone;

struct Voices : testing::Test, SoundWorld {
    Sound sound{folder, {.voices = 4, .loopback = true}};
};

TEST_F(Voices, AreLimitedAndGoToTheLoudest)
{
    write("sounds/tone.wav", 1, tone);
    write("sounds/loud.wav", 1, [](double s) { return 0.5f * float(std::sin(2 * std::numbers::pi * 1000 * s)); });
    const io::TemplateId faint = addTemplate({.name = "faint", .sound = {.file = "sounds/tone.wav", .volume = 0.001f, .flat = true}});
    for (int i = 0; i < 50; ++i)
        add(faint, {0, 0, 0});
    EXPECT_LT(listen(sound, {}).all(), 0.01);
    EXPECT_EQ(sound.voices(), 4u);
    add(addTemplate({.name = "loud", .sound = {.file = "sounds/loud.wav", .flat = true}}), {0, 0, 0});
    EXPECT_GT(listen(sound, {}).all(), 0.2);
    EXPECT_EQ(sound.voices(), 4u);
}

TEST_F(Voices, OneShotsTakeThePlaceOfTheFaintest)
{
    write("sounds/tone.wav", 1, tone);
    const io::TemplateId faint = addTemplate({.name = "faint", .sound = {.file = "sounds/tone.wav", .volume = 0.001f, .flat = true}});
    for (int i = 0; i < 50; ++i)
        add(faint, {0, 0, 0});
    listen(sound, {});
    for (int i = 0; i < 100; ++i)
        sound.play("sounds/tone.wav", io::SoundGroup::Effects, 0.1f);
    EXPECT_LE(sound.voices(), 4u);
    EXPECT_GT(listen(sound, {}, 0.4, 0.2).all(), 0.05);
    EXPECT_LE(sound.voices(), 4u);
    listen(sound, {}, 3); // and given back
    EXPECT_EQ(sound.voices(), 4u);
}

// How much the process holds, from /proc.
double megabytesHeld()
{
    FILE* const file = std::fopen("/proc/self/statm", "r");
    long pages = 0, resident = 0;
    if (!file || std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
    if (file) std::fclose(file);
    return double(resident) * 4096 / 1e6;
}

TEST_F(Voices, LongSoundsComeOutOfTheirFile)
{
    write("sounds/long.flac", 600, [](double s) { return 0.4f * float(std::sin(2 * std::numbers::pi * 220 * s)); }); // 53 MB whole
    add(addTemplate({.name = "music", .sound = {.file = "sounds/long.flac", .flat = true}}), {0, 0, 0});
    const double before = megabytesHeld();
    EXPECT_NEAR(listen(sound, {}, 6, 4).all(), 0.4 / std::sqrt(2.0), 0.02);
    EXPECT_EQ(sound.streams(), 1u);
    EXPECT_LT(megabytesHeld() - before, 12); // of which what is recorded here takes 2
}

// A wave that fits its length goes on over the end as if there were none.
void expectSmoothLoop(Voices& world, const std::string& file, double seconds, bool streamed)
{
    world.write(file, seconds, [](double s) { return 0.5f * float(std::cos(2 * std::numbers::pi * 100 * s)); });
    const io::TemplateId what = world.addTemplate({.name = "loop", .sound = {.file = file, .flat = true}});
    world.add(what, {0, 0, 0});
    world.listen(world.sound, {}, 1);
    world.listen(world.sound, {}, seconds + 2); // over its end at least once
    EXPECT_EQ(world.sound.streams(), streamed ? 1u : 0u);
    // x(t) + x(t + half a period) is 0 for such a wave, wherever it is whole.
    constexpr std::size_t kHalf = Sound::kLoopbackRate / 200;
    double most = 0, loudest = 0;
    for (std::size_t i = 0; i + kHalf * 2 + 2 < world.last.size(); i += 2) {
        // 220.5 frames are half a period: the mean of both neighbours.
        most = std::max(most, std::abs(world.last[i] + 0.5 * (world.last[i + kHalf * 2] + double(world.last[i + kHalf * 2 + 2]))));
        loudest = std::max(loudest, double(std::abs(world.last[i])));
    }
    EXPECT_GT(loudest, 0.3);
    EXPECT_LT(most, 0.01);
}

TEST_F(Voices, ShortSoundsRepeatWithoutAGap)
{
    expectSmoothLoop(*this, "sounds/short.wav", 2, false);
}

TEST_F(Voices, StreamedSoundsRepeatWithoutAGap)
{
    expectSmoothLoop(*this, "sounds/long.wav", 21, true);
}

TEST_F(Voices, AStreamThatIsCutOffEndsOrBeginsAgain)
{
    write("sounds/cut.wav", 30, tone);
    std::filesystem::resize_file(folder / "sounds/cut.wav", 44 + 88200); // a second of it
    add(addTemplate({.name = "cut", .sound = {.file = "sounds/cut.wav", .flat = true}}), {0, 0, 0});
    listen(sound, {}, 5);
    std::filesystem::resize_file(folder / "sounds/cut.wav", 10); // while it plays
    listen(sound, {}, 5);
    SUCCEED();
}

TEST_F(Voices, AStreamGoesOnAfterAStall)
{
    write("sounds/long.wav", 40, tone);
    add(addTemplate({.name = "music", .sound = {.file = "sounds/long.wav", .flat = true}}), {0, 0, 0});
    listen(sound, {}, 3);
    std::vector<float> stalled(std::size_t(Sound::kLoopbackRate) * 2 * 5); // nobody hands it blocks for five seconds
    sound.render(stalled);
    EXPECT_GT(listen(sound, {}, 1).all(), 0.2);
}

} // namespace
