// Trunks, branches and twigs as chains of rings.
#pragma once

#include "projects/make/shapes.h"

namespace make {

struct Limb {
    std::vector<Ring> rings; // from its root to its end
};

Ring ringAt(const Limb& limb, float share); // share 0..1 of its length
glm::vec3 directionAt(const Limb& limb, float share);

struct TrunkPlan {
    float height = 12;   // m
    float radius = 0.3f; // m, at breast height
    int rings = 8;
    float gnarl = 0.05f;
    float lean = 0.03f;
    float tipShare = 0.10f; // radius at the top as a share of the radius
    float flare = 0.55f;    // of the roots
};
Limb growTrunk(const TrunkPlan& plan, Random& random);

struct LimbPlan {
    glm::vec3 from{0}, direction{0, 1, 0};
    float length = 3;    // m
    float radius = 0.1f; // m
    float tipRadius = 0.02f;
    int rings = 4;
    float upturn = 0.5f; // 0 straight … 1 ends upright
    float gnarl = 0.2f;
    float droop = 0; // how much its end hangs
};
Limb growLimb(const LimbPlan& plan, Random& random);

} // namespace make
