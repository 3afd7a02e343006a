// Clouds of an environment as shaders read them.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"
#include "renderer/shaders/shared/clouds.h"
#include "renderer/shaders/shared/light.h"

namespace renderer {

// The value that the field of clouds exceeds over a share `coverage` of the world, 0..1.
float cloudFieldAt(float coverage);

// `light` is the frame's own; `time` in s moves and changes them. All is a function of its arguments.
glsl::Clouds cloudsOf(const io::Environment& environment, const glsl::Light& light, const Eye& eye, double time);

} // namespace renderer
