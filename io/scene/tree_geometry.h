// The arithmetic of boxes that a spatial tree needs: rounding outwards, distances, planes.
#pragma once

#include "io/scene/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace io {

inline float roundedDown(double value)
{
    const float rounded = float(value);
    return double(rounded) > value ? std::nextafter(rounded, std::numeric_limits<float>::lowest()) : rounded;
}
inline float roundedUp(double value)
{
    return -roundedDown(-value);
}

inline Box roundedOutwards(const WorldBox& box)
{
    return {.min = {roundedDown(box.min.x), roundedDown(box.min.y), roundedDown(box.min.z)},
            .max = {roundedUp(box.max.x), roundedUp(box.max.y), roundedUp(box.max.z)}};
}

inline bool contains(const Box& outer, const Box& inner)
{
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
           outer.max.x >= inner.max.x && outer.max.y >= inner.max.y && outer.max.z >= inner.max.z;
}

// Whether `outer` would become smaller without `inner`, at most.
inline bool reachesEdge(const Box& outer, const Box& inner)
{
    return outer.min.x == inner.min.x || outer.min.y == inner.min.y || outer.min.z == inner.min.z ||
           outer.max.x == inner.max.x || outer.max.y == inner.max.y || outer.max.z == inner.max.z;
}

inline bool touches(const Box& a, const WorldBox& b)
{
    return a.min.x <= b.max.x && a.min.y <= b.max.y && a.min.z <= b.max.z && //
           a.max.x >= b.min.x && a.max.y >= b.min.y && a.max.z >= b.min.z;
}
inline bool within(const Box& inner, const WorldBox& outer)
{
    return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y && inner.min.z >= outer.min.z &&
           inner.max.x <= outer.max.x && inner.max.y <= outer.max.y && inner.max.z <= outer.max.z;
}

inline double distance(const Box& box, const glm::dvec3& point)
{
    const glm::dvec3 outside =
        glm::max(glm::max(glm::dvec3{box.min} - point, point - glm::dvec3{box.max}), glm::dvec3{0});
    return glm::length(outside);
}

// Where a ray enters boxes, by their slabs. A direction along an axis divides by next to nothing instead of zero, so
// that no NaN comes of a ray that runs in a face.
class SlabTest {
public:
    explicit SlabTest(const Ray& ray) : m_origin{ray.origin}
    {
        for (int axis = 0; axis < 3; ++axis) {
            const double d = ray.direction[axis];
            m_inverse[axis] = std::abs(d) < 1e-300 ? std::copysign(1e300, d) : 1 / d;
        }
    }

    static constexpr double kMiss = std::numeric_limits<double>::infinity();

    // In lengths of the direction, 0 from inside; kMiss for none.
    double entry(const Box& box) const
    {
        double in = 0, out = kMiss;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (double(box.min[axis]) - m_origin[axis]) * m_inverse[axis];
            const double b = (double(box.max[axis]) - m_origin[axis]) * m_inverse[axis];
            in = std::max(in, std::min(a, b));
            out = std::min(out, std::max(a, b));
        }
        return in <= out ? in : kMiss;
    }

private:
    glm::dvec3 m_origin;
    glm::dvec3 m_inverse;
};

enum class Side { Outside, Across, Inside };

// Of a box to a plane (n, d), inside where dot(n, p) + d >= 0.
inline Side sideOf(const Box& box, const glm::dvec4& plane)
{
    const glm::dvec3 n{plane};
    const glm::dvec3 centre = (glm::dvec3{box.min} + glm::dvec3{box.max}) * 0.5;
    const glm::dvec3 half = (glm::dvec3{box.max} - glm::dvec3{box.min}) * 0.5;
    const double middle = glm::dot(n, centre) + plane.w;
    const double extent = glm::dot(glm::abs(n), half);
    if (middle + extent < 0) return Side::Outside;
    return middle - extent >= 0 ? Side::Inside : Side::Across;
}

} // namespace io
