#include "app/play/swept_box.h"

#include <limits>
#include <span>

namespace play {
namespace {

constexpr double kNear0 = 1e-9;

// visit(direction) for each direction in which the two may be told apart, both ways round.
template <class Visit> void eachDirection(const Thing& thing, Visit&& visit)
{
    const auto both = [&](const glm::dvec3& direction) {
        const double length = glm::length(direction);
        if (length < kNear0) return;
        visit(direction / length);
        visit(-direction / length);
    };
    const auto crossed = [&](const glm::dvec3& edge) {
        both({0, edge.z, -edge.y});
        both({-edge.z, 0, edge.x});
        both({edge.y, -edge.x, 0});
    };
    both({0, 1, 0});
    both({1, 0, 0});
    both({0, 0, 1});
    if (thing.kind == Thing::Kind::Triangle) {
        both(faceNormal(thing.corners));
        for (std::size_t i = 0; i < 3; ++i)
            crossed(thing.corners[(i + 1) % 3] - thing.corners[i]);
        return;
    }
    for (const glm::dvec3& normal : thing.solid->normals)
        both(normal);
    for (const glm::dvec3& edge : thing.solid->edges)
        crossed(edge);
}

std::span<const glm::dvec3> pointsOf(const Thing& thing)
{
    if (thing.kind == Thing::Kind::Triangle) return thing.corners;
    return thing.solid->points;
}

struct Extreme {
    double reach;
    glm::dvec3 point;
};
Extreme farthest(std::span<const glm::dvec3> points, const glm::dvec3& direction)
{
    Extreme best{std::numeric_limits<double>::lowest(), {}};
    for (const glm::dvec3& point : points)
        if (const double reach = glm::dot(point, direction); reach > best.reach) best = {reach, point};
    return best;
}

double apart(const glm::dvec3& half, const glm::dvec3& at, const Extreme& end, const glm::dvec3& direction)
{
    return glm::dot(at, direction) - glm::dot(half, glm::abs(direction)) - end.reach;
}

} // namespace

std::optional<Contact> boxContact(const glm::dvec3& half, const glm::dvec3& at, const Thing& thing, double reach)
{
    Contact best{std::numeric_limits<double>::lowest(), {}, {}};
    eachDirection(thing, [&](const glm::dvec3& direction) {
        const Extreme end = farthest(pointsOf(thing), direction);
        const double distance = apart(half, at, end, direction);
        if (distance > best.distance + kNear0) best = {distance, direction, end.point};
    });
    if (best.distance > reach) return std::nullopt;
    return best;
}

std::optional<Hit> sweepBox(const glm::dvec3& half, const glm::dvec3& from, const glm::dvec3& motion, const Thing& thing)
{
    Contact deepest{std::numeric_limits<double>::lowest(), {}, {}};
    Contact entered;
    double enter = -1, leave = 1;
    bool never = false;
    eachDirection(thing, [&](const glm::dvec3& direction) {
        if (never) return;
        const Extreme end = farthest(pointsOf(thing), direction);
        const double distance = apart(half, from, end, direction), speed = glm::dot(motion, direction);
        if (distance > deepest.distance + kNear0) deepest = {distance, direction, end.point};
        if (distance > kTouch) {
            if (speed >= -kNear0) return void(never = true);
            if (const double at = (kTouch - distance) / speed; at > enter) enter = at, entered = {kTouch, direction, end.point};
        } else if (speed > kNear0) {
            leave = std::min(leave, (kTouch - distance) / speed);
        }
    });
    if (never || enter > leave || enter > 1) return std::nullopt;
    if (enter >= 0) return Hit{enter, entered, &thing};
    if (glm::dot(motion, deepest.normal) >= -kNear0) return std::nullopt;
    return Hit{0, deepest, &thing};
}

} // namespace play
