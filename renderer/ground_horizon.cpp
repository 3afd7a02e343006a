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

GroundHorizon::GroundHorizon(const glm::dvec3& eye) : m_eye{eye}
{
    m_slopes.fill(-std::numeric_limits<float>::infinity());
}

bool GroundHorizon::beside(const Box& box, Seen& seen) const
{
    const glm::dvec2 from = box.from - glm::dvec2{m_eye.x, m_eye.z}, to = box.to - glm::dvec2{m_eye.x, m_eye.z};
    const glm::dvec2 nearest = glm::max(glm::max(from, -to), glm::dvec2{0});
    seen.nearest = glm::length(nearest);
    if (seen.nearest == 0) return false;
    seen.farthest = glm::length(glm::max(glm::abs(from), glm::abs(to)));
    const double middle = direction((from + to) * 0.5);
    double first = 0, last = 0; // from the middle; a box beside the eye takes less than half of a turn
    for (const glm::dvec2& corner : {from, to, glm::dvec2{from.x, to.y}, glm::dvec2{to.x, from.y}}) {
        double off = direction(corner) - middle;
        if (off > kTurn / 2) off -= kTurn;
        if (off < -kTurn / 2) off += kTurn;
        first = std::min(first, off);
        last = std::max(last, off);
    }
    const double begin = middle + first;
    seen.first = (begin < 0 ? begin + kTurn : begin) * (kSectors / kTurn);
    seen.last = seen.first + (last - first) * (kSectors / kTurn);
    return true;
}

bool GroundHorizon::hides(const Box& box) const
{
    Seen seen;
    if (!beside(box, seen)) return false;
    const double rise = box.high - m_eye.y;
    const double steepest = rise / (rise > 0 ? seen.nearest : seen.farthest);
    for (int sector = int(seen.first); sector <= int(seen.last); ++sector)
        if (double(m_slopes[std::size_t(sector % kSectors)]) <= steepest) return false;
    return true;
}

void GroundHorizon::add(const Box& box)
{
    Seen seen;
    if (!beside(box, seen)) return;
    const double rise = box.low - m_eye.y;
    const auto slope = float(rise / (rise > 0 ? seen.farthest : seen.nearest));
    for (int sector = int(std::ceil(seen.first)); sector < int(seen.last); ++sector) { // those that it fills
        float& own = m_slopes[std::size_t(sector % kSectors)];
        own = std::max(own, slope);
    }
}

} // namespace renderer
