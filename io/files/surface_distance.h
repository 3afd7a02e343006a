// How far points lie from a surface of triangles: a box tree for nearest-triangle questions.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace io {

class SurfaceDistance {
public:
    using Triangle = std::array<glm::vec3, 3>;
    explicit SurfaceDistance(std::vector<Triangle> triangles); // finite corners
    bool empty() const { return m_triangles.empty(); }
    // Infinite when there is no triangle. What is not farther than `enough` need not be exact (Taha and Hanbury 2015:
    // the farthest of many points is found without the distance of most).
    float to(const glm::vec3& point, float enough = 0) const;

private:
    struct Node {
        glm::vec3 min{0};
        std::uint32_t first = 0; // triangle, or the first of two child nodes
        glm::vec3 max{0};
        std::uint32_t count = 0; // of triangles; 0: an inner node
    };
    void build(std::uint32_t node, std::uint32_t first, std::uint32_t count, int depth);
    float squaredToBox(const Node& node, const glm::vec3& point) const;

    std::vector<Triangle> m_triangles; // in the order of the leaves
    std::vector<Node> m_nodes;
};

// Distance to one triangle, squared; zero-area triangles count as their edges.
float squaredDistance(const SurfaceDistance::Triangle& triangle, const glm::vec3& point);

} // namespace io
