// Where the shadow maps lie: one sphere a slice of the view, in a box that moves by large steps of whole texels of the
// world, so that shadows stand still while the camera moves and turns, and most maps serve many frames.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"

#include <vector>

namespace renderer {

struct Cascade {
    glm::dmat4 clipFromRelative{1};    // depth 0 towards the sun, 1 away from it
    glm::dmat4 textureFromRelative{1}; // the same, to [0, 1]
    Volume volume;                     // of casters: the box, open towards the sun
    double beginDepth = 0, endDepth = 0; // m along the camera's axis
    double radius = 0;                 // m
    double texel = 0;                  // m
    glm::dvec3 snapped{0};             // centre in the light's axes, m from the world's origin
};

// Rows: the light's right, up and towards the sun.
glm::dmat3 lightAxes(const glm::dvec3& towardSun);

std::vector<double> cascadeEnds(const io::Shadows& shadows); // m, one a cascade

std::vector<Cascade> cascadesOf(const Eye& eye, const io::Shadows& shadows, const glm::dvec3& towardSun);

} // namespace renderer
