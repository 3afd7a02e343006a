#include "projects/make/terrain_forms.h"

#include "projects/make/random.h"

#include <algorithm>
#include <cmath>

namespace make {

io::HeightGrid blankHeights(int side, double metresPerTexel)
{
    io::HeightGrid map;
    map.size = {side, side};
    map.metresPerTexel = metresPerTexel;
    map.origin = glm::dvec2{-0.5 * (side - 1) * metresPerTexel};
    map.metres.assign(std::size_t(side) * side, 0.0f);
    return map;
}

void fill(io::HeightGrid& map, const std::function<float(glm::vec2)>& heights)
{
    change(map, [&](glm::vec2 p, float) { return heights(p); });
}

void change(io::HeightGrid& map, const std::function<float(glm::vec2, float)>& heights)
{
    for (int z = 0; z < map.size.y; ++z)
        for (int x = 0; x < map.size.x; ++x) {
            float& height = map.metres[std::size_t(z) * map.size.x + x];
            height = heights(glm::vec2{map.origin + glm::dvec2{x, z} * map.metresPerTexel}, height);
        }
}

namespace {

float cubic(float a, float b, float c, float d) // half way between b and c (Catmull-Rom)
{
    return (9 * (b + c) - a - d) / 16;
}

} // namespace

io::HeightGrid doubled(const io::HeightGrid& map)
{
    io::HeightGrid fine = blankHeights(map.size.x * 2 - 1, map.metresPerTexel / 2);
    const int side = fine.size.x;
    const auto out = [&](int x, int z) -> float& { return fine.metres[std::size_t(z) * side + x]; };
    for (int z = 0; z < map.size.y; ++z)
        for (int x = 0; x < side; ++x) {
            const int half = x / 2;
            out(x, 2 * z) = x % 2 == 0 ? map.at(half, z)
                                       : cubic(map.clampedAt(half - 1, z), map.at(half, z),
                                               map.clampedAt(half + 1, z), map.clampedAt(half + 2, z));
        }
    for (int z = 1; z < side; z += 2)
        for (int x = 0; x < side; ++x)
            out(x, z) =
                cubic(out(x, std::max(0, z - 3)), out(x, z - 1), out(x, z + 1), out(x, std::min(side - 1, z + 3)));
    return fine;
}

namespace {

struct Ground {
    float height;
    glm::vec2 slope;
};

class Erosion {
public:
    Erosion(io::HeightGrid& map, const Rain& rain) : m_map{map}, m_rain{rain}, m_random{rain.seed}
    {
        float sum = 0;
        for (int dz = -rain.brush; dz <= rain.brush; ++dz)
            for (int dx = -rain.brush; dx <= rain.brush; ++dx) {
                const float weight = float(rain.brush) - std::sqrt(float(dx * dx + dz * dz));
                if (weight <= 0) continue;
                m_brush.push_back({dx + dz * map.size.x, weight});
                sum += weight;
            }
        for (auto& [offset, weight] : m_brush)
            weight /= sum;
    }

    void drop()
    {
        const float last = float(m_map.size.x - 2 - m_rain.brush);
        const float first = float(m_rain.brush) + 1;
        glm::vec2 at{m_random.range(first, last), m_random.range(first, last)};
        glm::vec2 heading{0};
        float speed = 1, water = 1, soil = 0;
        for (int step = 0; step < m_rain.steps; ++step) {
            const Ground here = groundAt(at);
            heading = heading * kInertia - here.slope * (1 - kInertia);
            const float length = glm::length(heading);
            if (length < 1e-6f) return;
            heading /= length;
            const glm::vec2 next = at + heading;
            if (next.x < first || next.y < first || next.x > last || next.y > last) return;
            const float fall = groundAt(next).height - here.height;
            const float capacity = std::max(-fall, 0.01f * kUnit) * speed * water * kCapacity;
            if (soil > capacity || fall > 0) {
                const float left = fall > 0 ? std::min(fall, soil) : (soil - capacity) * 0.3f * m_rain.strength;
                soil -= left;
                leave(at, left);
            } else {
                const float taken = std::min((capacity - soil) * 0.3f * m_rain.strength, -fall);
                take(at, taken);
                soil += taken;
            }
            speed = std::sqrt(std::max(0.0f, speed * speed - fall / kUnit * 0.15f));
            water *= 0.985f;
            at = next;
        }
    }

private:
    static constexpr float kInertia = 0.08f;
    static constexpr float kCapacity = 0.16f;
    static constexpr float kUnit = 1; // m

    Ground groundAt(glm::vec2 p) const
    {
        const int x = int(p.x), z = int(p.y);
        const float u = p.x - float(x), v = p.y - float(z);
        const float h00 = m_map.at(x, z), h10 = m_map.at(x + 1, z), h01 = m_map.at(x, z + 1),
                    h11 = m_map.at(x + 1, z + 1);
        return {h00 * (1 - u) * (1 - v) + h10 * u * (1 - v) + h01 * (1 - u) * v + h11 * u * v,
                {(h10 - h00) * (1 - v) + (h11 - h01) * v, (h01 - h00) * (1 - u) + (h11 - h10) * u}};
    }

    void leave(glm::vec2 p, float amount)
    {
        const int x = int(p.x), z = int(p.y);
        const float u = p.x - float(x), v = p.y - float(z);
        float* h = &m_map.metres[std::size_t(z) * m_map.size.x + x];
        h[0] += amount * (1 - u) * (1 - v);
        h[1] += amount * u * (1 - v);
        h[m_map.size.x] += amount * (1 - u) * v;
        h[m_map.size.x + 1] += amount * u * v;
    }

    void take(glm::vec2 p, float amount)
    {
        float* h = &m_map.metres[std::size_t(int(p.y)) * m_map.size.x + int(p.x)];
        for (const auto& [offset, weight] : m_brush)
            h[offset] -= amount * weight;
    }

    io::HeightGrid& m_map;
    const Rain& m_rain;
    Random m_random;
    std::vector<std::pair<std::ptrdiff_t, float>> m_brush;
};

} // namespace

void rainOn(io::HeightGrid& map, const Rain& rain)
{
    Erosion erosion{map, rain};
    for (int i = 0; i < rain.drops; ++i)
        erosion.drop();
}

float heightAt(const io::HeightGrid& map, glm::vec2 place)
{
    const glm::dvec2 low = map.origin, high = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel;
    const glm::dvec2 p = glm::clamp(glm::dvec2{place}, low, high);
    return float(map.height(p.x, p.y).value_or(0));
}

float slopeAt(const io::HeightGrid& map, glm::vec2 place)
{
    const auto normal = map.normal(place.x, place.y);
    return normal ? float(glm::degrees(std::acos(std::min(1.0, normal->y)))) : 90;
}

} // namespace make
