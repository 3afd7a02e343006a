// The valley's land: where the stream runs, how the slopes rise, and where the camp has its clearing.
#pragma once

#include "projects/make/terrain_forms.h"

namespace make {

constexpr float kValleyTop = 400;    // m, of the highest value in the file
constexpr glm::vec2 kCamp{-14, 100}; // the campfire, world x and z
constexpr glm::vec2 kHut{-18, -15};  // from the campfire, m

float streamX(float z);            // the stream's middle
float streamDistance(glm::vec2 p); // m, to its middle
io::HeightGrid makeValleyLand();    // 2049 x 2049, 1 m

} // namespace make
