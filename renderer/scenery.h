// All that the GPU knows of a scene, and how a frame looks at it.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"
#include "renderer/ground_shadow.h"
#include "renderer/light.h"
#include "renderer/particles.h"
#include "renderer/terrain.h"
#include "renderer/world.h"

namespace renderer {

struct Scenery {
    World world;
    CullTable cullTable;
    Terrain terrain;
    GroundShadow groundShadow;
    ParticleSources particles;
    io::Environment environment;
};

// One frame's camera and light, bound for every pass.
struct Viewpoint {
    Eye eye;
    Eye culledFor; // whose culling and levels of detail are drawn: the eye itself, but while they are frozen
    bool frozen = false;
    glm::dvec3 towardSun{0, 1, 0};
    std::vector<Cascade> cascades; // empty: no shadows
    glsl::View view;
    glsl::Wind wind;
    double time = 0; // s
    glsl::Light light;
};

} // namespace renderer
