#include "app/play/closest.h"

#include <algorithm>

namespace play {
namespace {

constexpr double kNoArea = 1e-14; // m2; less is a line

Nearest between(const glm::dvec3& on, const glm::dvec3& to)
{
    return {on, to, glm::dot(to - on, to - on)};
}

glm::dvec3 nearestOnSegment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double length = glm::dot(along, along);
    return length <= 0 ? a : a + along * std::clamp(glm::dot(point - a, along) / length, 0.0, 1.0);
}

void keepNearer(Nearest& best, const Nearest& other)
{
    if (other.squared < best.squared) best = other;
}

} // namespace

// Ericson, Real-Time Collision Detection, 5.1.9.
Nearest nearestOfSegments(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    const glm::dvec3 u = b - a, v = d - c, w = a - c;
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), uw = glm::dot(u, w), vw = glm::dot(v, w);
    if (uu <= 0) return between(a, nearestOnSegment(a, c, d));
    if (vv <= 0) return between(nearestOnSegment(c, a, b), c);
    const double parallel = uu * vv - uv * uv;
    double s = parallel > 1e-12 * uu * vv ? std::clamp((uv * vw - uw * vv) / parallel, 0.0, 1.0) : 0;
    double t = (uv * s + vw) / vv;
    if (t < 0 || t > 1) {
        t = std::clamp(t, 0.0, 1.0);
        s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
    }
    return between(a + u * s, c + v * t);
}

// Ericson, 5.1.5; a triangle without area is its edges.
glm::dvec3 nearestOnTriangle(const glm::dvec3& point, const Triangle& triangle)
{
    const auto& [a, b, c] = triangle;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::dot(normal, normal);
    if (area > kNoArea * kNoArea) {
        const double u = glm::dot(glm::cross(c - b, point - b), normal), v = glm::dot(glm::cross(a - c, point - c), normal);
        const double w = glm::dot(glm::cross(b - a, point - a), normal);
        if (u >= 0 && v >= 0 && w >= 0) return point - normal * (glm::dot(point - a, normal) / area);
    }
    Nearest best = between(point, nearestOnSegment(point, a, b));
    keepNearer(best, between(point, nearestOnSegment(point, b, c)));
    keepNearer(best, between(point, nearestOnSegment(point, c, a)));
    return best.to;
}

Nearest nearestToTriangle(const glm::dvec3& a, const glm::dvec3& b, const Triangle& triangle)
{
    const auto& [p, q, r] = triangle;
    const glm::dvec3 normal = glm::cross(q - p, r - p);
    const double from = glm::dot(a - p, normal), to = glm::dot(b - p, normal);
    if (from * to < 0) { // the segment crosses the plane: through the triangle?
        const glm::dvec3 through = a + (b - a) * (from / (from - to));
        const glm::dvec3 on = nearestOnTriangle(through, triangle);
        if (glm::dot(on - through, on - through) < 1e-18) return {through, through, 0};
    }
    Nearest best = between(a, nearestOnTriangle(a, triangle));
    keepNearer(best, between(b, nearestOnTriangle(b, triangle)));
    for (int i = 0; i < 3; ++i)
        keepNearer(best, nearestOfSegments(a, b, triangle[std::size_t(i)], triangle[std::size_t((i + 1) % 3)]));
    return best;
}

glm::dvec3 faceNormal(const Triangle& triangle)
{
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double length = glm::length(normal);
    return length > kNoArea ? normal / length : glm::dvec3{0};
}

} // namespace play
