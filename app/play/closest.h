// Nearest points between segments and triangles, in closed form: exact where GJK wavers, on slivers and long thin triangles.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace play {

struct Nearest {
    glm::dvec3 on{0}, to{0}; // on the first, on the second
    double squared = 0;      // m2, between them
};

using Triangle = std::array<glm::dvec3, 3>;

// Ends may coincide.
Nearest nearestOfSegments(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);
glm::dvec3 nearestOnTriangle(const glm::dvec3& point, const Triangle& triangle); // of any area
Nearest nearestToTriangle(const glm::dvec3& a, const glm::dvec3& b, const Triangle& triangle);

glm::dvec3 faceNormal(const Triangle& triangle); // unit; 0 for a triangle without area

} // namespace play
