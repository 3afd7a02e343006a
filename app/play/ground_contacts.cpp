#include "app/play/ground_contacts.h"

#include "app/play/bullet.h"
#include "app/play/closest.h"
#include "app/play/ground_shape.h"
#include "io/scene/ground.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <algorithm>
#include <cmath>
#include <new>
#include <optional>

namespace play {
namespace {

constexpr double kReach = 0.02; // m above the ground, where contacts begin
constexpr double kDeep = 0.3;   // m below it, where a corner is under it rather than in it
constexpr double kAlong = 0.2;  // m between the points that are looked at along a ridge
constexpr double kFlat = 1e-3;  // m, by which a ridge stands out

class GroundContacts final : public btCollisionAlgorithm {
public:
    GroundContacts(btCollisionDispatcher& dispatcher, const Bulk& bulk, const btCollisionObject& body, const btCollisionObject& ground)
        : m_bulk{bulk}, m_scene{sceneOf(*ground.getCollisionShape())}, m_map{*m_scene.heights()}, m_manifold{dispatcher.getNewManifold(&body, &ground)}
    {
        m_dispatcher = &dispatcher;
    }
    ~GroundContacts() override { m_dispatcher->releaseManifold(m_manifold); }

    void processCollision(const btCollisionObjectWrapper* body, const btCollisionObjectWrapper*, const btDispatcherInfo&, btManifoldResult* result) override
    {
        result->setPersistentManifold(m_manifold);
        m_at = plain(body->getWorldTransform().getOrigin());
        m_turn = glm::mat3_cast(plain(body->getWorldTransform().getRotation()));
        const auto ground = io::groundHeight(m_scene, m_at.x, m_at.z);
        if (!ground || m_at.y > *ground) {
            btVector3 low, high;
            body->getCollisionShape()->getAabb(body->getWorldTransform(), low, high);
            if (reaches(plain(low), plain(high))) {
                if (m_bulk.rim > 0) balls(*result);
                else corners(*result);
                ridges(*result);
            }
        }
        result->refreshContactPoints();
    }
    btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*) override { return 1; }
    void getAllContactManifolds(btManifoldArray& manifolds) override { manifolds.push_back(m_manifold); }

private:
    struct Face {
        Triangle corners;
        glm::dvec3 normal;
        glm::ivec3 name; // cell and half
    };
    glm::dvec3 corner(int x, int z) const
    {
        const glm::dvec2 at = m_map.origin + glm::dvec2{x, z} * m_map.metresPerTexel;
        return {at.x, m_map.at(x, z), at.y};
    }
    // Over which triangle a place is: none beside the map and in holes.
    std::optional<Face> faceAt(double x, double z) const
    {
        const glm::dvec2 texel = (glm::dvec2{x, z} - m_map.origin) / m_map.metresPerTexel;
        const glm::ivec2 cell{glm::floor(texel)};
        if (cell.x < 0 || cell.y < 0 || cell.x > m_map.size.x - 2 || cell.y > m_map.size.y - 2) return std::nullopt;
        if (io::holeAt(m_map, m_scene.cover().get(), x, z)) return std::nullopt;
        const glm::dvec2 rest = texel - glm::dvec2{cell};
        const glm::dvec3 b = corner(cell.x + 1, cell.y), c = corner(cell.x, cell.y + 1);
        Face face{{}, {}, {cell, rest.x + rest.y > 1}};
        face.corners = face.name.z ? Triangle{b, c, corner(cell.x + 1, cell.y + 1)} : Triangle{corner(cell.x, cell.y), c, b};
        face.normal = faceNormal(face.corners);
        return face;
    }
    bool touches(double distance) const { return distance < kReach && distance > -std::max(kDeep, m_bulk.inner); }

    // Notes over which texels the body is, and whether any of them comes up to it.
    bool reaches(const glm::dvec3& low, const glm::dvec3& high)
    {
        m_low = low;
        m_high = high;
        const glm::dvec2 last{m_map.size - 1};
        const auto texel = [&](const glm::dvec3& at) { return (glm::dvec2{at.x, at.z} - m_map.origin) / m_map.metresPerTexel; };
        m_from = glm::ivec2{glm::clamp(glm::floor(texel(low)), glm::dvec2{0}, last)};
        m_to = glm::ivec2{glm::clamp(glm::ceil(texel(high)), glm::dvec2{0}, last)};
        for (int z = m_from.y; z <= m_to.y; ++z)
            for (int x = m_from.x; x <= m_to.x; ++x)
                if (m_map.at(x, z) + kReach > low.y) return true;
        return false;
    }

    void corners(btManifoldResult& result) const
    {
        for (const glm::dvec3& local : m_bulk.corners) {
            const glm::dvec3 point = m_at + m_turn * local;
            const auto face = faceAt(point.x, point.z);
            if (!face) continue;
            const double distance = glm::dot(point - face->corners[0], face->normal);
            if (touches(distance)) result.addContactPoint(bullet(face->normal), bullet(point - face->normal * distance), distance);
        }
    }
    // Of a capsule: its ends against the triangles around what they are over.
    void balls(btManifoldResult& result) const
    {
        const double aside = m_bulk.rim * 0.7;
        for (const glm::dvec3& local : m_bulk.corners) {
            const glm::dvec3 middle = m_at + m_turn * local;
            for (const glm::dvec2& way : {glm::dvec2{0, 0}, {aside, 0}, {-aside, 0}, {0, aside}, {0, -aside}}) {
                const auto face = faceAt(middle.x + way.x, middle.z + way.y);
                if (!face) continue;
                const double apart = glm::dot(middle - face->corners[0], face->normal);
                const glm::dvec3 foot = middle - face->normal * apart;
                const auto under = faceAt(foot.x, foot.z);
                if (under && under->name == face->name && touches(apart - m_bulk.rim)) result.addContactPoint(bullet(face->normal), bullet(foot), apart - m_bulk.rim);
            }
        }
    }
    // Edges between cells where the ground bends down on both sides.
    void ridges(btManifoldResult& result) const
    {
        const auto has = [&](int x, int z) { return x >= 0 && z >= 0 && x <= m_map.size.x - 1 && z <= m_map.size.y - 1; };
        const auto ridge = [&](glm::ivec2 a, glm::ivec2 b, glm::ivec2 left, glm::ivec2 right) {
            if (!has(b.x, b.y) || !has(a.x, a.y) || !has(left.x, left.y) || !has(right.x, right.y)) return;
            const glm::dvec3 p = corner(a.x, a.y), q = corner(b.x, b.y);
            if (std::max(p.y, q.y) < m_low.y - kReach || m_map.at(left.x, left.y) + m_map.at(right.x, right.y) > p.y + q.y - kFlat) return;
            const glm::dvec3 l = corner(left.x, left.y), r = corner(right.x, right.y);
            const auto up = [](glm::dvec3 n) { return glm::normalize(n.y < 0 ? -n : n); };
            along(p, q, glm::normalize(up(glm::cross(q - p, l - p)) + up(glm::cross(q - p, r - p))), result);
        };
        for (int z = m_from.y; z <= m_to.y; ++z)
            for (int x = m_from.x; x <= m_to.x; ++x) {
                ridge({x, z}, {x + 1, z}, {x + 1, z - 1}, {x, z + 1});
                ridge({x, z}, {x, z + 1}, {x - 1, z + 1}, {x + 1, z});
                ridge({x + 1, z}, {x, z + 1}, {x, z}, {x + 1, z + 1});
            }
    }
    void along(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& normal, btManifoldResult& result) const
    {
        // The part of the edge over which the body is.
        double from = 0, to = 1;
        for (const int axis : {0, 2}) {
            const double way = q[axis] - p[axis];
            if (std::abs(way) < 1e-9) {
                if (p[axis] < m_low[axis] || p[axis] > m_high[axis]) return;
                continue;
            }
            const double a = (m_low[axis] - p[axis]) / way, b = (m_high[axis] - p[axis]) / way;
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        if (from > to) return;
        const int count = std::min(1 + int(glm::length(q - p) * (to - from) / kAlong), 32);
        for (int i = 0; i <= count; ++i) {
            const glm::dvec3 point = glm::mix(p, q, from + (to - from) * i / count);
            if (io::holeAt(m_map, m_scene.cover().get(), point.x, point.z)) continue;
            if (const auto distance = inside(point, normal); distance && touches(*distance)) result.addContactPoint(bullet(normal), bullet(point), *distance);
        }
    }
    // How far a point of the ground is from the body's underside as the ground faces it; below 0 inside of the body.
    std::optional<double> inside(const glm::dvec3& point, const glm::dvec3& normal) const
    {
        const glm::dvec3 at = (point - m_at) * m_turn, down = -(normal * m_turn); // of the body
        if (m_bulk.rim > 0) {
            const Nearest nearest = nearestOfSegments(at, at, m_bulk.corners[0], m_bulk.corners[1]);
            return std::sqrt(nearest.squared) - m_bulk.rim;
        }
        double leaves = 1e9, enters = -1e9; // m along `down`
        for (const Plane& plane : m_bulk.planes) {
            const double height = plane.distance - glm::dot(plane.normal, at), slope = glm::dot(plane.normal, down);
            if (slope > 1e-9) leaves = std::min(leaves, height / slope);
            else if (slope < -1e-9) enters = std::max(enters, height / slope);
            else if (height < 0) return std::nullopt;
        }
        if (enters > leaves || enters > 0) return std::nullopt; // beside it, or over its upper side
        return -leaves;
    }

    const Bulk& m_bulk;
    const io::Scene& m_scene;
    const io::HeightMap& m_map;
    btPersistentManifold* m_manifold;
    glm::dvec3 m_at{0}, m_low{0}, m_high{0}; // of the body at hand, and the box around it
    glm::ivec2 m_from{0}, m_to{0};           // texels under it
    glm::dmat3 m_turn{1};
};

static_assert(sizeof(GroundContacts) <= kGroundContactsSize);

} // namespace

btCollisionAlgorithm* groundContacts(btCollisionDispatcher& dispatcher, const Bulk& bulk, const btCollisionObject& body, const btCollisionObject& ground)
{
    return new (dispatcher.allocateCollisionAlgorithm(sizeof(GroundContacts))) GroundContacts{dispatcher, bulk, body, ground};
}

} // namespace play
