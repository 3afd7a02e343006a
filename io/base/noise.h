// Smooth noise. `period` is in lattice cells: with it the noise repeats, so that textures tile; 0 never repeats.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace io {

float noise(glm::vec2 p, std::uint32_t seed,
            glm::ivec2 period = glm::ivec2{0}); // gradient noise (Perlin 2002), about -1..1
float noise(glm::vec3 p, std::uint32_t seed);

struct Octaves {
    int count = 5;
    float gain = 0.5f;    // amplitude of each octave against the one before
    glm::ivec2 period{0}; // of the first octave
};
float fbm(glm::vec2 p, std::uint32_t seed, Octaves octaves = {});
float fbm(glm::vec3 p, std::uint32_t seed, Octaves octaves = {});
float ridged(glm::vec2 p, std::uint32_t seed, Octaves octaves = {}); // 0..1, sharp crests (Musgrave 1998)

// Simplex noise (Perlin 2001, Gustavson 2005), -1..1: a third of the corners of noise(), and no table of sines, for brushes that
// must keep up with a hand. It does not repeat.
float simplex(glm::vec2 p, std::uint32_t seed);
float simplexFbm(glm::vec2 p, std::uint32_t seed, Octaves octaves = {});
float simplexRidged(glm::vec2 p, std::uint32_t seed, Octaves octaves = {}); // 0..1, as ridged()

// Distances to the two nearest feature points, one in each lattice cell (Worley 1996).
struct Cells {
    float nearest = 0;
    float second = 0;
    std::uint32_t id = 0; // of the nearest point
    glm::vec2 offset{0};  // from the nearest point
};
Cells cells(glm::vec2 p, std::uint32_t seed, glm::ivec2 period = glm::ivec2{0});

} // namespace io
