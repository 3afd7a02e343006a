#include "io/files/level_parts.h"

#include <algorithm>
#include <cmath>
#include <meshoptimizer.h>
#include <numeric>
#include <unordered_map>

namespace io::levels {
namespace {

// Sets that grow together (Tarjan's union by halving of paths).
class Sets {
public:
    explicit Sets(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }
    std::uint32_t find(std::uint32_t i)
    {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        const std::uint32_t x = find(a), y = find(b);
        m_parent[std::max(x, y)] = std::min(x, y);
    }

private:
    std::vector<std::uint32_t> m_parent;
};

bool finite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

SurfaceDistance::Triangle positionsOf(const Model& model, const Corners& corners)
{
    return {model.vertices[corners.vertex[0]].position, model.vertices[corners.vertex[1]].position,
            model.vertices[corners.vertex[2]].position};
}

float areaOf(const SurfaceDistance::Triangle& t)
{
    return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2;
}

std::vector<Corners> drawnTriangles(const Model& model, std::uint32_t part)
{
    std::vector<Corners> result;
    const Part& range = model.parts[part];
    result.reserve(range.indexCount / 3);
    for (std::uint32_t i = range.firstIndex; i + 2 < range.firstIndex + range.indexCount; i += 3) {
        const Corners corners{{model.indices[i], model.indices[i + 1], model.indices[i + 2]}, part};
        const SurfaceDistance::Triangle t = positionsOf(model, corners);
        const float area = areaOf(t);
        if (finite(t[0]) && finite(t[1]) && finite(t[2]) && std::isfinite(area) && area > 0) result.push_back(corners);
    }
    return result;
}

std::vector<std::uint32_t> placesOf(const Model& model)
{
    std::vector<glm::vec3> positions;
    positions.reserve(model.vertices.size());
    for (const Vertex& vertex : model.vertices)
        positions.push_back(vertex.position + 0.0f); // -0 becomes 0
    std::vector<std::uint32_t> places(positions.size());
    meshopt_generateVertexRemap(places.data(), nullptr, positions.size(), positions.data(), positions.size(),
                                sizeof(glm::vec3));
    return places;
}

std::vector<std::uint32_t> componentsOf(std::span<const Corners> triangles, std::span<const std::uint32_t> places,
                                        Joined joined)
{
    Sets sets{triangles.size()};
    std::unordered_map<std::uint64_t, std::uint32_t> firstAt;
    firstAt.reserve(triangles.size() * 2);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (int side = 0; side < 3; ++side) {
            const std::uint64_t a = places[triangles[i].vertex[std::size_t(side)]];
            const std::uint64_t b = places[triangles[i].vertex[std::size_t(side + 1) % 3]];
            const std::uint64_t key = joined == Joined::AtVertices ? a : std::min(a, b) << 32 | std::max(a, b);
            const auto [found, fresh] = firstAt.try_emplace(key, i);
            if (!fresh) sets.join(i, found->second);
        }
    }
    std::vector<std::uint32_t> result(triangles.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) // a set's root is its first triangle
        result[i] = sets.find(i) == i ? count++ : result[sets.find(i)];
    return result;
}

} // namespace io::levels
