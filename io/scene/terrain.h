// The ground: how a height map lies in the world, what covers it, and the surface that it makes.
#pragma once

#include "io/scene/bounds.h"
#include "io/scene/extra.h"

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace io {

// One covering of the ground, shown where its rules hold; later layers lie over earlier ones.
struct TerrainLayer {
    std::string name;
    std::string texture;           // base colour, sRGB; empty: `colour` alone
    std::string normalTexture;     // tangent space, +Y up; may be empty
    glm::vec3 colour{1};           // linear factor
    float roughness = 0.95f;
    float metres = 4;              // one repeat of the texture, m
    glm::vec2 slope{0, 90};        // degrees from level
    glm::vec2 altitude{-1e5f, 1e5f}; // m
    float blend = 0.3f;            // width of the transition, share of 15 degrees or 40 m
    Extra extra;
    bool operator==(const TerrainLayer&) const = default;
};

struct Terrain {
    std::string heightMap;      // terrain/….png inside the project; empty: no terrain
    double metresPerTexel = 1;
    glm::dvec2 origin{0};       // world x and z of texel (0, 0)
    double minHeight = 0;       // m, of the lowest value a file can hold (for float files: not used)
    double maxHeight = 100;     // m, of the highest
    std::vector<TerrainLayer> layers;
    Extra extra;
    bool operator==(const Terrain&) const = default;
};

// Heights in metres, row by row from -Z to +Z. A texel is a vertex; a square of four is two triangles that
// share the diagonal from (x+1, z) to (x, z+1). The renderer draws exactly this surface near the camera.
struct HeightMap {
    glm::ivec2 size{0};
    std::vector<float> metres;
    double metresPerTexel = 1;
    glm::dvec2 origin{0};
    float min = 0;
    float max = 0;

    float at(int x, int z) const { return metres[std::size_t(z) * size.x + x]; } // texel, in range
    bool contains(double x, double z) const;                                     // world, m
    std::optional<double> height(double x, double z) const;                      // of the triangle there
    std::optional<glm::dvec3> normal(double x, double z) const;                  // smooth, from the neighbours
};

struct TerrainHit {
    double distance = 0; // m
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 1, 0}; // of the triangle
};

} // namespace io
