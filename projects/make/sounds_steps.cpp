// Feet on the ground: a thump of the body's weight, and the grains that give way under heel and ball.
#include "projects/make/sounds.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr int kRate = 22050;
constexpr int kSteps = 4;
constexpr double kApart = 0.22; // s of silence, by which they are told apart

struct Ground {
    float thump = 0.5f, thumpHz = 85, thumpSeconds = 0.07f; // of the weight
    float hiss = 0.3f, hissHz = 2500, hissDamping = 1.6f;   // of what is rubbed
    int grains = 0;                                         // single ones that break or roll
    float grain = 0.3f, grainLow = 1500, grainHigh = 5000;  // level, Hz
    float creak = 0;                                        // share by which it comes in jerks, as snow does
    double seconds = 0.24;
};

// Heel first, then, softer and longer, the ball.
float press(double t)
{
    const auto part = [&](double begin, double rise, double fall) { return t < begin ? 0 : float((1 - std::exp(-(t - begin) / rise)) * std::exp(-(t - begin) / fall)); };
    return part(0, 0.006, 0.035) + 0.75f * part(0.075, 0.012, 0.05);
}

Wave oneStep(const Ground& ground, Random& random)
{
    Wave step = Wave::silence(kRate, ground.seconds);
    const float hz = ground.hissHz * random.range(0.88f, 1.12f);
    Wave hiss = noiseOf(kRate, ground.seconds, {Pass::Band, [=](double) { return hz; }, ground.hissDamping}, random);
    hiss.scaleTo(1);
    const double jerks = random.range(70, 95);
    for (std::size_t i = 0; i < step.samples.size(); ++i) {
        const double t = double(i) / kRate;
        const float jerk = 1 - ground.creak * float(0.5 + 0.5 * std::sin(6.2831853 * jerks * t * (1 - 0.6 * t)));
        step.samples[i] = hiss.samples[i] * ground.hiss * press(t) * jerk;
    }
    const float low = ground.thumpHz * random.range(0.9f, 1.1f);
    const Wave thump = toneOf(
        kRate, ground.thumpSeconds, [=](float t) { return low * (1.5f - 0.6f * t); }, [](float t) { return std::min(1.0f, t * 12) * std::exp(-4 * t) * (1 - t); });
    step.add(thump, 0, ground.thump);
    step.add(thump, 0.075, ground.thump * 0.45f);
    for (int i = 0; i < ground.grains; ++i) {
        const double at = ground.seconds * 0.72 * random.unit();
        const float pitch = random.range(ground.grainLow, ground.grainHigh);
        Wave grain = noiseOf(kRate, random.range(0.003f, 0.012f), {Pass::Band, [=](double) { return pitch; }, 0.45f}, random);
        for (std::size_t k = 0; k < grain.samples.size(); ++k)
            grain.samples[k] *= std::exp(-5 * float(k) / float(grain.samples.size())) * std::min(1.0f, float(k) / 5);
        grain.scaleTo(1);
        step.add(grain, at, ground.grain * press(at) * std::pow(random.unit(), 1.5f) * 2);
    }
    for (std::size_t i = 0; i < step.samples.size(); ++i) { // out to nothing
        const auto left = float(step.samples.size() - i) / (0.04f * kRate);
        step.samples[i] *= std::min(1.0f, left);
    }
    step.scaleTo(random.range(0.64f, 0.76f));
    return step;
}

Wave steps(const Ground& ground, std::uint64_t seed)
{
    Random random{seed};
    Wave all = Wave::silence(kRate, (ground.seconds + kApart) * kSteps);
    for (int i = 0; i < kSteps; ++i)
        all.add(oneStep(ground, random), i * (ground.seconds + kApart), 1);
    return all;
}

} // namespace

Wave makeGrassSteps()
{
    return steps({.thump = 0.45f, .thumpHz = 75, .hiss = 0.42f, .hissHz = 3400, .hissDamping = 1.8f, .grains = 14, .grain = 0.12f, .grainLow = 2500, .grainHigh = 7000, .seconds = 0.26}, 911);
}

Wave makeGravelSteps()
{
    return steps({.thump = 0.3f, .thumpHz = 95, .hiss = 0.22f, .hissHz = 2300, .grains = 70, .grain = 0.55f, .grainLow = 1200, .grainHigh = 5200, .seconds = 0.27}, 912);
}

Wave makeSandSteps()
{
    return steps({.thump = 0.4f, .thumpHz = 70, .hiss = 0.5f, .hissHz = 1100, .hissDamping = 1.6f, .grains = 10, .grain = 0.06f, .seconds = 0.26}, 913);
}

Wave makeSnowSteps()
{
    return steps({.thump = 0.25f, .thumpHz = 65, .hiss = 0.6f, .hissHz = 1900, .hissDamping = 1.1f, .grains = 30, .grain = 0.16f, .grainLow = 900, .grainHigh = 2600, .creak = 0.75f, .seconds = 0.3}, 914);
}

// A board rings: its own tones, more of them than weight.
Wave makeWoodSteps()
{
    const Ground ground{.thump = 0.6f, .thumpHz = 120, .thumpSeconds = 0.09f, .hiss = 0.07f, .hissHz = 2000, .grains = 3, .grain = 0.15f, .grainLow = 1500, .grainHigh = 3000, .seconds = 0.24};
    Random random{915};
    Wave all = Wave::silence(kRate, (ground.seconds + kApart) * kSteps);
    for (int i = 0; i < kSteps; ++i) {
        Wave step = oneStep(ground, random);
        for (const float hz : {185.0f, 342.0f, 560.0f, 910.0f}) {
            const float own = hz * random.range(0.96f, 1.04f);
            const Wave ring = toneOf(
                kRate, 0.16, [=](float) { return own; }, [](float t) { return std::min(1.0f, t * 60) * std::exp(-9 * t) * (1 - t); });
            step.add(ring, 0, 55 / hz);
            step.add(ring, 0.075, 28 / hz);
        }
        step.scaleTo(random.range(0.64f, 0.76f));
        all.add(step, i * (ground.seconds + kApart), 1);
    }
    return all;
}

} // namespace make
