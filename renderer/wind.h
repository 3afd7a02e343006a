// The wind of a frame, from what the environment says.
#pragma once

#include "io/scene/environment.h"
#include "renderer/shaders/shared/wind.h"

#include <glm/glm.hpp>

namespace renderer {

// Off, its speed is 0. `eye` in m; `time` in s.
glsl::Wind windOf(const io::Wind& wind, bool on, const glm::dvec3& eye, double time);

} // namespace renderer
