// Trees: a trunk with root flare, curved branches and twigs, and cards of leaves gathered in clumps.
#pragma once

#include "projects/make/shapes.h"

#include <optional>

namespace make {

struct TreeShape {
    std::string bark = "bark_oak";
    std::string leaf = "leaf_oak";
    glm::vec3 leafTint{1};
    std::uint64_t seed = 1;
    float height = 14;         // m
    float trunkRadius = 0.32f; // m, at breast height
    float crownBase = 0.28f;   // share of the height
    float crownRadius = 4.6f;  // m, where it is widest
    float widest = 0.4f;       // share of the crown's height
    int trunkSides = 8, trunkRings = 8;
    int branches = 11, branchSides = 4, branchRings = 4;
    int twigs = 2;                       // of each branch
    float angleLow = 72, angleHigh = 30; // degrees from the vertical, lowest and highest branch
    float upturn = 0.5f;                 // how much branches bend towards the sky
    float gnarl = 0.22f;                 // how crooked they are
    float droop = 0;                     // how much their ends hang
    float lean = 0.03f;
    int cards = 220;
    float cardSize = 1.9f;     // m
    float clumpSize = 0.36f;   // share of the crown's radius
    int fill = 8;              // clumps that close gaps of the crown
    std::size_t triangles = 0; // exactly so many when not 0: cards and wood make up the rest
};
Mesh growTree(const TreeShape& shape);

struct FirShape {
    std::uint64_t seed = 1;
    float height = 18;
    float trunkRadius = 0.26f;
    float crownBase = 0.08f;
    float crownRadius = 3.0f;
    int trunkSides = 6, trunkRings = 6;
    int branches = 110;
    std::size_t triangles = 0;
};
Mesh growFir(const FirShape& shape);

// Wood without leaves: standing dead trees and branches on the ground.
struct DeadShape {
    std::uint64_t seed = 1;
    float height = 9;
    float radius = 0.28f;
    int sides = 8, rings = 9;
    int branches = 9, branchSides = 5, branchRings = 5;
    int twigs = 3, twigSides = 3;
    bool lying = false;
    std::size_t triangles = 600;
};
Mesh growDead(const DeadShape& shape);

struct StumpShape {
    std::uint64_t seed = 1;
    float height = 0.55f, radius = 0.36f; // m
    int sides = 14, rings = 5;
    bool broken = false; // splintered instead of sawn
    std::string bark = "bark_oak";
    std::size_t triangles = 300;
};
Mesh makeStump(const StumpShape& shape);

struct ShrubShape {
    std::uint64_t seed = 1;
    std::string leaf = "leaf_bush";
    glm::vec3 leafTint{1};
    float height = 1.5f, radius = 1.1f; // m
    int cards = 52;
    float cardSize = 0.95f;
};
Mesh growShrub(const ShrubShape& shape);

Mesh growFern(std::uint64_t seed, int fronds, float length);
Mesh growTuft(std::uint64_t seed, const std::string& leaf, int cards, glm::vec2 size); // grass, flowers

} // namespace make
