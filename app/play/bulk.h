// Bulk: what templates are to Bullet's world: the same shapes that the player meets, of the size of one copy.
#pragma once

#include "app/play/shapes.h"
#include "io/scene/transform.h"

class btCollisionShape;

namespace play {

struct Plane {
    glm::dvec3 normal{0, 1, 0}; // outwards, unit
    double distance = 0;        // m from the centre
};

struct Bulk {
    std::unique_ptr<btCollisionShape> shape;
    glm::dvec3 centre{0};            // from the copy's place, in its own axes: what Bullet turns it about
    std::vector<glm::dvec3> corners; // from the centre; none of a mesh
    std::vector<Plane> planes;       // of its sides; none of a mesh and of a capsule
    double rim = 0;                  // m around each corner, of a capsule
    double inner = 0;                // m, of a ball around the centre that is inside of it; of the thinnest side at most
    ~Bulk();
};

// Null: nothing that could be met. A mesh does not move; its tree must outlive the answer.
std::shared_ptr<Bulk> bulkOf(Shapes& shapes, io::TemplateId id, const glm::vec3& scale);

} // namespace play
