// Boxes, spheres and rays. Double precision where it is the world's, float where it is a model's own.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace io {

template <class V>
struct BoxOf {
    V min{std::numeric_limits<typename V::value_type>::max()};
    V max{std::numeric_limits<typename V::value_type>::lowest()};

    bool empty() const { return min.x > max.x; }
    V centre() const { return (min + max) / typename V::value_type(2); }
    V size() const { return max - min; }
    void add(const V& point)
    {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const BoxOf& box)
    {
        min = glm::min(min, box.min);
        max = glm::max(max, box.max);
    }
    bool operator==(const BoxOf&) const = default;
};

using Box = BoxOf<glm::vec3>;       // model space, m
using WorldBox = BoxOf<glm::dvec3>; // world space, m

struct Ray {
    glm::dvec3 origin{0};        // m, world
    glm::dvec3 direction{0, 0, -1}; // unit
};

// The axis-aligned box around `box` after `worldFromModel`.
inline WorldBox transformed(const Box& box, const glm::dmat4& worldFromModel)
{
    WorldBox result;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                           corner & 4 ? box.max.z : box.min.z};
        result.add(glm::dvec3{worldFromModel * glm::dvec4{p, 1}});
    }
    return result;
}

} // namespace io
