#include "projects/make/camp.h"
#include "projects/make/looks.h"
#include "projects/make/models.h"
#include "projects/make/species.h"

namespace make {
namespace {

const Entry kValley[] = {
    {"oak_young", "Trees", [] { return growTree(oakYoung()); }, treeLook(0.3f)},
    {"oak", "Trees", [] { return growTree(oak()); }, treeLook(0.8f, 0.15f)},
    {"oak_old", "Trees", [] { return growTree(oakOld()); }, treeLook(1.4f, 0.2f)},
    {"oak_autumn", "Trees", [] { return growTree(inAutumn(oak(), "leaf_oak_autumn", 47)); }, treeLook(0.8f, 0.15f)},
    {"birch_young", "Trees", [] { return growTree(birchYoung()); }, treeLook(0.2f)},
    {"birch", "Trees", [] { return growTree(birch()); }, treeLook(0.4f)},
    {"birch_old", "Trees", [] { return growTree(birchOld()); }, treeLook(0.6f, 0.15f)},
    {"birch_autumn", "Trees", [] { return growTree(inAutumn(birch(), "leaf_birch_autumn", 53)); }, treeLook(0.4f)},
    {"beech_young", "Trees", [] { return growTree(beechYoung()); }, treeLook(0.3f)},
    {"beech", "Trees", [] { return growTree(beech()); }, treeLook(0.7f, 0.15f)},
    {"beech_old", "Trees", [] { return growTree(beechOld()); }, treeLook(1.2f, 0.2f)},
    {"beech_autumn", "Trees", [] { return growTree(inAutumn(beech(), "leaf_beech_autumn", 59)); },
     treeLook(0.7f, 0.15f)},
    {"fir_young", "Trees", [] { return growFir(firOf(61, 5.2f, 0.09f, 1.5f, 74, 0.04f)); }, treeLook(0.3f)},
    {"fir", "Trees", [] { return growFir(firOf(67, 14.5f, 0.22f, 2.9f, 128, 0.07f)); }, treeLook(0.6f)},
    {"fir_old", "Trees", [] { return growFir(firOf(71, 24, 0.38f, 4.1f, 190, 0.13f)); }, treeLook(0.9f, 0.15f)},
    {"dead_tree", "Deadwood",
     [] {
         return growDead({.seed = 73,
                          .radius = 0.34f,
                          .sides = 7,
                          .rings = 8,
                          .branches = 10,
                          .branchSides = 4,
                          .branchRings = 4,
                          .twigs = 2,
                          .triangles = 620});
     },
     treeLook(0.6f, 0.2f, 0)},
    {"dead_branch",
     "Deadwood",
     [] {
         return growDead({.seed = 79,
                          .height = 3.4f,
                          .radius = 0.10f,
                          .sides = 5,
                          .rings = 6,
                          .branches = 5,
                          .branchSides = 3,
                          .branchRings = 4,
                          .twigs = 1,
                          .lying = true,
                          .triangles = 210});
     },
     {.scale = {0.7f, 1.4f},
      .alignToGround = true,
      .sink = 0.03f,
      .collision = io::Collision::None,
      .footprint = 0.2f}},
    {"stump",
     "Deadwood",
     [] { return makeStump({.seed = 83, .triangles = 260}); },
     {.scale = {0.8f, 1.3f}, .tilt = 3, .sink = 0.05f, .footprint = 0.5f}},
    {"stump_broken",
     "Deadwood",
     [] {
         return makeStump(
             {.seed = 89, .height = 0.9f, .radius = 0.40f, .broken = true, .bark = "bark_oak_mossy", .triangles = 420});
     },
     {.scale = {0.8f, 1.3f}, .tilt = 4, .sink = 0.05f, .footprint = 0.6f}},
    {"log",
     "Deadwood",
     [] { return makeLog(97, 1.9f, 0.21f); },
     {.scale = {0.9f, 1.1f}, .alignToGround = true, .sink = 0.03f, .footprint = 0.4f}},
    {"rock_small", "Rocks",
     [] {
         return makeStone({.seed = 101, .triangles = 96, .size = {0.9f, 0.62f, 0.75f}, .metres = 1});
     },
     stoneLook({0.5f, 1.5f}, 0.1f, 25)},
    {"rock", "Rocks",
     [] {
         return makeStone({.seed = 103, .triangles = 180, .size = {2.1f, 1.4f, 1.7f}, .metres = 1.7f});
     },
     stoneLook({0.6f, 1.5f}, 0.38f, 20)},
    {"rock_mossy", "Rocks",
     [] {
         return makeStone({.seed = 107,
                           .triangles = 200,
                           .size = {2.4f, 1.5f, 2.0f},
                           .metres = 1.8f,
                           .surface = {.texture = "rock_mossy"}});
     },
     stoneLook({0.6f, 1.5f}, 0.42f)},
    {"boulder", "Rocks",
     [] {
         return makeStone({.seed = 109, .triangles = 300, .size = {4.2f, 3.1f, 3.6f}, .cuts = 18, .metres = 2.4f});
     },
     stoneLook({0.7f, 1.6f}, 0.85f)},
    {"rock_slab", "Rocks",
     [] {
         return makeStone({.seed = 113,
                           .triangles = 340,
                           .size = {7.5f, 4.2f, 3.4f},
                           .cuts = 22,
                           .roughness = 0.09f,
                           .metres = 2.8f});
     },
     stoneLook({0.7f, 1.5f}, 1.3f, 10)},
    {"bush", "Plants", [] { return growShrub({.seed = 127}); }, plantLook({0.7f, 1.4f}, 0.05f)},
    {"bush_low", "Plants",
     [] {
         return growShrub({.seed = 131,
                           .leaf = "leaf_beech",
                           .leafTint = {0.9f, 0.95f, 0.8f},
                           .height = 0.9f,
                           .radius = 0.95f,
                           .cards = 40,
                           .cardSize = 0.8f});
     },
     plantLook({0.7f, 1.3f}, 0.05f)},
    {"fern", "Plants", [] { return growFern(137, 8, 0.95f); }, plantLook({0.7f, 1.3f}, 0.02f)},
    {"grass", "Plants",
     [] {
         return growTuft(139, "leaf_grass", 4, {0.95f, 0.62f});
     },
     tuftLook({0.7f, 1.4f})},
    {"grass_dry", "Plants",
     [] {
         return growTuft(149, "leaf_grass_dry", 4, {0.95f, 0.72f});
     },
     tuftLook({0.7f, 1.4f})},
    {"flowers", "Plants",
     [] {
         return growTuft(151, "leaf_flowers", 3, {0.8f, 0.62f});
     },
     tuftLook({0.7f, 1.2f})},
    {"axe", "Camp", [] { return makeAxe(320); }, builtLook(0.1f)},
    {"campfire", "Camp", [] { return makeCampfire({.seed = 3}); }, fireLook()},
    {"tent", "Camp", [] { return makeTent(); }, builtLook(1.8f, 0.02f)},
    {"hut", "Camp", [] { return makeHut(); }, builtLook(3.4f)},
    {"fence", "Camp", [] { return makeFence(157); }, {.yaw = {0, 0}, .sink = 0.03f, .footprint = 0.3f}},
};

} // namespace

std::span<const Entry> valleyEntries()
{
    return kValley;
}

} // namespace make
