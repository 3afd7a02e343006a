#include "io/base/noise.h"

#include "io/base/random.h"

namespace io {
namespace {

int wrapped(int i, int period)
{
    if (period <= 0) return i;
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

float quintic(float t)
{
    return t * t * t * (t * (t * 6 - 15) + 10);
}

float slope(glm::ivec2 cell, glm::vec2 offset, std::uint32_t seed, glm::ivec2 period)
{
    const float angle = unitOf(hash(wrapped(cell.x, period.x), wrapped(cell.y, period.y), seed)) * 6.2831853f;
    return glm::cos(angle) * offset.x + glm::sin(angle) * offset.y;
}

float slope(glm::ivec3 cell, glm::vec3 offset, std::uint32_t seed)
{
    Random random{hash(cell.x, cell.y, cell.z, seed)};
    return glm::dot(random.direction(), offset);
}

} // namespace

float noise(glm::vec2 p, std::uint32_t seed, glm::ivec2 period)
{
    const glm::vec2 base = glm::floor(p);
    const glm::ivec2 cell{base};
    const glm::vec2 f = p - base;
    const glm::vec2 w{quintic(f.x), quintic(f.y)};
    const auto corner = [&](int x, int y) { return slope(cell + glm::ivec2{x, y}, f - glm::vec2{x, y}, seed, period); };
    return 1.5f * glm::mix(glm::mix(corner(0, 0), corner(1, 0), w.x), glm::mix(corner(0, 1), corner(1, 1), w.x), w.y);
}

float noise(glm::vec3 p, std::uint32_t seed)
{
    const glm::vec3 base = glm::floor(p);
    const glm::ivec3 cell{base};
    const glm::vec3 f = p - base;
    const auto corner = [&](int x, int y, int z) {
        return slope(cell + glm::ivec3{x, y, z}, f - glm::vec3{x, y, z}, seed);
    };
    const auto face = [&](int z) {
        const float low = glm::mix(corner(0, 0, z), corner(1, 0, z), quintic(f.x));
        const float high = glm::mix(corner(0, 1, z), corner(1, 1, z), quintic(f.x));
        return glm::mix(low, high, quintic(f.y));
    };
    return 1.5f * glm::mix(face(0), face(1), quintic(f.z));
}

float fbm(glm::vec2 p, std::uint32_t seed, Octaves octaves)
{
    float sum = 0, weight = 1, total = 0;
    for (int i = 0; i < octaves.count; ++i) {
        sum += weight * noise(p, seed + std::uint32_t(i) * 101u, octaves.period << glm::ivec2{i});
        total += weight;
        weight *= octaves.gain;
        p *= 2.0f;
    }
    return sum / total;
}

float fbm(glm::vec3 p, std::uint32_t seed, Octaves octaves)
{
    float sum = 0, weight = 1, total = 0;
    for (int i = 0; i < octaves.count; ++i) {
        sum += weight * noise(p, seed + std::uint32_t(i) * 101u);
        total += weight;
        weight *= octaves.gain;
        p *= 2.0f;
    }
    return sum / total;
}

float ridged(glm::vec2 p, std::uint32_t seed, Octaves octaves)
{
    float sum = 0, weight = 1, total = 0, carry = 1;
    for (int i = 0; i < octaves.count; ++i) {
        const float crest =
            1 - glm::min(1.0f, glm::abs(noise(p, seed + std::uint32_t(i) * 101u, octaves.period << glm::ivec2{i})));
        const float signal = crest * crest * carry;
        carry = glm::clamp(signal * 1.6f, 0.0f, 1.0f); // detail gathers on the crests
        sum += weight * signal;
        total += weight;
        weight *= octaves.gain;
        p *= 2.0f;
    }
    return sum / total;
}

float simplex(glm::vec2 p, std::uint32_t seed)
{
    constexpr float kSkew = 0.36602540f, kBack = 0.21132487f; // (sqrt(3) - 1) / 2, (3 - sqrt(3)) / 6
    constexpr float kDiagonal = 0.70710678f;
    constexpr glm::vec2 kSlopes[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {kDiagonal, kDiagonal}, {-kDiagonal, kDiagonal}, {kDiagonal, -kDiagonal}, {-kDiagonal, -kDiagonal}};
    const auto floored = [](float v) { // std::floor() is a call where the machine's own is not asked for
        const auto whole = float(int(v));
        return whole > v ? whole - 1 : whole;
    };
    const float skew = (p.x + p.y) * kSkew;
    const glm::vec2 cell{floored(p.x + skew), floored(p.y + skew)};
    const glm::vec2 a = p - cell + (cell.x + cell.y) * kBack;
    const glm::vec2 step = a.x > a.y ? glm::vec2{1, 0} : glm::vec2{0, 1};
    const std::uint32_t start = seed * 0xc2b2ae35u;
    const auto corner = [&](const glm::vec2& offset, const glm::vec2& at) {
        const float near = 0.5f - glm::dot(offset, offset);
        if (near <= 0) return 0.0f;
        return near * near * near * near * glm::dot(kSlopes[hash(std::uint32_t(int(at.x)) * 0x9e3779b9u + std::uint32_t(int(at.y)) * 0x85ebca6bu + start) & 7], offset);
    };
    return 70 * (corner(a, cell) + corner(a - step + kBack, cell + step) + corner(a - 1.0f + 2 * kBack, cell + 1.0f));
}

float simplexFbm(glm::vec2 p, std::uint32_t seed, Octaves octaves)
{
    float sum = 0, weight = 1, total = 0;
    for (int i = 0; i < octaves.count; ++i, weight *= octaves.gain, p *= 2.0f) {
        sum += weight * simplex(p, seed + std::uint32_t(i) * 101u);
        total += weight;
    }
    return sum / total;
}

float simplexRidged(glm::vec2 p, std::uint32_t seed, Octaves octaves)
{
    float sum = 0, weight = 1, total = 0, carry = 1;
    for (int i = 0; i < octaves.count; ++i, weight *= octaves.gain, p *= 2.0f) {
        const float crest = 1 - glm::min(1.0f, glm::abs(simplex(p, seed + std::uint32_t(i) * 101u)));
        const float signal = crest * crest * carry;
        carry = glm::clamp(signal * 1.6f, 0.0f, 1.0f);
        sum += weight * signal;
        total += weight;
    }
    return sum / total;
}

Cells cells(glm::vec2 p, std::uint32_t seed, glm::ivec2 period)
{
    const glm::ivec2 home{glm::floor(p)};
    Cells result{.nearest = 9, .second = 9};
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const glm::ivec2 cell = home + glm::ivec2{dx, dy};
            const std::uint32_t id = hash(wrapped(cell.x, period.x), wrapped(cell.y, period.y), seed);
            const glm::vec2 offset = p - (glm::vec2{cell} + glm::vec2{unitOf(id), unitOf(hash(id))});
            const float distance = glm::length(offset);
            if (distance < result.nearest) {
                result = {.nearest = distance, .second = result.nearest, .id = id, .offset = offset};
            } else {
                result.second = glm::min(result.second, distance);
            }
        }
    return result;
}

} // namespace io
