// The ground: how a height map lies in the world and what covers it. Its heights: io/scene/height_map.h.
#pragma once

#include "io/scene/bounds.h"
#include "io/scene/extra.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace io {

// One covering of the ground, shown where its rules hold; later layers lie over earlier ones.
struct TerrainLayer {
    std::string name;
    std::string texture;           // base colour, sRGB; empty: `colour` alone
    std::string normalTexture;     // tangent space, +Y up; may be empty
    std::string roughnessTexture;  // grey, linear, times `roughness`; may be empty
    std::string heightTexture;     // grey, linear: what stands out shows first where layers meet; empty: the texture's brightness
    glm::vec3 colour{1};           // linear factor
    float roughness = 0.95f;
    float metres = 4;              // one repeat of the texture, m
    glm::vec2 slope{0, 90};        // degrees from level
    glm::vec2 altitude{-1e5f, 1e5f}; // m
    glm::vec2 flow{0, 1};          // as io::GroundFlow: 0 ridges .. 1 rivers
    float blend = 0.3f;            // width of the transition, share of 15 degrees, 40 m or a fifth of the flow
    std::string steps;             // sounds/…, of feet on it; may be empty
    Extra extra;
    bool operator==(const TerrainLayer&) const = default;
};

struct Terrain {
    std::string heightMap;      // terrain/….png inside the project; empty: no terrain
    std::string coverMap;       // terrain/….png, what was painted on it; empty: nothing
    double metresPerTexel = 1;
    glm::dvec2 origin{0};       // world x and z of texel (0, 0)
    double minHeight = 0;       // m, of the lowest value a file can hold (for float files: not used)
    double maxHeight = 100;     // m, of the highest
    std::vector<TerrainLayer> layers;
    Extra extra;
    bool operator==(const Terrain&) const = default;
};

struct TerrainHit {
    double distance = 0; // m
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 1, 0}; // of the triangle
};

} // namespace io
