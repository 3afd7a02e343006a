// The shapes that models are put together from: tubes, beams, cards, stones.
#pragma once

#include "projects/make/mesh.h"
#include "projects/make/random.h"

#include <span>

namespace make {

glm::u8vec4 shade(float light, glm::vec3 tint = glm::vec3{1}); // a vertex colour, both linear 0..1

struct Ring {
    glm::vec3 centre{0};
    float radius = 0.1f; // m
    float light = 1;     // how much of the sky reaches it
    float flare = 0;     // how far roots stand out of it, as a share of the radius
};

struct TubeLook {
    int sides = 6;
    int surface = 0;
    float around = 1;     // repeats of the texture around it
    float metres = 1;     // one repeat along it
    bool pointed = false; // the last ring is a point
    float flatten = 1;    // of the second cross axis
    std::uint32_t seed = 1;
    float wobble = 0; // unevenness of the radius, share
    int roots = 5;    // lobes of the flare
};
void addTube(Mesh& mesh, std::span<const Ring> rings, const TubeLook& look);

// A disc that closes a tube's end; `rim` is the end ring in order, seen from outside counter-clockwise.
void addCap(Mesh& mesh, std::span<const glm::vec3> rim, int surface, float uvRadius = 0.465f);
std::vector<glm::vec3> rimOf(const Ring& before, const Ring& last, const TubeLook& look);

// A sawn beam with its grain along it; `up` turns it about its length. Uses one board of the "planks" texture.
struct Beam {
    glm::vec3 from{0}, to{0};
    float width = 0.1f, height = 0.1f; // m
    glm::vec3 up{0, 1, 0};
    int board = 0;
    int surface = 0;
    float light = 1;
};
void addBeam(Mesh& mesh, const Beam& beam);

// A picture on a quad. `up` points from the stalk to the tip; corners may be lifted out of the plane by `bend`.
struct Card {
    glm::vec3 base{0};
    glm::vec3 up{0, 1, 0};    // length is the height, m
    glm::vec3 right{1, 0, 0}; // length is half of the width, m
    glm::vec3 bend{0};        // m, added to the upper right and lower left corners, taken from the others
    bool mirrored = false;
};
std::array<io::Vertex, 4> cornersOf(const Card& card);

// A stone: a sphere cut flat by `cuts` planes and roughened, with exactly `triangles` (even, at least 20).
struct Stone {
    std::uint64_t seed = 1;
    std::size_t triangles = 120;
    glm::vec3 size{1}; // m, along x, y, z
    int cuts = 14;
    float roughness = 0.07f; // share of the size
    float sharpness = 42;    // degrees between faces beyond which an edge is sharp
    float metres = 1.5f;     // one repeat of the texture
    Surface surface{.texture = "rock"};
};
Mesh makeStone(const Stone& stone);

} // namespace make
