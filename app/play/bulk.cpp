#include "app/play/bulk.h"

#include "app/play/bullet.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <LinearMath/btConvexHullComputer.h>
#include <algorithm>
#include <cmath>

namespace play {
namespace {

constexpr double kMargin = 0.04;      // m, within which Bullet's distances are exact: boxes and hulls are rounded by it, from inside
constexpr double kMeshMargin = 0.004; // m, outside of a mesh
constexpr double kThinnest = 0.01;    // m, half of the thinnest thing

double marginOf(const glm::dvec3& half)
{
    return std::min(kMargin, 0.2 * std::min({half.x, half.y, half.z}));
}

void makeBox(Bulk& bulk, const glm::dvec3& wanted)
{
    const glm::dvec3 half = glm::max(wanted, kThinnest);
    auto box = std::make_unique<btBoxShape>(bullet(half));
    box->setMargin(marginOf(half));
    box->initializePolyhedralFeatures();
    bulk.shape = std::move(box);
    bulk.inner = std::min({half.x, half.y, half.z});
    for (int i = 0; i < 8; ++i)
        bulk.corners.push_back(half * glm::dvec3{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 normal{0};
            normal[axis] = side;
            bulk.planes.push_back({normal, half[axis]});
        }
}

void makeCapsule(Bulk& bulk, const Shape& shape, const glm::dvec3& size)
{
    const int axis = shape.axis;
    const double radius = std::max(kThinnest, shape.radius * std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]));
    const double stem = std::max(0.0, (shape.stem + shape.radius) * size[axis] - radius);
    if (axis == 0) bulk.shape = std::make_unique<btCapsuleShapeX>(radius, 2 * stem);
    else if (axis == 1) bulk.shape = std::make_unique<btCapsuleShape>(radius, 2 * stem);
    else bulk.shape = std::make_unique<btCapsuleShapeZ>(radius, 2 * stem);
    bulk.inner = bulk.rim = radius;
    glm::dvec3 end{0};
    end[axis] = stem;
    bulk.corners = {end, -end};
}

// Bullet clips sides against each other: all corners of two that lie on each other touch at once.
btConvexPolyhedron sidesOf(const btConvexHullComputer& hull, std::vector<Plane>& planes)
{
    btConvexPolyhedron result;
    result.m_vertices = hull.vertices;
    for (int i = 0; i < hull.faces.size(); ++i) {
        btFace face;
        glm::dvec3 area{0};
        const auto* first = &hull.edges[hull.faces[i]];
        const auto* edge = first;
        do {
            face.m_indices.push_back(edge->getSourceVertex());
            area += glm::cross(plain(hull.vertices[edge->getSourceVertex()]), plain(hull.vertices[edge->getTargetVertex()]));
            edge = edge->getNextEdgeOfFace();
        } while (edge != first);
        if (!(glm::length(area) > 1e-12)) continue;
        const glm::dvec3 normal = glm::normalize(area);
        const double distance = glm::dot(normal, plain(hull.vertices[face.m_indices[0]]));
        for (int axis = 0; axis < 3; ++axis)
            face.m_plane[axis] = normal[axis];
        face.m_plane[3] = -distance;
        result.m_faces.push_back(face);
        planes.push_back({normal, distance});
    }
    result.initialize();
    return result;
}

void makeHull(Bulk& bulk, const Shape& shape, const glm::dvec3& scale)
{
    io::WorldBox box;
    for (const glm::dvec3& point : shape.points) {
        bulk.corners.push_back(scale * point);
        box.add(bulk.corners.back());
    }
    const glm::dvec3 half = box.size() / 2.0;
    const double wanted = marginOf(glm::max(half, kThinnest));
    const auto computed = [&bulk](btConvexHullComputer& hull, double shrink) {
        return hull.compute(&bulk.corners[0].x, int(sizeof(glm::dvec3)), int(bulk.corners.size()), shrink, 0.5);
    };
    btConvexHullComputer full, inside;
    computed(full, 0);
    const double shrunk = computed(inside, wanted);
    if (full.vertices.size() < 4 || inside.vertices.size() < 4 || !(shrunk > 0)) { // flat, or less
        bulk.corners.clear();
        return makeBox(bulk, half);
    }
    btConvexPolyhedron sides = sidesOf(full, bulk.planes);
    auto made = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < inside.vertices.size(); ++i)
        made->addPoint(inside.vertices[i], false);
    made->setMargin(shrunk);
    made->setPolyhedralFeatures(sides);
    made->recalcLocalAabb();
    bulk.shape = std::move(made);
    bulk.inner = std::min({half.x, half.y, half.z}) / 2;
}

} // namespace

Bulk::~Bulk() = default;

std::shared_ptr<Bulk> bulkOf(Shapes& shapes, io::TemplateId id, const glm::vec3& scaled)
{
    const Shape& shape = shapes.of(id);
    const glm::dvec3 scale{scaled}, size = glm::max(glm::abs(scale), 1e-6);
    if (shape.form == Form::None) return nullptr;
    auto bulk = std::make_shared<Bulk>();
    if (shape.form == Form::Mesh) {
        if (shape.indices.size() < 3 || !(std::abs(scale.x * scale.y * scale.z) > 1e-15)) return nullptr; // flattened to nothing
        auto& mesh = static_cast<btBvhTriangleMeshShape&>(shapes.tree(id).bullet());
        mesh.setMargin(kMeshMargin);
        bulk->shape = std::make_unique<btScaledBvhTriangleMeshShape>(&mesh, bullet(scale));
        bulk->shape->setMargin(kMeshMargin);
        return bulk;
    }
    bulk->centre = scale * shape.centre;
    if (shape.form == Form::Box) makeBox(*bulk, shape.half * size);
    else if (shape.form == Form::Capsule) makeCapsule(*bulk, shape, size);
    else makeHull(*bulk, shape, scale);
    return bulk;
}

} // namespace play
