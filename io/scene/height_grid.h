// A field of heights as plain rows: what files hold, brushes work on and generators make. io::HeightMap is the ground itself.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace io {

// Heights in metres, row by row from -Z to +Z. A texel is a vertex; a square of four is two triangles that share the diagonal
// from (x+1, z) to (x, z+1).
struct HeightGrid {
    glm::ivec2 size{0};
    std::vector<float> metres;
    double metresPerTexel = 1;
    glm::dvec2 origin{0}; // world x and z of texel (0, 0)

    float at(int x, int z) const { return metres[std::size_t(z) * size.x + x]; } // texel, in range
    float& at(int x, int z) { return metres[std::size_t(z) * size.x + x]; }
    float clampedAt(int x, int z) const { return at(glm::clamp(x, 0, size.x - 1), glm::clamp(z, 0, size.y - 1)); }
    bool contains(double x, double z) const;                    // world, m
    std::optional<double> height(double x, double z) const;     // of the triangle there
    std::optional<glm::dvec3> normal(double x, double z) const; // smooth, from the neighbours
};

} // namespace io
