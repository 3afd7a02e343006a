// A camera that a person named, and a path that a camera flies.
#pragma once

#include "io/scene/extra.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace io {

struct Camera {
    std::string name;
    glm::dvec3 eye{0, 2, 0};  // m
    float yaw = 0;            // degrees; 0 looks along -Z, positive turns left (counter-clockwise from above)
    float pitch = 0;          // degrees, positive looks up, -90..90
    float fov = 60;           // degrees, vertical
    Extra extra;
    bool operator==(const Camera&) const = default;
};

struct PathKey {
    double time = 0; // s
    glm::dvec3 eye{0};
    float yaw = 0;
    float pitch = 0;
    float fov = 60;
    bool operator==(const PathKey&) const = default;
};

struct CameraPath {
    std::string name;
    std::vector<PathKey> keys; // by rising time
    bool lookAt = false;       // all along at `target`, wherever its keys look
    glm::dvec3 target{0};      // m
    Extra extra;
    bool operator==(const CameraPath&) const = default;
};

glm::dvec3 forward(const Camera& camera); // unit

// The camera at `seconds` along the path: Catmull-Rom through the keys, turning the short way round.
Camera sample(const CameraPath& path, double seconds);
double duration(const CameraPath& path); // s
double length(const CameraPath& path, std::size_t leg); // m, of its way from key `leg` to the next
double length(const CameraPath& path);                  // m, of all of it

// As `camera`, but turned towards a place; where it stands on it, as before.
Camera lookingAt(Camera camera, const glm::dvec3& target);

} // namespace io
