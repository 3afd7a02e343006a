// Land before things stand on it: height fields made from noise, worn by water and by falling stones.
#pragma once

#include "io/scene/height_grid.h"
#include "io/scene/settling.h"

#include <cstdint>
#include <functional>

namespace make {

// A square field of `side` texels, centred on the world's origin.
io::HeightGrid blankHeights(int side, double metresPerTexel);

// heights(x, z) in metres for each texel.
void fill(io::HeightGrid& map, const std::function<float(glm::vec2)>& heights);
void change(io::HeightGrid& map, const std::function<float(glm::vec2, float)>& heights); // gets what was there

// Twice the resolution over the same ground: side 2n - 1, cubic between the old texels.
io::HeightGrid doubled(const io::HeightGrid& map);

// io::Rain all over the field.
struct Rain {
    int drops = 100000;
    int steps = 40;     // a drop's life, texels
    int brush = 3;      // radius of the soil taken at once, texels
    float strength = 1; // of taking and leaving
    std::uint64_t seed = 1;
};
void rainOn(io::HeightGrid& map, const Rain& rain);

using io::settle;

float slopeAt(const io::HeightGrid& map, glm::vec2 place);  // degrees
float heightAt(const io::HeightGrid& map, glm::vec2 place); // m, clamped to the field

} // namespace make
