#include "projects/make/species.h"

namespace make {
namespace {

TreeShape youngOf(TreeShape s) // thinner, simpler, its crown still closed
{
    s.trunkRadius = 0.12f, s.crownRadius = 2.1f, s.trunkSides = 6, s.trunkRings = 6;
    s.branchSides = 3, s.branchRings = 3, s.twigs = 1, s.clumpSize = 0.50f, s.fill = 5;
    return s;
}

TreeShape oldOf(TreeShape s)
{
    s.crownBase = 0.20f, s.trunkSides = 10, s.cards = 245, s.cardSize = 3.5f, s.fill = 12;
    return s;
}

} // namespace

TreeShape oak()
{
    return {.bark = "bark_oak",
            .leaf = "leaf_oak",
            .seed = 11,
            .height = 14.5f,
            .trunkRadius = 0.40f,
            .crownBase = 0.26f,
            .crownRadius = 5.4f,
            .widest = 0.42f,
            .trunkSides = 8,
            .trunkRings = 7,
            .branches = 11,
            .branchSides = 4,
            .branchRings = 4,
            .twigs = 2,
            .angleLow = 74,
            .angleHigh = 28,
            .upturn = 0.5f,
            .gnarl = 0.26f,
            .cards = 190,
            .cardSize = 2.7f,
            .clumpSize = 0.42f};
}
TreeShape oakYoung()
{
    TreeShape s = youngOf(oak());
    s.seed = 13, s.height = 6.4f, s.crownBase = 0.24f, s.branches = 7, s.cards = 92, s.cardSize = 1.45f;
    return s;
}
TreeShape oakOld()
{
    TreeShape s = oldOf(oak());
    s.bark = "bark_oak_mossy", s.seed = 17, s.height = 18, s.trunkRadius = 0.72f, s.crownRadius = 7.8f;
    s.branches = 12, s.gnarl = 0.34f, s.angleLow = 80, s.clumpSize = 0.38f;
    return s;
}
TreeShape birch()
{
    return {.bark = "bark_birch",
            .leaf = "leaf_birch",
            .seed = 23,
            .height = 15.5f,
            .trunkRadius = 0.19f,
            .crownBase = 0.24f,
            .crownRadius = 3.0f,
            .widest = 0.35f,
            .trunkSides = 7,
            .trunkRings = 8,
            .branches = 13,
            .branchSides = 3,
            .branchRings = 4,
            .twigs = 1,
            .angleLow = 58,
            .angleHigh = 24,
            .upturn = 0.35f,
            .gnarl = 0.2f,
            .droop = 0.28f,
            .lean = 0.05f,
            .cards = 172,
            .cardSize = 2.1f,
            .clumpSize = 0.46f};
}
TreeShape birchYoung()
{
    TreeShape s = birch();
    s.seed = 29, s.height = 7.2f, s.trunkRadius = 0.085f, s.crownRadius = 1.5f, s.crownBase = 0.26f, s.trunkSides = 5,
    s.trunkRings = 6;
    s.branches = 9, s.branchRings = 3, s.twigs = 0, s.cards = 84, s.cardSize = 1.25f, s.clumpSize = 0.55f;
    return s;
}
TreeShape birchOld()
{
    TreeShape s = birch();
    s.seed = 31, s.height = 20, s.trunkRadius = 0.27f, s.crownRadius = 4.0f, s.crownBase = 0.34f, s.branches = 15,
    s.cards = 215, s.cardSize = 2.2f, s.lean = 0.07f;
    return s;
}
TreeShape beech()
{
    return {.bark = "bark_beech",
            .leaf = "leaf_beech",
            .seed = 37,
            .height = 18,
            .trunkRadius = 0.36f,
            .crownBase = 0.21f,
            .crownRadius = 5.0f,
            .widest = 0.45f,
            .trunkSides = 8,
            .trunkRings = 7,
            .branches = 12,
            .branchSides = 4,
            .branchRings = 4,
            .twigs = 2,
            .angleLow = 62,
            .angleHigh = 20,
            .upturn = 0.6f,
            .gnarl = 0.16f,
            .cards = 205,
            .cardSize = 2.75f,
            .clumpSize = 0.44f};
}
TreeShape beechYoung()
{
    TreeShape s = youngOf(beech());
    s.seed = 41, s.height = 8.2f, s.crownBase = 0.2f, s.branches = 8, s.cards = 100, s.cardSize = 1.5f;
    return s;
}
TreeShape beechOld()
{
    TreeShape s = oldOf(beech());
    s.seed = 43, s.height = 24, s.trunkRadius = 0.58f, s.crownRadius = 7.0f, s.branches = 13, s.clumpSize = 0.40f;
    return s;
}
TreeShape inAutumn(TreeShape shape, const char* leaf, std::uint64_t seed)
{
    shape.leaf = leaf;
    shape.seed = seed;
    shape.cards -= 20;
    return shape;
}

FirShape firOf(std::uint64_t seed, float height, float radius, float crown, int branches, float base)
{
    return {.seed = seed,
            .height = height,
            .trunkRadius = radius,
            .crownBase = base,
            .crownRadius = crown,
            .trunkSides = 6,
            .trunkRings = height > 10 ? 6 : 4,
            .branches = branches};
}

} // namespace make
