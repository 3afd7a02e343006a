#include "app/play/narrow.h"

#include "app/play/swept_box.h"

#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <algorithm>
#include <cmath>

namespace play {
namespace {

constexpr int kMostAdvances = 48;
constexpr double kClose = 1e-4; // m; a sweep ends this near to kTouch

btVector3 bullet(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}
glm::dvec3 plain(const btVector3& v)
{
    return {v.x(), v.y(), v.z()};
}

// From the nearest points of two segments, or of one and a triangle.
Contact fromNearest(const Nearest& nearest, double radii, double thingRadius, const glm::dvec3& otherwise)
{
    const double apart = std::sqrt(nearest.squared);
    const glm::dvec3 normal = apart > 1e-9 ? (nearest.on - nearest.to) / apart : otherwise;
    return {apart - radii, normal, nearest.to + normal * thingRadius};
}

glm::dvec3 upward(const glm::dvec3& normal)
{
    return normal == glm::dvec3{0} ? glm::dvec3{0, 1, 0} : normal.y < 0 ? -normal : normal;
}

std::optional<Contact> askBullet(const Mover& mover, const glm::dvec3& at, const Thing& thing, double reach)
{
    const btCapsuleShape capsule{mover.radius, 2 * mover.stem};
    const btSphereShape ball{mover.radius};
    const btConvexShape& moving = mover.stem > 0 ? static_cast<const btConvexShape&>(capsule) : ball;
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector{&moving, thing.shape, &simplex, &depth};
    btGjkPairDetector::ClosestPointInput input;
    // Near the origin, where GJK is at its best.
    input.m_transformA.setIdentity();
    const glm::dmat3& t = thing.turn;
    input.m_transformB = btTransform{btMatrix3x3{t[0][0], t[1][0], t[2][0], t[0][1], t[1][1], t[2][1], t[0][2], t[1][2], t[2][2]}, bullet(thing.at - at)};
    input.m_maximumDistanceSquared = (reach + 1) * (reach + 1);
    btPointCollector out;
    detector.getClosestPoints(input, out, nullptr);
    if (!out.m_hasResult || !(out.m_distance <= reach)) return std::nullopt;
    const glm::dvec3 normal = plain(out.m_normalOnBInWorld);
    if (!(glm::dot(normal, normal) > 0.5)) return std::nullopt;
    return Contact{out.m_distance, normal, plain(out.m_pointInWorld) + at};
}

} // namespace

std::optional<Contact> contactOf(const Mover& mover, const glm::dvec3& at, const Thing& thing, double reach)
{
    if (glm::any(glm::greaterThan(at - mover.reach(), thing.box.max + reach)) || glm::any(glm::lessThan(at + mover.reach(), thing.box.min - reach)))
        return std::nullopt;
    if (mover.isBox()) return boxContact(mover.half, at, thing, reach);
    const glm::dvec3 low = at - glm::dvec3{0, mover.stem, 0}, high = at + glm::dvec3{0, mover.stem, 0};
    std::optional<Contact> contact;
    if (thing.kind == Thing::Kind::Triangle)
        contact = fromNearest(nearestToTriangle(low, high, thing.corners), mover.radius, 0, upward(faceNormal(thing.corners)));
    else if (thing.kind == Thing::Kind::Capsule)
        contact = fromNearest(nearestOfSegments(low, high, thing.corners[0], thing.corners[1]), mover.radius + thing.radius, thing.radius, {1, 0, 0});
    else
        contact = askBullet(mover, at, thing, reach);
    if (!contact || contact->distance > reach) return std::nullopt;
    return contact;
}

std::optional<Hit> sweep(const Mover& mover, const glm::dvec3& from, const glm::dvec3& motion, const Thing& thing)
{
    const glm::dvec3 low = glm::min(from, from + motion) - mover.reach() - kTouch, high = glm::max(from, from + motion) + mover.reach() + kTouch;
    if (glm::any(glm::greaterThan(low, thing.box.max)) || glm::any(glm::lessThan(high, thing.box.min))) return std::nullopt;
    if (mover.isBox()) return sweepBox(mover.half, from, motion, thing);
    const double length = glm::length(motion);
    double share = 0;
    for (int i = 0; i < kMostAdvances; ++i) {
        const auto contact = contactOf(mover, from + motion * share, thing, length * (1 - share) + kTouch);
        if (!contact) return std::nullopt;
        const double approach = -glm::dot(motion, contact->normal);
        // The plane between them is never crossed, or grazed: a smooth slope of many triangles is no row of obstacles.
        if (approach <= 1e-9 * length || contact->distance - approach * (1 - share) >= kTouch - kClose) return std::nullopt;
        if (contact->distance <= kTouch + kClose) return Hit{share, *contact, &thing};
        share += (contact->distance - kTouch) / approach;
        if (share > 1) return std::nullopt;
    }
    return Hit{std::min(share, 1.0), contactOf(mover, from + motion * share, thing, length).value_or(Contact{}), &thing};
}

} // namespace play
