// What templates are to things that run into them: made of their models when first met, and kept.
#pragma once

#include "app/play/closest.h"
#include "io/scene/assets.h"

#include <memory>
#include <span>
#include <vector>

class btConvexShape;
class btCollisionShape;

namespace play {

enum class Form { None, Box, Capsule, Hull, Mesh };

// In model space. Leaves and whatever else is cut out of pictures let things through.
struct Shape {
    Form form = Form::None;
    io::Box box;                    // around it
    glm::dvec3 centre{0};           // of box and capsule, and what a hull's points are counted from
    glm::dvec3 half{0};             // of a box
    int axis = 1;                   // of a capsule
    double radius = 0, stem = 0;    // of a capsule; stem: half the length of its segment
    std::vector<glm::dvec3> points; // of a hull, from the centre; at most 256
    std::vector<glm::dvec3> vertices;
    std::vector<std::uint32_t> indices; // of a mesh
};

// visit(first index) for triangles of a mesh that touch a box of model space; the tree is made when first asked.
class MeshTree {
public:
    explicit MeshTree(const Shape& shape);
    ~MeshTree();
    void touching(const io::BoxOf<glm::dvec3>& box, std::vector<std::uint32_t>& triangles) const; // sorted
    btCollisionShape& bullet() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

// What falls and rolls is met, whatever its template says: without a shape of its own it is its box.
inline bool isMet(const io::Template& value)
{
    return value.collision != io::Collision::None || value.body.dynamic;
}
Shape shapeOf(const io::Template& value, const io::Model& model);
bool inside(const Shape& mesh, const MeshTree& tree, const glm::dvec3& at); // in model space: behind its faces wherever one looks

class Shapes {
public:
    Shapes(const io::Scene& scene, const io::Assets& assets);
    ~Shapes();
    const Shape& of(io::TemplateId id); // of form None where there is nothing to run into
    const MeshTree& tree(io::TemplateId id);

private:
    struct Kept;
    const io::Scene& m_scene;
    const io::Assets& m_assets;
    std::vector<std::unique_ptr<Kept>> m_kept;
};

} // namespace play
