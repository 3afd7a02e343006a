#include "io/files/draw_order.h"

#include <algorithm>
#include <cmath>
#include <meshoptimizer.h>
#include <span>

namespace io {
namespace {

constexpr float kOverdraw = 1.05f; // vertex cache misses may grow by 5 % for less overdraw

bool finite(const Model& model, std::span<const std::uint32_t> indices)
{
    return std::all_of(indices.begin(), indices.end(), [&](std::uint32_t index) {
        const glm::vec3& p = model.vertices[index].position;
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

// Works on the part's own vertices, so that a small part of a large model costs little.
void order(const Model& model, std::vector<std::uint32_t>& all, const Part& part)
{
    if (part.indexCount < 6) return;
    if (model.materials[std::size_t(part.material)].alphaMode == AlphaMode::Blend) return;
    const std::span<std::uint32_t> indices{all.data() + part.firstIndex, part.indexCount};
    std::vector<std::uint32_t> used{indices.begin(), indices.end()};
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<glm::vec3> positions;
    for (const std::uint32_t vertex : used)
        positions.push_back(model.vertices[vertex].position);
    std::vector<std::uint32_t> own, ordered(indices.size());
    own.reserve(indices.size());
    for (const std::uint32_t index : indices)
        own.push_back(std::uint32_t(std::lower_bound(used.begin(), used.end(), index) - used.begin()));
    meshopt_optimizeVertexCache(ordered.data(), own.data(), own.size(), used.size());
    if (finite(model, indices)) {
        own = ordered;
        meshopt_optimizeOverdraw(ordered.data(), own.data(), own.size(), &positions[0].x, positions.size(),
                                 sizeof(glm::vec3), kOverdraw);
    }
    for (std::size_t i = 0; i < ordered.size(); ++i)
        indices[i] = used[ordered[i]];
}

} // namespace

std::vector<std::uint32_t> optimiseDrawOrder(Model& model)
{
    for (const Part& part : model.parts)
        order(model, model.indices, part);
    for (Level& level : model.levels)
        for (const Part& part : level.parts)
            order(model, level.indices, part);
    return renumberVertices(model);
}

std::vector<std::uint32_t> renumberVertices(Model& model)
{
    std::vector<std::uint32_t> numbers(model.vertices.size(), ~0u), old;
    const auto take = [&](std::vector<std::uint32_t>& indices) {
        for (std::uint32_t& index : indices) {
            if (numbers[index] == ~0u) {
                numbers[index] = std::uint32_t(old.size());
                old.push_back(index);
            }
            index = numbers[index];
        }
    };
    take(model.indices);
    for (Level& level : model.levels)
        take(level.indices);
    std::vector<Vertex> vertices;
    vertices.reserve(old.size());
    for (const std::uint32_t vertex : old)
        vertices.push_back(model.vertices[vertex]);
    model.vertices = std::move(vertices);
    return old;
}

} // namespace io
