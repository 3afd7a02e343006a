// How far up the ground's own shadow reaches over every place: mountains shade valleys beyond the shadow maps.
#pragma once

#include "io/scene/height_map.h"
#include "renderer/gl/texture.h"

#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace renderer {

// Heights under which the sun is hidden, above or below the horizon, on the grid of `heights` (row by row from -Z, `cell` metres apart).
std::vector<float> shadowHeights(glm::ivec2 size, const std::vector<float>& heights, double cell, const glm::dvec3& towardSun);

class GroundShadow {
public:
    GroundShadow();
    void update(const std::shared_ptr<const io::HeightMap>& map, const glm::dvec3& towardSun);
    const gl::Texture& texture() const { return m_texture; }
    glm::vec4 placement(const glm::dvec3& eye) const; // uv = relative.xz * xy + zw

private:
    void coarsen(const io::HeightMap& map, const io::HeightMap* before);

    std::shared_ptr<const io::HeightMap> m_map;
    glm::dvec3 m_towardSun{0};
    glm::ivec2 m_size{0};
    double m_cell = 1; // m
    std::vector<float> m_heights;
    gl::Texture m_texture;
};

} // namespace renderer
