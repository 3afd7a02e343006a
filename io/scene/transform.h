// Where an object stands, how it is turned and how large it is.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace io {

// Rotation is kept as the degrees that a person types and a file holds, so that reading and writing never drift:
// about +Y (yaw), then the turned +X (pitch), then the turned +Z (roll): R = Ry * Rx * Rz.
struct Transform {
    glm::dvec3 position{0}; // m
    glm::vec3 rotation{0};  // degrees about x, y, z
    glm::vec3 scale{1};     // factors, each |s| in [1e-6, 1e6]

    bool operator==(const Transform&) const = default;
};

glm::dquat orientation(const glm::vec3& degrees);
glm::vec3 eulerDegrees(const glm::dquat& orientation); // the inverse, each in (-180, 180]
glm::dmat4 worldFromModel(const Transform& transform);

// The part of a transform that a float can carry: rotation and scale, without the position.
glm::mat3 linearPart(const Transform& transform);

} // namespace io
