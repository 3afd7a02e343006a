#include "io/files/surface_distance.h"

#include <algorithm>
#include <limits>

namespace io {
namespace {

constexpr std::uint32_t kLeaf = 4;
constexpr int kDeepest = 60; // of the tree; a walk's stack holds one more than this

float squared(const glm::vec3& v)
{
    return glm::dot(v, v);
}

float squaredToEdge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& point)
{
    const glm::vec3 edge = b - a;
    const float length = squared(edge);
    const float along = length > 0 ? std::clamp(glm::dot(point - a, edge) / length, 0.0f, 1.0f) : 0.0f;
    return squared(point - (a + edge * along));
}

glm::vec3 centre(const SurfaceDistance::Triangle& t)
{
    return (t[0] + t[1] + t[2]) * (1.0f / 3);
}

} // namespace

float squaredDistance(const SurfaceDistance::Triangle& t, const glm::vec3& point)
{
    const glm::vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const float area = squared(normal);
    if (area > 0) {
        const auto inside = [&](int a, int b) { return glm::dot(glm::cross(t[b] - t[a], point - t[a]), normal) >= 0; };
        if (inside(0, 1) && inside(1, 2) && inside(2, 0)) {
            const float height = glm::dot(point - t[0], normal);
            return height * height / area;
        }
    }
    return std::min(
        {squaredToEdge(t[0], t[1], point), squaredToEdge(t[1], t[2], point), squaredToEdge(t[2], t[0], point)});
}

SurfaceDistance::SurfaceDistance(std::vector<Triangle> triangles) : m_triangles{std::move(triangles)}
{
    if (m_triangles.empty()) return;
    m_nodes.reserve(m_triangles.size());
    m_nodes.emplace_back();
    build(0, 0, std::uint32_t(m_triangles.size()), 0);
}

void SurfaceDistance::build(std::uint32_t node, std::uint32_t first, std::uint32_t count, int depth)
{
    const auto begin = m_triangles.begin() + first, end = begin + count;
    Node made{.min = glm::vec3{std::numeric_limits<float>::max()},
              .first = first,
              .max = glm::vec3{std::numeric_limits<float>::lowest()},
              .count = count};
    for (auto t = begin; t != end; ++t)
        for (const glm::vec3& corner : *t) {
            made.min = glm::min(made.min, corner);
            made.max = glm::max(made.max, corner);
        }
    if (count > kLeaf && depth < kDeepest) {
        const glm::vec3 size = made.max - made.min;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = count / 2;
        std::nth_element(begin, begin + half, end, [axis](const Triangle& a, const Triangle& b) {
            return centre(a)[axis] < centre(b)[axis];
        });
        made.first = std::uint32_t(m_nodes.size());
        made.count = 0;
        m_nodes.resize(m_nodes.size() + 2);
        build(made.first, first, half, depth + 1);
        build(made.first + 1, first + half, count - half, depth + 1);
    }
    m_nodes[node] = made;
}

float SurfaceDistance::squaredToBox(const Node& node, const glm::vec3& point) const
{
    return squared(point - glm::clamp(point, node.min, node.max));
}

float SurfaceDistance::to(const glm::vec3& point, float enough) const
{
    float best = std::numeric_limits<float>::infinity();
    if (m_nodes.empty()) return best;
    std::array<std::uint32_t, kDeepest + 4> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0 && best > enough * enough) {
        const Node& node = m_nodes[waiting[--count]];
        if (squaredToBox(node, point) >= best) continue;
        for (std::uint32_t i = 0; i < node.count; ++i)
            best = std::min(best, squaredDistance(m_triangles[node.first + i], point));
        if (node.count > 0) continue;
        // The nearer child comes off the stack first.
        const bool leftNearer = squaredToBox(m_nodes[node.first], point) <= squaredToBox(m_nodes[node.first + 1], point);
        waiting[count++] = node.first + (leftNearer ? 1 : 0);
        waiting[count++] = node.first + (leftNearer ? 0 : 1);
    }
    return std::sqrt(best);
}

} // namespace io
