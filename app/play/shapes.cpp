#include "app/play/shapes.h"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <algorithm>
#include <cmath>

namespace play {
namespace {

// A tree is met by its trunk: between these heights, m of the model.
constexpr float kTrunkFrom = 0.5f, kTrunkTo = 2.5f;
constexpr double kThinnest = 0.02; // m; a box or a hull has some body

bool solid(const io::Model& model, const io::Part& part)
{
    const auto material = std::size_t(part.material);
    return material >= model.materials.size() || model.materials[material].alphaMode == io::AlphaMode::Opaque;
}

// Indices of triangles that stop a player; those of all parts where nothing is opaque.
std::vector<std::uint32_t> solidIndices(const io::Model& model)
{
    std::vector<std::uint32_t> result;
    for (const io::Part& part : model.parts)
        if (solid(model, part))
            result.insert(result.end(), model.indices.begin() + part.firstIndex, model.indices.begin() + part.firstIndex + part.indexCount);
    return result.empty() ? model.indices : result;
}

bool finite(const glm::vec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void makeCapsule(Shape& shape, const std::vector<glm::vec3>& points, bool hasLeaves)
{
    const glm::dvec3 size = glm::dvec3{shape.box.size()};
    shape.axis = size.x > size.y && size.x > size.z ? 0 : size.z > size.y && size.z > size.x ? 2 : 1;
    const int u = (shape.axis + 1) % 3, v = (shape.axis + 2) % 3;
    shape.radius = std::max(size[u], size[v]) / 2;
    if (shape.axis == 1 && (hasLeaves || size.y > 3)) {
        glm::dvec2 middle{0};
        std::vector<double> away;
        int count = 0;
        for (const glm::vec3& p : points)
            if (p.y >= kTrunkFrom && p.y <= kTrunkTo) middle += glm::dvec2{p.x, p.z}, ++count;
        if (count >= 6) {
            middle /= count;
            for (const glm::vec3& p : points)
                if (p.y >= kTrunkFrom && p.y <= kTrunkTo) away.push_back(glm::length(glm::dvec2{p.x, p.z} - middle));
            std::ranges::nth_element(away, away.begin() + count / 2);
            shape.radius = std::max(away[std::size_t(count / 2)], kThinnest);
            shape.centre.x = middle.x;
            shape.centre.z = middle.y;
        }
    }
    shape.radius = std::max(shape.radius, kThinnest);
    shape.stem = std::max(0.0, size[shape.axis] / 2 - shape.radius);
}

// The outermost points in 42 directions: a hull that is quick to ask and never sticks out of the model.
void makeHull(Shape& shape, const std::vector<glm::vec3>& points)
{
    btConvexHullShape all;
    for (const glm::vec3& p : points)
        all.addPoint({p.x - shape.centre.x, p.y - shape.centre.y, p.z - shape.centre.z}, false);
    all.setMargin(0);
    all.recalcLocalAabb();
    btShapeHull hull{&all};
    if (points.size() > 42 && hull.buildHull(0) && hull.numVertices() >= 4)
        for (int i = 0; i < hull.numVertices(); ++i)
            shape.points.emplace_back(hull.getVertexPointer()[i].x(), hull.getVertexPointer()[i].y(), hull.getVertexPointer()[i].z());
    else
        for (const glm::vec3& p : points)
            shape.points.emplace_back(glm::dvec3{p} - shape.centre);
}

} // namespace

Shape shapeOf(const io::Template& value, const io::Model& model)
{
    Shape shape;
    if (!isMet(value) || model.indices.empty()) return shape;
    std::vector<std::uint32_t> indices = solidIndices(model);
    std::vector<glm::vec3> points;
    for (const std::uint32_t i : indices)
        if (finite(model.vertices[i].position)) points.push_back(model.vertices[i].position);
    if (points.empty()) return shape;
    std::ranges::sort(points, [](const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const glm::vec3& p : points)
        shape.box.add(p);
    shape.centre = shape.box.centre();
    shape.half = glm::max(glm::dvec3{shape.box.size()} / 2.0, kThinnest / 2);

    const bool mesh = value.collision == io::Collision::Mesh;
    switch (value.collision) {
    case io::Collision::Capsule:
        shape.form = Form::Capsule;
        makeCapsule(shape, points, indices.size() < model.indices.size());
        return shape;
    case io::Collision::None:
    case io::Collision::Box: shape.form = Form::Box; return shape;
    default: break;
    }
    if (mesh && !value.body.dynamic) {
        shape.form = Form::Mesh;
        for (const io::Vertex& vertex : model.vertices)
            shape.vertices.emplace_back(finite(vertex.position) ? vertex.position : glm::vec3{shape.centre});
        shape.indices = std::move(indices);
    } else { // what moves by itself is hulls: Bullet moves no meshes
        const glm::vec3 size = shape.box.size();
        shape.form = std::min({size.x, size.y, size.z}) < float(kThinnest) ? Form::Box : Form::Hull;
        if (shape.form == Form::Hull) makeHull(shape, points);
    }
    return shape;
}

struct MeshTree::State {
    btTriangleIndexVertexArray arrays;
    std::unique_ptr<btBvhTriangleMeshShape> shape;
};

MeshTree::MeshTree(const Shape& shape) : m_state{std::make_unique<State>()}
{
    btIndexedMesh mesh;
    mesh.m_numTriangles = int(shape.indices.size() / 3);
    mesh.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(shape.indices.data());
    mesh.m_triangleIndexStride = 3 * sizeof(std::uint32_t);
    mesh.m_numVertices = int(shape.vertices.size());
    mesh.m_vertexBase = reinterpret_cast<const unsigned char*>(shape.vertices.data());
    mesh.m_vertexStride = sizeof(glm::dvec3);
    mesh.m_vertexType = PHY_DOUBLE;
    m_state->arrays.addIndexedMesh(mesh, PHY_INTEGER);
    m_state->shape = std::make_unique<btBvhTriangleMeshShape>(&m_state->arrays, true);
}

MeshTree::~MeshTree() = default;

void MeshTree::touching(const io::BoxOf<glm::dvec3>& box, std::vector<std::uint32_t>& triangles) const
{
    struct Collect final : btNodeOverlapCallback {
        std::vector<std::uint32_t>& found;
        explicit Collect(std::vector<std::uint32_t>& into) : found{into} {}
        void processNode(int, int triangle) override { found.push_back(std::uint32_t(triangle) * 3); }
    } collect{triangles};
    m_state->shape->getOptimizedBvh()->reportAabbOverlappingNodex(&collect, {box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z});
    std::ranges::sort(triangles);
}

btCollisionShape& MeshTree::bullet() const
{
    return *m_state->shape;
}

struct Shapes::Kept {
    Shape shape;
    std::unique_ptr<MeshTree> tree;
};

Shapes::Shapes(const io::Scene& scene, const io::Assets& assets) : m_scene{scene}, m_assets{assets} {}
Shapes::~Shapes() = default;

const Shape& Shapes::of(io::TemplateId id)
{
    static const Shape kNone;
    const io::Template* value = m_scene.find(id);
    const io::Model* model = m_assets.model(id);
    if (!value || !model) return kNone;
    if (m_kept.size() < number(id)) m_kept.resize(number(id));
    std::unique_ptr<Kept>& kept = m_kept[number(id) - 1];
    if (!kept) kept = std::make_unique<Kept>(Kept{shapeOf(*value, *model), nullptr});
    return kept->shape;
}

const MeshTree& Shapes::tree(io::TemplateId id)
{
    const Shape& shape = of(id);
    Kept& kept = *m_kept[number(id) - 1];
    if (!kept.tree) kept.tree = std::make_unique<MeshTree>(shape);
    return *kept.tree;
}

} // namespace play
