#include "projects/make/camp.h"
#include "projects/make/looks.h"
#include "projects/make/models.h"
#include "projects/make/species.h"

#include <algorithm>

namespace make {
namespace {

// Leaves and branches to make up exactly `count` triangles; more detail in the wood of the larger ones.
Mesh exactTree(TreeShape shape, std::size_t count)
{
    shape.triangles = count;
    shape.trunkSides += 2;
    shape.trunkRings += 2;
    shape.branchSides = std::max(4, shape.branchSides);
    shape.cardSize *= 0.86f;
    return growTree(shape);
}

const Entry kForest[] = {
    {"Rock2", "Rocks",
     [] {
         return makeStone({.seed = 211,
                           .triangles = 356,
                           .size = {2.3f, 1.5f, 1.9f},
                           .cuts = 18,
                           .metres = 1.8f,
                           .surface = {.texture = "rock_mossy"}});
     },
     stoneLook({0.6f, 1.8f}, 0.3f)},
    {"Campfire",
     "Camp",
     [] {
         return makeCampfire({.seed = 5,
                              .stones = 12,
                              .stoneTriangles = 320,
                              .logs = 9,
                              .logSides = 14,
                              .logRings = 9,
                              .potSides = 24,
                              .triangles = 7202});
     },
     {.alignToGround = true, .footprint = 1.1f}},
    {"Axe", "Camp", [] { return makeAxe(548); }, builtLook(0.1f)},
    {"Tree1", "Trees", [] { return exactTree(oak(), 1576); }, treeLook(0.8f, 0.15f)},
    {"Tree2", "Trees", [] { return exactTree(beech(), 1754); }, treeLook(0.8f, 0.15f)},
    {"AutumnTree1", "Trees", [] { return exactTree(inAutumn(birch(), "leaf_birch_autumn", 223), 1596); },
     treeLook(0.4f)},
    {"Tree3", "Trees", [] { return exactTree(birchOld(), 1442); }, treeLook(0.6f, 0.15f)},
    {"AutumnTree2", "Trees", [] { return exactTree(inAutumn(beechOld(), "leaf_beech_autumn", 227), 2630); },
     treeLook(1.2f, 0.2f)},
    {"FirTree", "Trees",
     [] {
         FirShape s = firOf(229, 17, 0.26f, 3.2f, 0, 0.08f);
         s.triangles = 736;
         return growFir(s);
     },
     treeLook(0.6f)},
    {"DeadBranch",
     "Deadwood",
     [] {
         return growDead({.seed = 233,
                          .height = 4.2f,
                          .radius = 0.13f,
                          .sides = 9,
                          .rings = 12,
                          .branches = 8,
                          .branchSides = 6,
                          .branchRings = 7,
                          .twigs = 3,
                          .twigSides = 4,
                          .lying = true,
                          .triangles = 1500});
     },
     {.scale = {0.7f, 1.4f}, .alignToGround = true, .sink = 0.03f, .collision = io::Collision::None}},
    {"DeadTree", "Deadwood",
     [] {
         return growDead({.seed = 239,
                          .height = 10,
                          .radius = 0.30f,
                          .sides = 14,
                          .rings = 16,
                          .branches = 14,
                          .branchSides = 8,
                          .branchRings = 8,
                          .twigs = 4,
                          .twigSides = 4,
                          .triangles = 3600});
     },
     treeLook(0.6f, 0.2f, 0)},
    {"Stump",
     "Deadwood",
     [] {
         return makeStump({.seed = 241, .height = 0.6f, .radius = 0.42f, .sides = 26, .rings = 10, .triangles = 2999});
     },
     {.sink = 0.05f}},
    {"Stump2",
     "Deadwood",
     [] {
         return makeStump({.seed = 251,
                           .height = 1.1f,
                           .radius = 0.50f,
                           .sides = 30,
                           .rings = 12,
                           .broken = true,
                           .bark = "bark_oak_mossy",
                           .triangles = 8704});
     },
     {.sink = 0.05f}},
};

} // namespace

std::span<const Entry> forestEntries()
{
    return kForest;
}

} // namespace make
