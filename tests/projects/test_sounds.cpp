// The sounds that ship, by numbers: how strong, how bright, whether they repeat without a seam.
#include "projects/make/sounds.h"

#include "io/files/atomic_file.h"
#include "tests/projects/shipped.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <sndfile.h>

namespace {

make::Wave committed(std::string_view name)
{
    SF_INFO info{};
    const std::string file = std::string{WOLD_SOURCE_DIR} + "/projects/valley/sounds/" + std::string{name} + ".ogg";
    SNDFILE* const in = sf_open(file.c_str(), SFM_READ, &info);
    if (!in) return {};
    make::Wave wave{info.samplerate, std::vector<float>(std::size_t(info.frames))};
    EXPECT_EQ(info.channels, 1);
    EXPECT_EQ(sf_readf_float(in, wave.samples.data(), info.frames), info.frames);
    sf_close(in);
    return wave;
}

double rms(const make::Wave& wave)
{
    double sum = 0;
    for (const float sample : wave.samples)
        sum += double(sample) * sample;
    return std::sqrt(sum / double(wave.samples.size()));
}

// The root mean square of its frequencies by their power, from the power of its slope: Hz.
double middleOf(const make::Wave& wave)
{
    double power = 0, slope = 0;
    for (std::size_t i = 1; i < wave.samples.size(); ++i) {
        power += double(wave.samples[i]) * wave.samples[i];
        slope += std::pow(double(wave.samples[i]) - wave.samples[i - 1], 2);
    }
    return std::sqrt(slope / power) * wave.rate / (2 * std::numbers::pi);
}

TEST(Sounds, AreWhatTheToolMakes)
{
    for (const make::SoundPlan& plan : make::soundPlans()) {
        const make::Wave made = plan.make(), file = committed(plan.name);
        ASSERT_EQ(made.samples.size(), file.samples.size()) << plan.name << ": run wold-make-worlds projects valley";
        EXPECT_EQ(made.rate, file.rate) << plan.name;
        double both = 0;
        for (std::size_t i = 0; i < made.samples.size(); ++i)
            both += double(made.samples[i]) * file.samples[i];
        // Vorbis keeps what is heard, of noise little more than its spectrum.
        EXPECT_GT(both / (rms(made) * rms(file) * double(made.samples.size())), 0.6) << plan.name;
        EXPECT_NEAR(rms(file) / rms(made), 1, 0.2) << plan.name;
        std::printf("%-13s %5.2f s  peak %.2f  rms %.3f  middle %5.0f Hz\n", std::string{plan.name}.c_str(), file.seconds(), file.peak(), rms(file), middleOf(file));
    }
}

TEST(Sounds, AreTheSameBytesEveryTime)
{
    const make::Wave wave = make::makeWoodSteps();
    const io::Result<std::string> first = make::encodeOgg(wave, 0.1), second = make::encodeOgg(wave, 0.1);
    ASSERT_TRUE(first && second);
    EXPECT_TRUE(*first == *second);
}

TEST(Sounds, AreNeitherTooStrongNorTooFaint)
{
    for (const make::SoundPlan& plan : make::soundPlans()) {
        const make::Wave file = committed(plan.name);
        EXPECT_LT(file.peak(), 0.9f) << plan.name;
        EXPECT_GT(file.peak(), 0.5f) << plan.name;
        EXPECT_GT(rms(file), 0.02) << plan.name;
        double mean = 0;
        for (const float sample : file.samples)
            mean += sample;
        EXPECT_NEAR(mean / double(file.samples.size()), 0, 0.005) << plan.name;
    }
}

// A click would be a step at the seam beyond what the sound does elsewhere.
TEST(Sounds, RepeatWithoutAClick)
{
    for (const make::SoundPlan& plan : make::soundPlans()) {
        if (!plan.repeats) continue;
        const std::vector<float> samples = committed(plan.name).samples;
        std::vector<float> bends; // of three neighbours: noise of a low pitch has small ones
        for (std::size_t i = 2; i < samples.size(); ++i)
            bends.push_back(std::abs(samples[i] - 2 * samples[i - 1] + samples[i - 2]));
        std::ranges::sort(bends);
        const float usual = bends[bends.size() * 999 / 1000];
        const std::size_t last = samples.size() - 1;
        EXPECT_LT(std::abs(samples[last - 1] - 2 * samples[last] + samples[0]), usual) << plan.name;
        EXPECT_LT(std::abs(samples[last] - 2 * samples[0] + samples[1]), usual) << plan.name;
    }
}

TEST(Sounds, LieWhereTheirLikesDo)
{
    const auto middle = [](const char* name) { return middleOf(committed(name)); };
    EXPECT_LT(middle("wind"), 1100);
    EXPECT_GT(middle("birds"), 2500);
    EXPECT_GT(middle("stream"), 500);
    EXPECT_LT(middle("stream"), 2500);
    EXPECT_GT(middle("steps_gravel"), middle("steps_sand"));
    EXPECT_LT(middle("steps_wood"), middle("steps_grass"));
}

TEST(Sounds, AreHeardInTheValley)
{
    const io::Scene& scene = tests::shipped("valley").scene();
    for (const io::TerrainLayer& layer : scene.terrain().layers)
        EXPECT_TRUE(layer.steps.starts_with("sounds/steps_")) << layer.name;
    for (const char* name : {"campfire", "sound_birds", "sound_stream"}) {
        const io::TemplateId id = scene.findTemplate(name);
        ASSERT_NE(scene.find(id), nullptr) << name;
        EXPECT_FALSE(scene.find(id)->sound.file.empty()) << name;
        EXPECT_GT(std::ranges::count(scene.objects(), id, &io::Object::templateId), 0) << name;
    }
}

} // namespace
