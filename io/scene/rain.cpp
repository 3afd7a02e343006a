#include "io/scene/rain.h"

#include <algorithm>
#include <cmath>

namespace io {

Rainfall::Rainfall(HeightGrid& heights, const Rain& rain)
    : m_heights{heights}, m_rain{rain}, m_first{float(rain.reach) + 1}, m_last{heights.size - 2 - rain.reach}
{
    float sum = 0;
    for (int dz = -rain.reach; dz <= rain.reach; ++dz)
        for (int dx = -rain.reach; dx <= rain.reach; ++dx) {
            const float weight = float(rain.reach) - std::sqrt(float(dx * dx + dz * dz));
            if (weight <= 0) continue;
            m_taken.push_back({dx + dz * heights.size.x, weight});
            sum += weight;
        }
    for (auto& [offset, weight] : m_taken)
        weight /= sum;
}

void Rainfall::drop(glm::vec2 at)
{
    const Rain rain = m_rain; // heights are floats too: what is a member would be read again after each of them is written
    const float least = 0.01f * rain.unit, gravity = rain.gravity / rain.unit;
    glm::vec2 heading{0};
    float speed = 1, water = 1, soil = 0;
    Ground here = groundAt(at);
    for (int step = 0; step < rain.steps; ++step) {
        heading = heading * rain.inertia - here.slope * (1 - rain.inertia);
        const float length = glm::length(heading);
        if (length < 1e-6f) break;
        heading /= length;
        const glm::vec2 next = at + heading;
        if (!inside(next)) break;
        const Ground there = groundAt(next);
        const float fall = there.height - here.height;
        const float capacity = std::max(-fall, least) * speed * water * rain.capacity;
        if (soil > capacity || fall > 0) {
            const float left = fall > 0 ? std::min(fall, soil) : (soil - capacity) * 0.3f * rain.strength;
            soil -= left;
            leave(at, left);
        } else {
            const float taken = std::min((capacity - soil) * 0.3f * rain.strength, -fall);
            take(at, taken);
            soil += taken;
        }
        speed = std::sqrt(std::max(0.0f, speed * speed - fall * gravity));
        water *= rain.lasting;
        at = next;
        here = rain.seesItself ? groundAt(at) : there;
    }
    if (rain.leavesAll) leave(at, soil);
}

Rainfall::Ground Rainfall::groundAt(glm::vec2 p) const
{
    const int x = int(p.x), z = int(p.y);
    const float u = p.x - float(x), v = p.y - float(z);
    const float* h = &m_heights.metres[std::size_t(z) * m_heights.size.x + x];
    const float h00 = h[0], h10 = h[1], h01 = h[m_heights.size.x], h11 = h[m_heights.size.x + 1];
    return {h00 * (1 - u) * (1 - v) + h10 * u * (1 - v) + h01 * (1 - u) * v + h11 * u * v,
            {(h10 - h00) * (1 - v) + (h11 - h01) * v, (h01 - h00) * (1 - u) + (h11 - h10) * u}};
}

void Rainfall::leave(glm::vec2 p, float amount)
{
    const int x = int(p.x), z = int(p.y);
    const float u = p.x - float(x), v = p.y - float(z);
    float* h = &m_heights.metres[std::size_t(z) * m_heights.size.x + x];
    h[0] += amount * (1 - u) * (1 - v);
    h[1] += amount * u * (1 - v);
    h[m_heights.size.x] += amount * (1 - u) * v;
    h[m_heights.size.x + 1] += amount * u * v;
}

void Rainfall::take(glm::vec2 p, float amount)
{
    float* h = &m_heights.metres[std::size_t(int(p.y)) * m_heights.size.x + int(p.x)];
    for (const auto& [offset, weight] : m_taken)
        h[offset] -= amount * weight;
}

} // namespace io
