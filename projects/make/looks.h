// How kinds of things vary from copy to copy and meet the ground. Sizes in metres; `sink` is what lies deeper than the
// model's own origin.
#pragma once

#include "io/scene/template.h"

namespace make {

io::Template treeLook(float footprint, float sink = 0.1f, float wind = 0.6f);
io::Template stoneLook(glm::vec2 scale, float sink, float tilt = 12);
io::Template plantLook(glm::vec2 scale, float sink);
io::Template tuftLook(glm::vec2 scale);
io::Template builtLook(float footprint, float sink = 0);
io::Template fireLook();
io::ParticleSource smokeOfFire(); // above that

} // namespace make
