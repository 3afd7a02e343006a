#include "renderer/ground_horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace renderer {
namespace {

constexpr double kTurn = 4; // once around, as `direction` counts

// Grows with the angle from +x towards +z, in [0, 4), without an arc tangent.
double direction(const glm::dvec2& away)
{
    const double along = away.x / (std::abs(away.x) + std::abs(away.y));
    return away.y < 0 ? 3 + along : 1 - along;
}

} // namespace

// Those sectors, and those of them that begin anew where they go once around.
std::array<std::pair<int, int>, 2> GroundHorizon::pieces(int first, int last)
{
    return {{{first, std::max(std::min(last, kSectors), first)}, {0, std::max(last - kSectors, 0)}}};
}

GroundHorizon::GroundHorizon(const glm::dvec3& eye) : m_eye{eye}
{
    m_slopes.fill(-std::numeric_limits<float>::infinity());
}

GroundHorizon::Seen GroundHorizon::look(const Box& box) const
{
    const glm::dvec2 from = box.from - glm::dvec2{m_eye.x, m_eye.z}, to = box.to - glm::dvec2{m_eye.x, m_eye.z};
    const double nearest = glm::length(glm::max(glm::max(from, -to), glm::dvec2{0}));
    if (nearest == 0) return {};
    const double farthest = glm::length(glm::max(glm::abs(from), glm::abs(to)));
    const double middle = direction((from + to) * 0.5);
    double first = 0, last = 0; // from the middle; a box beside the eye takes less than half of a turn
    for (const glm::dvec2& corner : {from, to, glm::dvec2{from.x, to.y}, glm::dvec2{to.x, from.y}}) {
        double off = direction(corner) - middle;
        if (off > kTurn / 2) off -= kTurn;
        if (off < -kTurn / 2) off += kTurn;
        first = std::min(first, off);
        last = std::max(last, off);
    }
    const double start = middle + first, begin = (start < 0 ? start + kTurn : start) * (kSectors / kTurn);
    const double end = begin + (last - first) * (kSectors / kTurn), rise = box.high - m_eye.y, least = box.low - m_eye.y;
    return {.first = int(begin),
            .last = int(end) + 1,
            .inner = int(std::ceil(begin)),
            .end = int(end),
            .top = float(rise / (rise > 0 ? nearest : farthest)),
            .bottom = float(least / (least > 0 ? farthest : nearest))};
}

bool GroundHorizon::hides(const Seen& seen) const
{
    const auto higher = [&](float slope) { return slope > seen.top; };
    for (const auto& [from, to] : pieces(seen.first, seen.last))
        if (!std::all_of(m_slopes.begin() + from, m_slopes.begin() + to, higher)) return false;
    return bool(seen);
}

void GroundHorizon::add(const Seen& seen)
{
    for (const auto& [from, to] : pieces(seen.inner, seen.end))
        for (int sector = from; sector < to; ++sector)
            m_slopes[std::size_t(sector)] = std::max(m_slopes[std::size_t(sector)], seen.bottom);
}

} // namespace renderer
