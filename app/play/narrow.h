// One thing against what moves: how far apart they are, and when they meet. Distances come from closed forms for triangles and
// capsules and from Bullet's GJK for boxes and hulls; a sweep advances by what the distance allows (conservative advancement), so
// nothing is passed through at any speed.
#pragma once

#include "app/play/closest.h"
#include "io/scene/bounds.h"
#include "io/scene/ids.h"

#include <memory>
#include <optional>
#include <vector>

class btConvexShape;

namespace play {

constexpr double kTouch = 0.002; // m; nearer than this two things touch
constexpr double kGap = 0.004;   // m; that is kept to what was run into

// What moves: an upright capsule (of no height: a ball), or a box along the world's axes.
struct Mover {
    double radius = 0, stem = 0; // m; stem: half the length of the capsule's segment
    glm::dvec3 half{0};          // of a box; 0: the capsule

    bool isBox() const { return half.y > 0; }
    glm::dvec3 reach() const { return isBox() ? half : glm::dvec3{radius, radius + stem, radius}; }
};

// A convex solid by its corners and the directions in which it can be told apart from a box.
struct Solid {
    std::vector<glm::dvec3> points, normals, edges; // world; unit, unit
};

// Something near enough to be run into.
struct Thing {
    enum class Kind { Triangle, Capsule, Convex };
    Kind kind = Kind::Triangle;
    io::ObjectId id = io::ObjectId::None; // None: the ground
    io::WorldBox box;
    Triangle corners{};               // world; of a capsule the ends of its segment
    double radius = 0;                // of a capsule
    const btConvexShape* shape = nullptr; // of a convex one, owned by who found it
    glm::dmat3 turn{1};
    glm::dvec3 at{0};
    std::shared_ptr<const Solid> solid;   // of capsules and convex ones
};

struct Contact {
    double distance = 0;     // m; below 0 they overlap
    glm::dvec3 normal{0, 1, 0}; // unit, from the thing to what moves
    glm::dvec3 point{0};     // on the thing
};
struct Hit {
    double share = 1; // of the way, 0..1
    Contact contact;
    const Thing* thing = nullptr;
};

// Nothing: farther than `reach`.
std::optional<Contact> contactOf(const Mover& mover, const glm::dvec3& at, const Thing& thing, double reach);
std::optional<Hit> sweep(const Mover& mover, const glm::dvec3& from, const glm::dvec3& motion, const Thing& thing);

} // namespace play
