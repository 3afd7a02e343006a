#include "app/sound/sound_check.h"
#include "app/sound/sound_file.h"
#include "io/base/random.h"
#include "tests/unit/sound/heard.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sndfile.h>
#include <sys/stat.h>

namespace {

using app::SoundFile;
using tests::SoundWorld;
using tests::tone;

struct Files : testing::Test, SoundWorld {
    std::filesystem::path path(const std::string& file) const { return folder / "sounds" / file; }
    std::string fault(const std::string& file) const
    {
        io::Result<SoundFile> opened = SoundFile::open(path(file));
        if (!opened) {
            EXPECT_EQ(opened.error().where, path(file).string());
            return opened.error().what;
        }
        const auto clip = app::readClip(*opened, file, 1);
        return clip ? "" : clip.error().what;
    }
};

TEST_F(Files, EachFormatIsRead)
{
    for (const char* file : {"a.wav", "a.flac", "a.ogg"}) {
        write(std::string{"sounds/"} + file, 1.5, tone);
        io::Result<SoundFile> opened = SoundFile::open(path(file));
        ASSERT_TRUE(opened) << file;
        EXPECT_EQ(opened->format().frames, 66150) << file;
        const auto clip = app::readClip(*opened, file, 1);
        ASSERT_TRUE(clip);
        ASSERT_EQ(clip->frames(), 66150u);
        for (std::size_t i = 0; i < 66150; i += 997)
            EXPECT_NEAR(clip->samples[i] / 32767.0, tone(double(i) / 44100), 0.03) << file << " " << i;
    }
}

TEST_F(Files, ChannelsAreMixedAndSpread)
{
    SF_INFO info{.samplerate = 8000, .channels = 2, .format = SF_FORMAT_WAV | SF_FORMAT_FLOAT};
    SNDFILE* const out = sf_open(path("stereo.wav").c_str(), SFM_WRITE, &info);
    const float samples[] = {0.5f, 0.1f, 2.0f, 2.0f, -9, -9, NAN, NAN, INFINITY, INFINITY};
    sf_writef_float(out, samples, 5);
    sf_close(out);
    io::Result<SoundFile> file = SoundFile::open(path("stereo.wav"));
    const auto mono = app::readClip(*file, "stereo.wav", 1);
    const std::vector<std::int16_t> expected{9830, 32767, -32767, 0, 32767};
    EXPECT_EQ(mono->samples, expected);
    file->seek(0);
    const auto stereo = app::readClip(*file, "stereo.wav", 2);
    EXPECT_EQ(stereo->samples[0], 16384);
    EXPECT_EQ(stereo->samples[1], 3277);
}

TEST_F(Files, SayWhatIsWrong)
{
    writeText("sounds/text.ogg", "not a sound");
    writeText("sounds/none.wav", "");
    EXPECT_NE(fault("text.ogg").find("is no WAV, OGG or FLAC sound"), std::string::npos) << fault("text.ogg");
    EXPECT_NE(fault("none.wav").find("is no WAV, OGG or FLAC sound"), std::string::npos) << fault("none.wav");
    EXPECT_EQ(fault("missing.wav"), "does not exist");
    std::filesystem::create_directory(path("folder.ogg"));
    EXPECT_EQ(fault("folder.ogg"), "is no file");
    ASSERT_EQ(mkfifo(path("pipe.ogg").c_str(), 0600), 0);
    EXPECT_EQ(fault("pipe.ogg"), "is no file"); // and nobody waits for what comes through it

    SF_INFO info{.samplerate = 8000, .channels = 1, .format = SF_FORMAT_AIFF | SF_FORMAT_PCM_16};
    SNDFILE* out = sf_open(path("other.wav").c_str(), SFM_WRITE, &info);
    const short sample = 1;
    sf_writef_short(out, &sample, 1);
    sf_close(out);
    EXPECT_EQ(fault("other.wav"), "is a sound, but no WAV, OGG or FLAC; convert it");

    info = {.samplerate = 8000, .channels = 20, .format = SF_FORMAT_WAV | SF_FORMAT_PCM_16};
    out = sf_open(path("many.wav").c_str(), SFM_WRITE, &info);
    const short frame[20] = {};
    sf_writef_short(out, frame, 1);
    sf_close(out);
    EXPECT_NE(fault("many.wav").find("20 channels"), std::string::npos);

    write("sounds/slow.wav", 1, tone, 900);
    EXPECT_NE(fault("slow.wav").find("900 samples a second"), std::string::npos);
    write("sounds/empty.wav", 0, tone);
    EXPECT_EQ(fault("empty.wav"), "holds no sound");
}

TEST_F(Files, AHeaderThatPromisesMuchHoldsNoMemory)
{
    write("sounds/liar.wav", 1, tone);
    std::fstream file{path("liar.wav"), std::ios::in | std::ios::out | std::ios::binary};
    const unsigned char huge[4] = {0xf0, 0xff, 0xff, 0x7f};
    file.seekp(4).write(reinterpret_cast<const char*>(huge), 4);
    file.seekp(40).write(reinterpret_cast<const char*>(huge), 4);
    file.close();
    io::Result<SoundFile> opened = SoundFile::open(path("liar.wav"));
    if (opened) {
        const auto clip = app::readClip(*opened, "liar.wav", 1);
        EXPECT_TRUE(!clip || clip->frames() <= 44100u);
    }
}

// Whatever the bytes, it is an error or a sound; the sanitizers watch.
TEST_F(Files, DamagedFilesDoNoHarm)
{
    io::Random random{7};
    for (const char* name : {"a.wav", "a.flac", "a.ogg"}) {
        write(std::string{"sounds/"} + name, 0.3, tone, 8000);
        std::ifstream in{path(name), std::ios::binary};
        const std::string whole{std::istreambuf_iterator<char>{in}, {}};
        for (int round = 0; round < 300; ++round) {
            std::string bytes = whole;
            if (round % 3 == 0) bytes.resize(std::size_t(random.below(int(bytes.size()))));
            const int changes = round % 3 == 0 ? 0 : 1 + random.below(12);
            for (int i = 0; i < changes; ++i) // headers more often than not
                bytes[std::size_t(random.below(int(random.chance(0.7f) ? std::min<std::size_t>(bytes.size(), 100) : bytes.size())))] = char(random.next());
            writeText(std::string{"sounds/hurt_"} + name, bytes);
            const std::string said = fault(std::string{"hurt_"} + name);
            EXPECT_LT(said.size(), 300u) << said;
        }
    }
}

TEST(SoundClip, IsSplitAtSilence)
{
    app::SoundClip clip{.channels = 1, .rate = 1000};
    const auto add = [&](int count, std::int16_t value) { clip.samples.insert(clip.samples.end(), std::size_t(count), value); };
    add(300, 0);
    add(50, 5000);
    add(100, 3); // too short to part them
    add(50, -5000);
    add(200, 0);
    add(70, 4000);
    const std::vector<app::SoundClip> parts = app::splitAtSilence(clip);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].frames(), 200u);
    EXPECT_EQ(parts[1].frames(), 70u);
    EXPECT_TRUE(app::splitAtSilence({.channels = 1, .rate = 1000, .samples = {0, 0, 0}}).empty());
}

TEST_F(Files, ASceneIsChecked)
{
    write("sounds/fire.wav", 0.2, tone);
    writeText("sounds/text.ogg", "not a sound");
    std::filesystem::create_directory(folder / "templates");
    writeText("templates/fire.json", "{\n\"sound\": 1,\n\"what\": \"sounds/gone.ogg\"\n}\n");
    io::Template what{.name = "fire", .sound = {.file = "sounds/fire.wav"}};
    what.trigger.actions = {{.action = io::TriggerDo::PlaySound, .what = "sounds/gone.ogg"}, {.action = io::TriggerDo::Message, .what = "hello"}};
    addTemplate(what);
    scene.exchange(io::Terrain{.layers = {{.name = "Meadow", .steps = "sounds/text.ogg"}}});
    io::Complaints complaints;
    app::checkSounds(scene, folder, "scenes/main.scene.json", complaints);
    ASSERT_EQ(complaints.size(), 2u);
    EXPECT_EQ(complaints[0].where, (folder / "templates/fire.json").string() + ":3");
    EXPECT_TRUE(complaints[0].what.starts_with("trigger.actions: sounds/gone.ogg: ")) << complaints[0].what;
    EXPECT_EQ(complaints[1].where, (folder / "scenes/main.scene.json").string() + ":1");
    EXPECT_TRUE(complaints[1].what.starts_with("terrain.layers: sounds/text.ogg: ")) << complaints[1].what;
}

} // namespace
