// Which spheres a view can see: structure of arrays and loops without branches, about 1 ms for 100,000.
#pragma once

#include "renderer/eye.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace renderer {

constexpr std::uint8_t kCastsShadow = 1;
constexpr std::uint8_t kMarker = 2;

struct Spheres {
    std::vector<float> x, y, z, radius; // m, world; the radius covers the rounding of the centre
    std::vector<std::uint8_t> flags;

    std::size_t size() const { return radius.size(); }
    void resize(std::size_t count);
    void set(std::size_t at, const glm::dvec3& centre, double sphereRadius, std::uint8_t sphereFlags);
    void move(std::size_t to, std::size_t from);
};

struct CullRequest {
    std::optional<Volume> volume;   // none: all are inside
    glm::dvec3 eye{0};
    std::optional<glm::dvec3> towardSun; // of a view by parallel light
    float smallestAngle = 0;        // radius / distance under which a thing is dropped
    float smallestRadius = 0;       // m, the same for parallel light
    std::uint8_t required = 0;      // flags
    std::uint8_t refused = 0;
};

// Indices in rising order.
void cull(const Spheres& spheres, const CullRequest& request, std::vector<std::uint32_t>& visible);

} // namespace renderer
