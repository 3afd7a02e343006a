// The water of a frame: its waves as an environment asks for them, and the patches of surface that stand for them.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"
#include "renderer/shaders/shared/water.h"

#include <optional>
#include <vector>

namespace renderer {

// `time` in s. The same for the same arguments, so that a picture can be made again.
glsl::Water waterOf(const io::Environment& environment, const Eye& eye, double time);

struct WaterPatch {
    glm::vec2 origin{0};  // m from the eye, x and z of the first corner
    float cell = 1;       // m
    float turnedAt = 0;   // m from the eye, where its cells have become twice as large
};

// Patches by distance, each of WATER_CELLS cells a side; cells lie on a grid that the world holds, so nothing swims as the
// eye moves. Without a volume all of them. `inner` becomes the square that they fill: beyond it waves are too small to lift the surface.
std::vector<WaterPatch> waterPatches(glsl::Water& water, const Eye& eye, const std::optional<Volume>& volume);

} // namespace renderer
