// Vertices as the GPU reads them: normals and tangents as points of an octahedron.
#pragma once

#include "io/scene/model.h"

#include <cstdint>
#include <glm/glm.hpp>

namespace renderer {

struct PackedVertex {
    glm::vec3 position{0};      // m
    std::uint32_t normal = 0;   // two snorm16
    std::uint32_t tangent = 0;  // snorm16, snorm15, and the bitangent's sign in the highest bit
    glm::u8vec4 colour{255};
    glm::vec2 uv0{0};
    glm::vec2 uv1{0};
    std::uint32_t material = 0; // of the shared table
};
static_assert(sizeof(PackedVertex) == 44);

glm::vec2 octahedral(const glm::vec3& unit); // -1..1
glm::vec3 fromOctahedral(const glm::vec2& point);
PackedVertex pack(const io::Vertex& vertex, std::uint32_t material);

} // namespace renderer
