#include "renderer/ripples.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace renderer {
namespace {

constexpr int kSide = 256;      // texels
constexpr int kWaves = 56;
constexpr int kShortest = 42, kLongest = 5; // waves in a turn of the texture
constexpr double kSpread = 75;  // degrees to either side of the wind

std::vector<glm::vec2> slopes()
{
    std::mt19937 random{17};
    std::uniform_real_distribution<double> unit{0, 1};
    std::vector<glm::vec2> result(std::size_t(kSide) * kSide, glm::vec2{0});
    double square = 0;
    for (int i = 0; i < kWaves; ++i) {
        const double turns = kLongest * std::pow(double(kShortest) / kLongest, (i + unit(random)) / kWaves);
        const double angle = glm::radians(kSpread) * (2 * unit(random) - 1);
        // Whole waves, so that the texture tiles.
        const glm::dvec2 number = glm::round(turns * glm::dvec2{std::cos(angle), std::sin(angle)});
        const double phase = 2 * std::numbers::pi * unit(random);
        const double share = std::pow(glm::length(number), -0.35); // steeper, the longer
        const glm::vec2 slope{glm::normalize(number) * share};
        square += 0.5 * share * share;
        // cos(a + b) by its parts: no cosine for each texel.
        std::vector<glm::vec2> along(kSide), across(kSide);
        for (int t = 0; t < kSide; ++t) {
            const double a = 2 * std::numbers::pi * number.x * t / kSide + phase, b = 2 * std::numbers::pi * number.y * t / kSide;
            along[std::size_t(t)] = {float(std::cos(a)), float(std::sin(a))};
            across[std::size_t(t)] = {float(std::cos(b)), float(std::sin(b))};
        }
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const glm::vec2 a = along[std::size_t(x)], b = across[std::size_t(y)];
                result[std::size_t(y) * kSide + x] += slope * (a.x * b.x - a.y * b.y);
            }
    }
    for (glm::vec2& s : result)
        s /= float(std::sqrt(square));
    return result;
}

// Distance to the nearest of points scattered one in each cell, 0..1 or so.
class Cells {
public:
    Cells(int count, unsigned seed) : m_count{count}
    {
        std::mt19937 random{seed};
        std::uniform_real_distribution<float> unit{0, 1};
        for (int i = 0; i < count * count; ++i)
            m_points.push_back({unit(random), unit(random)});
    }
    float at(glm::vec2 uv) const
    {
        const glm::vec2 p = uv * float(m_count), cell = glm::floor(p);
        float nearest = 4;
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const glm::ivec2 c = (glm::ivec2{cell} + glm::ivec2{x, y} + m_count) % m_count;
                nearest = std::min(nearest, glm::length(cell + glm::vec2{x, y} + m_points[std::size_t(c.y * m_count + c.x)] - p));
            }
        return nearest;
    }

private:
    int m_count;
    std::vector<glm::vec2> m_points;
};

std::vector<glm::vec4> texels()
{
    const std::vector<glm::vec2> slope = slopes();
    const Cells broad{7, 3}, middle{17, 5}, fine{39, 7};
    std::vector<glm::vec4> result(slope.size());
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const glm::vec2 uv = (glm::vec2{x, y} + 0.5f) / float(kSide), s = slope[std::size_t(y) * kSide + x];
            const float web = 0.45f * broad.at(uv) + 0.35f * middle.at(uv) + 0.3f * fine.at(uv); // bubbles gather between cells
            result[std::size_t(y) * kSide + x] = {s, glm::dot(s, s), glm::smoothstep(0.2f, 0.85f, web)};
        }
    return result;
}

std::vector<glm::vec4> halved(const std::vector<glm::vec4>& from, int side)
{
    std::vector<glm::vec4> to(std::size_t(side / 2) * std::size_t(side / 2));
    for (int y = 0; y < side / 2; ++y)
        for (int x = 0; x < side / 2; ++x) {
            const auto at = [&](int dx, int dy) { return from[std::size_t(2 * y + dy) * side + std::size_t(2 * x + dx)]; };
            to[std::size_t(y) * (side / 2) + x] = 0.25f * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1));
        }
    return to;
}

} // namespace

gl::Texture makeRipples()
{
    gl::Texture texture{{.label = "ripples",
                         .size = glm::ivec2{kSide},
                         .format = GL_RGBA16F,
                         .mips = gl::fullMipCount(glm::ivec2{kSide}),
                         .wrap = GL_REPEAT,
                         .anisotropic = true}};
    std::vector<glm::vec4> mip = texels();
    for (int level = 0, side = kSide; side >= 1; ++level, side /= 2) {
        texture.upload(mip.data(), GL_RGBA, GL_FLOAT, level);
        if (side > 1) mip = halved(mip, side);
    }
    return texture;
}

} // namespace renderer
