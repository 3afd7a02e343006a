// Wind, birds, running water and fire: they repeat, so all that is in them goes round.
#include "projects/make/sounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace make {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kRate = 22050;

// Rises and falls slowly, -1..1, and is the same again after `length`.
double swell(double seconds, double length, double phase)
{
    const double t = kTurn * seconds / length;
    return (std::sin(t + phase) + 0.7 * std::sin(2 * t + 2.3 * phase + 1) + 0.5 * std::sin(3 * t + 3.1 * phase + 2) + 0.3 * std::sin(5 * t + phase + 4)) / 2.5;
}

float hump(float t) // a note's level
{
    return std::sin(float(std::numbers::pi) * std::clamp(t, 0.0f, 1.0f));
}

void addNote(Wave& wave, double at, double seconds, float from, float to, float gain, float vibrato = 0)
{
    const Wave note = toneOf(
        wave.rate, seconds, [=](float t) { return glm::mix(from, to, t) * (1 + vibrato * std::sin(t * float(seconds) * 190)); },
        [](float t) { return hump(t) * hump(t); }, 0.08f);
    wave.addRound(note, at, gain);
}

// Falls faster and faster and ends with a flourish, as a chaffinch.
void addTrill(Wave& wave, double at, float gain, Random& random)
{
    float pitch = random.range(5200, 5600);
    for (int i = 0; i < 11; ++i) {
        const double length = 0.11 - 0.004 * i;
        addNote(wave, at, length * 0.8, pitch, pitch * 0.72f, gain * (0.5f + 0.05f * float(i)));
        at += length;
        pitch *= 0.955f;
    }
    addNote(wave, at + 0.02, 0.12, 2900, 4600, gain);
    addNote(wave, at + 0.15, 0.10, 4400, 3000, gain * 0.8f);
}

// Two notes in turn, as a great tit.
void addTwoNotes(Wave& wave, double at, float gain, Random& random)
{
    const int times = 3 + random.below(3);
    for (int i = 0; i < times; ++i, at += 0.34) {
        addNote(wave, at, 0.11, 4700, 4600, gain);
        addNote(wave, at + 0.14, 0.15, 3550, 3500, gain * 0.9f);
    }
}

// A few slow whistles, as a blackbird.
void addWhistles(Wave& wave, double at, float gain, Random& random)
{
    float pitch = random.range(1900, 2300);
    for (int i = 0; i < 5; ++i) {
        const float next = random.range(1700, 2900);
        const double length = random.range(0.12f, 0.3f);
        addNote(wave, at, length, pitch, next, gain, 0.01f);
        at += length + random.range(0.03f, 0.09f);
        pitch = next;
    }
    addNote(wave, at, 0.08, 5200, 6800, gain * 0.3f);
}

// What comes back from trunks.
Wave amongTrees(const Wave& dry, Random& random)
{
    Wave wet = dry;
    for (int i = 0; i < 24; ++i) {
        const double late = 0.03 + 0.035 * i * random.range(0.8f, 1.2f);
        wet.addRound(dry, late, 0.16f * float(std::exp(-late * 4)) * (random.chance(0.5f) ? 1.0f : -1.0f));
    }
    return wet;
}

} // namespace

Wave makeWindSound()
{
    constexpr int kSlowRate = 12000; // there is little above 4 kHz in it
    constexpr double kLength = 11;
    Random random{901};
    Wave wave = noiseOf(kSlowRate, kLength, {Pass::Low, [](double s) { return float(190 + 70 * swell(s, kLength, 0.4)); }, 1.2f}, random);
    const Wave rush = noiseOf(kSlowRate, kLength, {Pass::Band, [](double s) { return float(520 + 260 * swell(s, kLength, 0.4)); }, 0.9f}, random);
    const Wave leaves = noiseOf(kSlowRate, kLength, {Pass::Band, [](double s) { return float(2300 + 700 * swell(s, kLength, 0.7)); }, 1.6f}, random);
    for (std::size_t i = 0; i < wave.samples.size(); ++i) {
        const double seconds = double(i) / kSlowRate;
        const double gust = swell(seconds, kLength, 0.4), rustle = swell(seconds, kLength, 0.7);
        wave.samples[i] = float(wave.samples[i] * (0.75 + 0.35 * gust) + rush.samples[i] * (0.55 + 0.4 * gust) + leaves.samples[i] * 0.09 * (0.6 + 0.5 * rustle));
    }
    wave.scaleTo(0.8f);
    return wave;
}

Wave makeBirdsSound()
{
    Random random{902};
    Wave dry = Wave::silence(kRate, 18);
    addTrill(dry, 0.8, 0.8f, random);
    addTwoNotes(dry, 4.1, 0.35f, random);
    addWhistles(dry, 6.9, 0.55f, random);
    addTrill(dry, 9.6, 0.3f, random);
    addTwoNotes(dry, 11.7, 0.7f, random);
    addWhistles(dry, 14.6, 0.25f, random);
    addNote(dry, 3.1, 0.05, 6100, 4800, 0.25f);
    addNote(dry, 13.9, 0.05, 6300, 5000, 0.3f);
    Wave wave = amongTrees(dry, random);
    wave.scaleTo(0.7f);
    return wave;
}

// Running water is bubbles: each rings as it closes, a little higher as it rises (van den Doel 2005, "Physically based models for
// liquid sounds").
Wave makeStreamSound()
{
    constexpr double kLength = 6.2;
    Random random{903};
    Wave wave = noiseOf(kRate, kLength, {Pass::Band, [](double s) { return float(900 + 250 * swell(s, kLength, 1.3)); }, 1.8f}, random);
    wave.scaleTo(0.22f);
    for (int i = 0; i < 970; ++i) {
        const float radius = random.range(0.0f, 1.0f); // small ones are many
        const float pitch = 420 + 2300 * radius * radius;
        const double length = random.range(0.02f, 0.06f) * (1.6 - radius);
        const float rise = random.range(0.02f, 0.3f);
        const Wave bubble = toneOf(
            kRate, length, [=](float t) { return pitch * (1 + rise * t); }, [](float t) { return std::min(1.0f, t * 30) * std::exp(-5 * t) * (1 - t); });
        const float gain = 0.16f * std::pow(random.unit(), 2.2f);
        wave.addRound(bubble, random.unit() * kLength, gain);
    }
    wave.scaleTo(0.7f);
    return wave;
}

Wave makeFireSound()
{
    constexpr double kLength = 6.5;
    Random random{904};
    Wave wave = noiseOf(kRate, kLength, {Pass::Low, [](double s) { return float(170 + 60 * swell(s, kLength, 2.2)); }, 1.3f}, random);
    wave.scaleTo(0.26f);
    const Wave hiss = noiseOf(kRate, kLength, {Pass::Band, [](double) { return 3600.0f; }, 1.9f}, random);
    for (std::size_t i = 0; i < wave.samples.size(); ++i)
        wave.samples[i] += hiss.samples[i] * float(0.025 + 0.015 * swell(double(i) / kRate, kLength, 0.9));
    // Wood bursts: single cracks, and now and then a few at once.
    double at = 0.05;
    while (at < kLength) {
        const int cracks = random.chance(0.2f) ? 3 + random.below(6) : 1;
        for (int i = 0; i < cracks; ++i) {
            const float hz = random.range(900, 5200);
            const double length = random.range(0.004f, 0.022f);
            Wave crack = noiseOf(kRate, length, {Pass::Band, [=](double) { return hz; }, 0.5f}, random);
            for (std::size_t k = 0; k < crack.samples.size(); ++k)
                crack.samples[k] *= std::exp(-6 * float(k) / float(crack.samples.size())) * std::min(1.0f, float(k) / 6);
            crack.scaleTo(1);
            wave.addRound(crack, at + random.range(0, 0.09f), 0.04f + 0.66f * std::pow(random.unit(), 3.5f));
        }
        at += 0.012 - 0.075 * std::log(1 - double(random.unit()));
    }
    wave.scaleTo(0.68f);
    return wave;
}

} // namespace make
