// Where a thing meets the ground, seen from above: what grass keeps out of.
#pragma once

#include "io/scene/model.h"
#include "io/scene/template.h"

#include <glm/glm.hpp>
#include <vector>

namespace io {

// In the model's own space, x and z in m: a circle around its origin, and texels of what its mesh covers near the ground.
class FootprintShape {
public:
    FootprintShape() = default;
    FootprintShape(const Template& what, const Model& model);

    float radius = 0; // m, of the circle
    bool empty() const { return radius <= 0 && m_covered.empty(); }
    glm::vec2 low() const { return m_low; }   // of the texels
    glm::vec2 high() const { return m_high; }
    bool hasTexels() const { return !m_covered.empty(); }
    // Whether some of the texels within `reach` m of a point are covered.
    bool covers(glm::vec2 point, float reach) const;

private:
    void addBox(const Model& model);
    void addMesh(const Model& model);

    glm::vec2 m_low{0}, m_high{0}; // m
    glm::ivec2 m_size{0};
    float m_texel = 1; // m
    std::vector<bool> m_covered; // row by row along x; empty: none
};

} // namespace io
