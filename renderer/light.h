// The frame's light as shaders read it: sun, atmosphere, fog and clouds of an environment.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"
#include "renderer/heavens.h"
#include "renderer/settings.h"
#include "renderer/shaders/shared/light.h"

namespace renderer {

glsl::Atmosphere atmosphereOf(const io::Sky& sky, double eyeHeight); // m above the ground's sea level

// Share of the sun's light that comes through the air to a height, by colour; 0 when it has set there.
glm::vec3 sunThrough(const glsl::Atmosphere& air, double height, const glm::dvec3& towardSun, double sunRadius);

struct LightInput {
    const io::Environment& environment;
    const Settings& settings;
    const Eye& eye;
    const Bodies& bodies;
    double time = 0; // s, moves clouds
    glm::vec4 groundShadow{0}; // where its texture lies
};
glsl::Light lightOf(const LightInput& input);

bool sunReaches(const glsl::Light& light); // any height: it may have set in the valleys

} // namespace renderer
