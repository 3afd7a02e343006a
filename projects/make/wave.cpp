#include "projects/make/wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace make {

Wave Wave::silence(int rate, double seconds)
{
    return {rate, std::vector<float>(std::size_t(std::llround(seconds * rate)))};
}

void Wave::addRound(const Wave& part, double at, float gain)
{
    const auto first = std::size_t(at * rate);
    for (std::size_t i = 0; i < part.samples.size(); ++i)
        samples[(first + i) % samples.size()] += part.samples[i] * gain;
}

void Wave::add(const Wave& part, double at, float gain)
{
    const auto first = std::size_t(at * rate);
    for (std::size_t i = 0; i < part.samples.size() && first + i < samples.size(); ++i)
        samples[first + i] += part.samples[i] * gain;
}

float Wave::peak() const
{
    float most = 0;
    for (const float sample : samples)
        most = std::max(most, std::abs(sample));
    return most;
}

void Wave::scaleTo(float peakWanted)
{
    const float factor = peakWanted / std::max(peak(), 1e-9f);
    for (float& sample : samples)
        sample *= factor;
}

Wave noiseOf(int rate, double seconds, const Noise& noise, Random& random)
{
    Wave wave = Wave::silence(rate, seconds);
    std::vector<float> white(wave.samples.size());
    for (float& sample : white)
        sample = random.signedUnit();
    double band = 0, low = 0; // the filter's two states
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < white.size(); ++i) {
            const double hz = std::clamp(double(noise.frequency(double(i) / rate)), 5.0, rate * 0.45);
            const double g = std::tan(std::numbers::pi * hz / rate), k = noise.damping;
            const double a = 1 / (1 + g * (g + k));
            const double v3 = white[i] - low;
            const double v1 = a * band + g * a * v3;
            const double v2 = low + g * a * band + g * g * a * v3;
            band = 2 * v1 - band;
            low = 2 * v2 - low;
            const double out = noise.pass == Pass::Low ? v2 : noise.pass == Pass::Band ? k * v1 : white[i] - k * v1 - v2;
            wave.samples[i] = float(out);
        }
    return wave;
}

Wave toneOf(int rate, double seconds, const std::function<float(float)>& frequency, const std::function<float(float)>& level, float second)
{
    Wave wave = Wave::silence(rate, seconds);
    double phase = 0;
    for (std::size_t i = 0; i < wave.samples.size(); ++i) {
        const float t = float(i) / float(wave.samples.size());
        phase += 2 * std::numbers::pi * frequency(t) / rate;
        wave.samples[i] = level(t) * float(std::sin(phase) + second * std::sin(2 * phase));
    }
    return wave;
}

} // namespace make
