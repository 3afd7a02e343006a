#include "projects/make/mesh.h"

#include "io/base/contract.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <unordered_map>

namespace make {
namespace {

glm::vec3 areaNormal(const Triangle& t)
{
    return glm::cross(t.corners[1].position - t.corners[0].position, t.corners[2].position - t.corners[0].position);
}

struct PointHash {
    std::size_t operator()(const glm::ivec3& p) const
    {
        return std::size_t(p.x) * 73856093u ^ std::size_t(p.y) * 19349663u ^ std::size_t(p.z) * 83492791u;
    }
};

glm::ivec3 place(glm::vec3 position) // positions closer than 0.05 mm are one point
{
    return glm::ivec3{glm::round(position * 20000.0f)};
}

void giveTangents(Triangle& t)
{
    const auto& [a, b, c] = t.corners;
    const glm::vec3 ab = b.position - a.position, ac = c.position - a.position;
    const glm::vec2 du = b.uv0 - a.uv0, dv = c.uv0 - a.uv0;
    const float area = du.x * dv.y - dv.x * du.y;
    glm::vec3 right = area != 0 ? (ab * dv.y - ac * du.y) / area : ab;
    const glm::vec3 up = area != 0 ? (ab * dv.x - ac * du.x) / area : ac; // towards smaller v, the picture's top
    for (io::Vertex& corner : t.corners) {
        glm::vec3 tangent = right - corner.normal * glm::dot(corner.normal, right);
        if (glm::dot(tangent, tangent) < 1e-12f)
            tangent =
                glm::cross(corner.normal, glm::abs(corner.normal.x) < 0.9f ? glm::vec3{1, 0, 0} : glm::vec3{0, 1, 0});
        tangent = glm::normalize(tangent);
        corner.tangent = {tangent, glm::dot(glm::cross(corner.normal, tangent), up) < 0 ? -1.0f : 1.0f};
    }
}

// Everything but the tangent decides whether two corners are one vertex; the tangents are then averaged.
std::string keyOf(const io::Vertex& v)
{
    std::array<float, 9> values{v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y,
                                v.normal.z,   v.uv0.x,      v.uv0.y,      v.tangent.w};
    std::string key(sizeof values + 4, '\0');
    std::memcpy(key.data(), values.data(), sizeof values);
    std::memcpy(key.data() + sizeof values, &v.colour, 4);
    return key;
}

int imageIndex(io::Model& model, const Picture& picture)
{
    if (!picture) return -1;
    const auto found = std::find(model.images.begin(), model.images.end(), picture);
    if (found != model.images.end()) return int(found - model.images.begin());
    model.images.push_back(picture);
    return int(model.images.size()) - 1;
}

io::Material materialOf(const Surface& surface, io::Model& model, Textures& textures)
{
    const Texture& texture = textures.get(surface.texture);
    io::Material material{.name = surface.texture,
                          .baseColour = {surface.tint, 1},
                          .metallic = surface.metallic,
                          .roughness = surface.roughness,
                          .emissive = surface.emissive};
    material.baseColourTexture.image = imageIndex(model, texture.colour);
    material.normalTexture.image = imageIndex(model, texture.normal);
    material.doubleSided = surface.twoSided;
    if (surface.leaves) {
        material.alphaMode = io::AlphaMode::Mask;
        material.alphaCutoff = 0.42f;
        material.doubleSided = true;
        material.baseColourTexture.wrapU = material.baseColourTexture.wrapV = io::Wrap::Clamp;
    }
    return material;
}

} // namespace

int Mesh::surface(const Surface& surface)
{
    m_surfaces.push_back(surface);
    return int(m_surfaces.size()) - 1;
}

void Mesh::addQuad(const std::array<io::Vertex, 4>& c, int surface)
{
    add({{c[0], c[1], c[2]}, surface});
    add({{c[0], c[2], c[3]}, surface});
}

void Mesh::append(const Mesh& other, const glm::mat4& to)
{
    const int first = int(m_surfaces.size());
    m_surfaces.insert(m_surfaces.end(), other.m_surfaces.begin(), other.m_surfaces.end());
    const glm::mat3 turn = glm::transpose(glm::inverse(glm::mat3{to}));
    for (Triangle triangle : other.m_triangles) {
        triangle.surface += first;
        for (io::Vertex& corner : triangle.corners) {
            corner.position = glm::vec3{to * glm::vec4{corner.position, 1}};
            corner.normal = glm::normalize(turn * corner.normal);
        }
        m_triangles.push_back(triangle);
    }
}

void smoothNormals(Mesh& mesh, float degrees, int onlySurface)
{
    const float least = glm::cos(glm::radians(degrees));
    const auto concerns = [&](const Triangle& t) { return onlySurface < 0 || t.surface == onlySurface; };
    std::unordered_map<glm::ivec3, std::vector<glm::vec3>, PointHash> faces;
    for (const Triangle& t : mesh.triangles())
        if (concerns(t))
            for (const io::Vertex& corner : t.corners)
                faces[place(corner.position)].push_back(areaNormal(t));
    for (Triangle& t : mesh.triangles()) {
        const glm::vec3 own = areaNormal(t);
        if (!concerns(t) || glm::dot(own, own) == 0) continue;
        for (io::Vertex& corner : t.corners) {
            glm::vec3 sum{0};
            for (const glm::vec3& other : faces[place(corner.position)])
                if (glm::dot(own, other) >= least * glm::length(own) * glm::length(other)) sum += other;
            corner.normal = glm::normalize(glm::dot(sum, sum) > 0 ? sum : own);
        }
    }
}

void projectTexture(Mesh& mesh, float metres, int onlySurface)
{
    for (Triangle& t : mesh.triangles()) {
        if (onlySurface >= 0 && t.surface != onlySurface) continue;
        const glm::vec3 n = glm::abs(areaNormal(t));
        for (io::Vertex& corner : t.corners) {
            const glm::vec3 p = corner.position / metres;
            corner.uv0 = n.y > n.x && n.y > n.z ? glm::vec2{p.x, p.z}
                         : n.x > n.z            ? glm::vec2{p.z, -p.y}
                                                : glm::vec2{p.x, -p.y};
        }
    }
}

io::Model modelOf(const Mesh& mesh, std::string name, Textures& textures)
{
    io::Model model;
    model.name = std::move(name);
    for (int surface = 0; surface < int(mesh.surfaces().size()); ++surface) {
        std::unordered_map<std::string, std::uint32_t> known;
        io::Part part{.firstIndex = std::uint32_t(model.indices.size()), .material = int(model.materials.size())};
        for (Triangle t : mesh.triangles()) {
            if (t.surface != surface) continue;
            giveTangents(t);
            for (const io::Vertex& corner : t.corners) {
                const auto [at, isNew] = known.emplace(keyOf(corner), std::uint32_t(model.vertices.size()));
                if (isNew)
                    model.vertices.push_back(corner);
                else
                    model.vertices[at->second].tangent += glm::vec4{glm::vec3{corner.tangent}, 0};
                model.indices.push_back(at->second);
                model.bounds.add(corner.position);
            }
        }
        part.indexCount = std::uint32_t(model.indices.size()) - part.firstIndex;
        if (part.indexCount == 0) continue;
        model.parts.push_back(part);
        model.materials.push_back(materialOf(mesh.surfaces()[std::size_t(surface)], model, textures));
    }
    for (io::Vertex& vertex : model.vertices) {
        const glm::vec3 sum{vertex.tangent};
        const glm::vec3 flat = sum - vertex.normal * glm::dot(vertex.normal, sum);
        vertex.tangent = {glm::dot(flat, flat) > 1e-12f ? glm::normalize(flat)
                                                        : glm::normalize(glm::cross(vertex.normal, {0.3f, 0.8f, 0.5f})),
                          vertex.tangent.w};
    }
    EXPECTS(!model.parts.empty());
    return model;
}

} // namespace make
