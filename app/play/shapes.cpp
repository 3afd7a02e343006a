#include "app/play/shapes.h"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <LinearMath/btConvexHullComputer.h>
#include <algorithm>
#include <cmath>
#include <optional>

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

// The corners of the convex hull. Of one with many, the outermost in 256 directions: it never sticks out of the model and is
// quick to ask.
void makeHull(Shape& shape, const std::vector<glm::vec3>& points)
{
    constexpr int kMostCorners = 64, kFine = 1;
    std::vector<btVector3> all;
    for (const glm::vec3& p : points)
        all.emplace_back(p.x - shape.centre.x, p.y - shape.centre.y, p.z - shape.centre.z);
    btConvexHullComputer exact;
    exact.compute(&all[0].x(), sizeof(btVector3), int(all.size()), 0, 0);
    std::vector<int> corners; // of the model, for the computer's own are rounded
    for (int i = 0; i < exact.original_vertex_index.size(); ++i)
        corners.push_back(exact.original_vertex_index[i]);
    std::ranges::sort(corners);
    std::vector<btVector3> found;
    for (const int i : corners)
        found.push_back(all[std::size_t(i)]);
    if (found.size() > kMostCorners) {
        btConvexHullShape outer{&found[0].x(), int(found.size())};
        outer.setMargin(0);
        btShapeHull hull{&outer};
        if (hull.buildHull(0, kFine) && hull.numVertices() >= 4) found.assign(hull.getVertexPointer(), hull.getVertexPointer() + hull.numVertices());
    }
    for (const btVector3& p : found)
        shape.points.emplace_back(p.x(), p.y(), p.z());
}

// Where a ray meets a triangle: how far along it, and whether from behind. Nothing: it is missed (Moeller and Trumbore 1997).
struct Met {
    double far;
    bool behind;
};
std::optional<Met> along(const glm::dvec3& at, const glm::dvec3& way, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 u = b - a, v = c - a, p = glm::cross(way, v);
    const double turned = glm::dot(u, p);
    if (std::abs(turned) < 1e-12) return std::nullopt;
    const glm::dvec3 from = at - a, q = glm::cross(from, u);
    const double x = glm::dot(from, p) / turned, y = glm::dot(way, q) / turned, far = glm::dot(v, q) / turned;
    if (x < 0 || y < 0 || x + y > 1 || far < 0) return std::nullopt;
    return Met{far, turned < 0};
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

bool inside(const Shape& mesh, const MeshTree& tree, const glm::dvec3& at)
{
    std::vector<std::uint32_t> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 way{0}, end = at;
            way[axis] = side;
            end[axis] = side < 0 ? mesh.box.min[axis] - 0.1 : mesh.box.max[axis] + 0.1;
            triangles.clear();
            tree.touching({glm::min(at, end) - 1e-4, glm::max(at, end) + 1e-4}, triangles);
            std::optional<Met> nearest;
            for (const std::uint32_t first : triangles) {
                const auto corner = [&](std::uint32_t i) { return mesh.vertices[mesh.indices[first + i]]; };
                if (const auto met = along(at, way, corner(0), corner(1), corner(2)); met && (!nearest || met->far < nearest->far)) nearest = met;
            }
            if (!nearest || !nearest->behind) return false;
        }
    return true;
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
