// A scene's lens and film as shaders read them.
#pragma once

#include "io/scene/environment.h"
#include "renderer/settings.h"
#include "renderer/shaders/shared/film.h"

#include <glm/glm.hpp>

namespace renderer {

// Chromaticity (CIE 1931 x, y) of the light of a black body, up to 4000 K, or of daylight, from 5000 K; between them, a mix.
glm::dvec2 chromaticity(double kelvin);

// On linear sRGB: the light of that temperature becomes white. Tint: -1 takes it for a magenta one, so that the picture turns green; 1 the
// other way. 6500 K without tint is the identity.
glm::mat3 whiteBalance(double kelvin, double tint);

// What is switched off in the settings is neutral. `time` in s: grain changes with it.
glsl::Film filmOf(const io::Grading& grading, const Settings& settings, double time);

} // namespace renderer
