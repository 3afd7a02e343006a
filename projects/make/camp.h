// What people left in the valley: a fire, an axe, a tent, a hut, fences, logs.
#pragma once

#include "projects/make/shapes.h"

namespace make {

struct FireShape {
    std::uint64_t seed = 1;
    int stones = 9;
    std::size_t stoneTriangles = 36; // each
    int logs = 6;
    int logSides = 6, logRings = 4;
    int potSides = 10;
    std::size_t triangles = 0; // exactly so many when not 0
};
Mesh makeCampfire(const FireShape& shape);

Mesh makeAxe(std::size_t triangles); // struck into what it stands on: its edge is at the origin
Mesh makeTent();
Mesh makeHut();
Mesh makeFence(std::uint64_t seed); // one length of 2.5 m along x
Mesh makeLog(std::uint64_t seed, float length, float radius);

} // namespace make
