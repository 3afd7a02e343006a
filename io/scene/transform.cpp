#include "io/scene/transform.h"

#include <cmath>

namespace io {

glm::dquat orientation(const glm::vec3& degrees)
{
    const glm::dvec3 half = glm::radians(glm::dvec3{degrees}) * 0.5;
    const glm::dquat x{std::cos(half.x), std::sin(half.x), 0, 0};
    const glm::dquat y{std::cos(half.y), 0, std::sin(half.y), 0};
    const glm::dquat z{std::cos(half.z), 0, 0, std::sin(half.z)};
    return y * x * z;
}

glm::vec3 eulerDegrees(const glm::dquat& orientation)
{
    // With R = Ry Rx Rz:  R[2] = (sy cx, -sx, cy cx), R[0].y = cx sz, R[1].y = cx cz (columns).
    const glm::dmat3 r = glm::mat3_cast(glm::normalize(orientation));
    const double sx = glm::clamp(-r[2].y, -1.0, 1.0);
    glm::dvec3 angles{std::asin(sx), 0, 0};
    if (std::abs(sx) < 1 - 1e-9) {
        angles.y = std::atan2(r[2].x, r[2].z);
        angles.z = std::atan2(r[0].y, r[1].y);
    } else { // looking straight up or down: yaw and roll are one turn, given to yaw
        angles.y = std::atan2(-r[0].z, r[0].x);
    }
    return glm::vec3{glm::degrees(angles)};
}

glm::mat3 linearPart(const Transform& transform)
{
    glm::mat3 linear{glm::mat3_cast(orientation(transform.rotation))};
    for (int axis = 0; axis < 3; ++axis)
        linear[axis] *= transform.scale[axis];
    return linear;
}

glm::dmat4 worldFromModel(const Transform& transform)
{
    glm::dmat3 linear = glm::mat3_cast(orientation(transform.rotation));
    for (int axis = 0; axis < 3; ++axis)
        linear[axis] *= double(transform.scale[axis]);
    glm::dmat4 matrix{linear};
    matrix[3] = glm::dvec4{transform.position, 1};
    return matrix;
}

} // namespace io
