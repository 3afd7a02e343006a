// A mesh being built: loose triangles with all they need, so that they can be split, bent and counted freely.
#pragma once

#include "io/scene/model.h"
#include "projects/make/textures.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace make {

struct Triangle {
    std::array<io::Vertex, 3> corners; // counter-clockwise is the front; tangents are made by modelOf
    int surface = 0;
};

// What a mesh is made of, by the name of its textures.
struct Surface {
    std::string texture;
    glm::vec3 tint{1}; // linear, multiplies the texture
    float roughness = 0.9f;
    float metallic = 0;
    bool leaves = false;   // alpha mask, both sides
    bool twoSided = false; // cloth
    glm::vec3 emissive{0};
};

class Mesh {
public:
    int surface(const Surface& surface); // its number
    void add(const Triangle& triangle) { m_triangles.push_back(triangle); }
    void addQuad(const std::array<io::Vertex, 4>& corners, int surface); // around its border
    void append(const Mesh& other, const glm::mat4& to = glm::mat4{1});

    std::size_t count() const { return m_triangles.size(); }
    std::vector<Triangle>& triangles() { return m_triangles; }
    const std::vector<Triangle>& triangles() const { return m_triangles; }
    const std::vector<Surface>& surfaces() const { return m_surfaces; }

private:
    std::vector<Triangle> m_triangles;
    std::vector<Surface> m_surfaces;
};

// Splits the longest edges until there are exactly `count` triangles. A split edge lies where it lay, unless `move`
// puts its new point elsewhere (roughness, roundness). Needs an open border somewhere when the rest is odd.
void refineTo(Mesh& mesh, std::size_t count, const std::function<void(io::Vertex&)>& move = {});

// Normals from the faces: smooth where neighbours meet at less than `degrees`, sharp where at more.
void smoothNormals(Mesh& mesh, float degrees, int onlySurface = -1);

// Texture coordinates by projection along each face's main axis, `metres` to one repeat.
void projectTexture(Mesh& mesh, float metres, int onlySurface = -1);

// Equal corners become one vertex, tangents follow the texture, one part for each surface.
io::Model modelOf(const Mesh& mesh, std::string name, Textures& textures);

} // namespace make
