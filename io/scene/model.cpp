#include "io/scene/model.h"

namespace io {

Model boxModel(const glm::vec3& size, const glm::vec4& colour)
{
    Model model;
    model.name = "box";
    for (int face = 0; face < 6; ++face) {
        glm::vec3 normal{0};
        const int axis = face / 2;
        normal[axis] = face % 2 ? 1.0f : -1.0f;
        glm::vec3 u{0};
        u[(axis + 1) % 3] = 1;
        const glm::vec3 v = glm::cross(normal, u);
        const auto first = std::uint32_t(model.vertices.size());
        for (const glm::vec2 corner : {glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            const glm::vec3 unit = (normal + u * corner.x + v * corner.y) * 0.5f;
            model.vertices.push_back({.position = (unit + glm::vec3{0, 0.5f, 0}) * size,
                                      .normal = normal,
                                      .tangent = {u, 1},
                                      .uv0 = corner * 0.5f + 0.5f});
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
            model.indices.push_back(first + corner);
    }
    for (const Vertex& vertex : model.vertices)
        model.bounds.add(vertex.position);
    model.parts = {{.firstIndex = 0, .indexCount = std::uint32_t(model.indices.size()), .material = 0}};
    model.materials = {{.name = "box", .baseColour = colour, .metallic = 0, .roughness = 0.8f}};
    return model;
}

} // namespace io
