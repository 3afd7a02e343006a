// Random numbers that are the same on every machine: PCG32 (O'Neill 2014), and a hash of lattice points.
// The standard library's distributions differ between libraries, so none is used.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

namespace io {

class Random {
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 1) : m_step{(stream << 1) | 1}
    {
        next();
        m_state += seed;
        next();
    }

    std::uint32_t next()
    {
        const std::uint64_t old = m_state;
        m_state = old * 6364136223846793005ull + m_step;
        const auto shifted = std::uint32_t(((old >> 18) ^ old) >> 27);
        const auto turn = std::uint32_t(old >> 59);
        return (shifted >> turn) | (shifted << ((32 - turn) & 31));
    }
    float unit() { return float(next() >> 8) * 0x1p-24f; } // [0, 1)
    float range(float low, float high) { return low + (high - low) * unit(); }
    float signedUnit() { return range(-1, 1); }
    float bell() { return (unit() + unit() + unit()) * (2.0f / 3) - 1; } // [-1, 1), most near 0
    int below(int count) { return int((std::uint64_t(next()) * std::uint64_t(count)) >> 32); }
    bool chance(float share) { return unit() < share; }
    glm::vec3 direction() // even over the sphere
    {
        const float z = signedUnit();
        const float angle = range(0, 6.2831853f);
        const float radius = glm::sqrt(glm::max(0.0f, 1 - z * z));
        return {radius * glm::cos(angle), z, radius * glm::sin(angle)};
    }

private:
    std::uint64_t m_state = 0;
    std::uint64_t m_step;
};

inline std::uint32_t hash(std::uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}
inline std::uint32_t hash(int x, int y, std::uint32_t seed)
{
    return hash(std::uint32_t(x) + hash(std::uint32_t(y) + hash(seed)));
}
inline std::uint32_t hash(int x, int y, int z, std::uint32_t seed)
{
    return hash(std::uint32_t(x) + hash(y, z, seed));
}
inline std::uint32_t hash(std::string_view text) // FNV-1a: a seed from a name
{
    std::uint32_t value = 2166136261u;
    for (const char c : text)
        value = (value ^ std::uint8_t(c)) * 16777619u;
    return value;
}
inline float unitOf(std::uint32_t bits)
{
    return float(bits >> 8) * 0x1p-24f;
}

} // namespace io
