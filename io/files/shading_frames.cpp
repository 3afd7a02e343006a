#include "io/files/shading_frames.h"

#include <algorithm>
#include <cmath>

namespace io {
namespace {

template <class Add> void eachTriangle(const Model& model, Add add)
{
    for (const Part& part : model.parts)
        for (std::uint32_t i = part.firstIndex; i + 2 < part.firstIndex + part.indexCount; i += 3)
            add(part, &model.indices[i]);
}

void completeNormals(Model& model, const std::vector<bool>& needed)
{
    std::vector<glm::vec3> sums(model.vertices.size(), glm::vec3{0});
    eachTriangle(model, [&](const Part&, const std::uint32_t* corner) {
        const glm::vec3 a = model.vertices[corner[0]].position;
        const glm::dvec3 ab{model.vertices[corner[1]].position - a};
        const glm::dvec3 ac{model.vertices[corner[2]].position - a};
        const glm::vec3 areaNormal{glm::cross(ab, ac)};
        for (int i = 0; i < 3; ++i)
            sums[corner[i]] += areaNormal;
    });
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (needed[i] && !setUnit(model.vertices[i].normal, sums[i])) model.vertices[i].normal = {0, 1, 0};
}

glm::vec3 anyPerpendicular(const glm::vec3& normal)
{
    const glm::vec3 axis = std::abs(normal.x) < 0.9f ? glm::vec3{1, 0, 0} : glm::vec3{0, 0, 1};
    return glm::normalize(axis - normal * glm::dot(normal, axis));
}

struct Axes {
    glm::vec3 u{0};
    glm::vec3 v{0};
};

// Directions in which u and v grow over a triangle; none where the texture is degenerate.
Axes textureAxes(const Model& model, const std::uint32_t* corner, int uvSet)
{
    const auto uv = [&](int i) {
        const Vertex& vertex = model.vertices[corner[i]];
        return uvSet == 0 ? vertex.uv0 : vertex.uv1;
    };
    const glm::vec3 p1 = model.vertices[corner[1]].position - model.vertices[corner[0]].position;
    const glm::vec3 p2 = model.vertices[corner[2]].position - model.vertices[corner[0]].position;
    const glm::vec2 t1 = uv(1) - uv(0);
    const glm::vec2 t2 = uv(2) - uv(0);
    const float area = t1.x * t2.y - t2.x * t1.y;
    if (!std::isfinite(area) || std::abs(area) < 1e-20f) return {};
    return {(p1 * t2.y - p2 * t1.y) / area, (p2 * t1.x - p1 * t2.x) / area};
}

void completeTangents(Model& model, const std::vector<bool>& needed)
{
    std::vector<Axes> sums(model.vertices.size());
    eachTriangle(model, [&](const Part& part, const std::uint32_t* corner) {
        const Axes axes = textureAxes(model, corner, model.materials[std::size_t(part.material)].normalTexture.uvSet);
        for (int i = 0; i < 3; ++i) {
            sums[corner[i]].u += axes.u;
            sums[corner[i]].v += axes.v;
        }
    });
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!needed[i]) continue;
        Vertex& vertex = model.vertices[i];
        const glm::vec3 normal = vertex.normal;
        glm::vec3 tangent{0};
        if (!setUnit(tangent, sums[i].u - normal * glm::dot(normal, sums[i].u))) tangent = anyPerpendicular(normal);
        // Texture coordinates of glTF grow downwards, so v falls along the bitangent.
        vertex.tangent = {tangent, glm::dot(glm::cross(normal, tangent), sums[i].v) > 0 ? -1.0f : 1.0f};
    }
}

} // namespace

bool setUnit(glm::vec3& target, const glm::vec3& vector)
{
    const double length = glm::length(glm::dvec3{vector});
    if (!std::isfinite(length) || length < 1e-30) return false;
    target = glm::vec3{glm::dvec3{vector} / length};
    return true;
}

void complete(Model& model, const ShadingFrames& frames)
{
    const auto any = [](const std::vector<bool>& needed) {
        return std::find(needed.begin(), needed.end(), true) != needed.end();
    };
    if (any(frames.needsNormal)) completeNormals(model, frames.needsNormal);
    if (any(frames.needsTangent)) completeTangents(model, frames.needsTangent);
}

} // namespace io
