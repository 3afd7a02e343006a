// All that the GPU knows of a scene, and how a frame looks at it.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"
#include "renderer/footprint_mask.h"
#include "renderer/grass.h"
#include "renderer/ground_shadow.h"
#include "renderer/heavens.h"
#include "renderer/lamps.h"
#include "renderer/light.h"
#include "renderer/particles.h"
#include "renderer/shaders/shared/shafts.h"
#include "renderer/shadow_constants.h"
#include "renderer/terrain.h"
#include "renderer/world.h"

#include <optional>

namespace renderer {

struct Scenery {
    World world;
    Lamps lamps;
    CullTable cullTable;
    Terrain terrain;
    GroundShadow groundShadow;
    Grass grass;
    FootprintMask footprints;
    ParticleSources particles;
    io::Environment environment;
};

enum class Shafts { None, Volume, Screen }; // of light in fog: in froxels, or from what the picture shows

// One frame's camera and light, bound for every pass.
struct Viewpoint {
    Eye eye;
    Eye culledFor; // whose culling and levels of detail are drawn: the eye itself, but while they are frozen
    bool frozen = false;
    Bodies bodies;
    glm::dvec3 towardSun{0, 1, 0}; // or towards the moon, where that lights
    glm::dvec3 shadowsToward{0, 1, 0}; // the same in steps, for shadows
    std::vector<Cascade> cascades; // empty: no shadows
    std::vector<Lamp> lamps;       // in view, brightest first; empty: none, or switched off
    glsl::View view;
    glsl::View still; // the same, not moved aside
    std::optional<int> gathered; // frames before this one that it is gathered with; none: it stands for itself
    glsl::Wind wind;
    double time = 0; // s
    glsl::Light light;
    glsl::Shadows shadows;
    io::Occlusion occlusion;
    io::AutoExposure autoExposure;
    io::Grading grading;
    glsl::Heavens heavens;
    Shafts shafts = Shafts::None;
    glsl::Shafts shaftConstants{};
};

} // namespace renderer
