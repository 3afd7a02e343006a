// Random: numbers that are the same on every machine for the same seed (splitmix64, Steele et al. 2014).
#pragma once

#include <cstdint>

namespace editor {

class Random {
public:
    explicit Random(std::uint64_t seed) : m_state{seed} {}

    std::uint64_t bits()
    {
        std::uint64_t z = (m_state += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double unit() { return double(bits() >> 11) * 0x1.0p-53; } // [0, 1)
    double in(double low, double high) { return low + (high - low) * unit(); }

private:
    std::uint64_t m_state;
};

} // namespace editor
