// A sound being made: samples that may go round, so that it repeats without a seam, and what shapes them.
#pragma once

#include "projects/make/random.h"

#include <functional>
#include <vector>

namespace make {

struct Wave {
    int rate = 22050; // Hz
    std::vector<float> samples;

    static Wave silence(int rate, double seconds);
    double seconds() const { return double(samples.size()) / rate; }
    // Adds `part` from a place on; beyond the end it goes on at the beginning.
    void addRound(const Wave& part, double at, float gain);
    void add(const Wave& part, double at, float gain); // beyond the end it is left out
    float peak() const;
    void scaleTo(float peak);
};

// White noise through a filter of two poles (Simper, "Linear trapezoidal state variable filter", 2013) whose frequency may move. The
// filter runs round twice, so that the end goes on into the beginning.
enum class Pass { Low, Band, High };
struct Noise {
    Pass pass = Pass::Low;
    std::function<float(double seconds)> frequency; // Hz
    float damping = 1;                              // 2 for no resonance at all, towards 0 it whistles
};
Wave noiseOf(int rate, double seconds, const Noise& noise, Random& random);

// A tone whose frequency and level are given over its time, 0..1; `second` is the share of its octave.
Wave toneOf(int rate, double seconds, const std::function<float(float)>& frequency, const std::function<float(float)>& level, float second = 0);

} // namespace make
