#include "projects/make/models.h"

#include "io/base/contract.h"
#include "projects/make/camp.h"
#include "projects/make/trees.h"

#include <algorithm>
#include <vector>

namespace make {
namespace {

io::Template treeLook(float footprint, float sink = 0.1f)
{
    return {.scale = {0.85f, 1.18f}, .tilt = 2.5f, .sink = sink, .collision = io::Collision::Capsule, .footprint = footprint};
}
io::Template stoneLook(glm::vec2 scale, float sink, float tilt = 12)
{
    return {.scale = scale, .tilt = tilt, .alignToGround = true, .sink = sink, .footprint = 0.5f};
}
io::Template plantLook(glm::vec2 scale, float sink)
{
    return {.scale = scale, .tilt = 5, .sink = sink, .collision = io::Collision::None, .castShadow = true};
}
io::Template tuftLook(glm::vec2 scale)
{
    io::Template look = plantLook(scale, 0.02f);
    look.alignToGround = true;
    look.castShadow = false;
    return look;
}
io::Template builtLook(float footprint, float sink = 0)
{
    return {.sink = sink, .footprint = footprint};
}

TreeShape oak()
{
    return {.bark = "bark_oak", .leaf = "leaf_oak", .seed = 11, .height = 14.5f, .trunkRadius = 0.40f, .crownBase = 0.26f, .crownRadius = 5.4f,
            .widest = 0.42f, .trunkSides = 8, .trunkRings = 7, .branches = 11, .branchSides = 4, .branchRings = 4, .twigs = 2, .angleLow = 74,
            .angleHigh = 28, .upturn = 0.5f, .gnarl = 0.26f, .cards = 190, .cardSize = 2.7f, .clumpSize = 0.42f};
}
TreeShape oakYoung()
{
    TreeShape s = oak();
    s.seed = 13, s.height = 6.4f, s.trunkRadius = 0.12f, s.crownRadius = 2.1f, s.crownBase = 0.24f, s.trunkSides = 6, s.trunkRings = 6;
    s.branches = 7, s.branchSides = 3, s.branchRings = 3, s.twigs = 1, s.cards = 92, s.cardSize = 1.45f, s.clumpSize = 0.50f, s.fill = 5;
    return s;
}
TreeShape oakOld()
{
    TreeShape s = oak();
    s.bark = "bark_oak_mossy", s.seed = 17, s.height = 18, s.trunkRadius = 0.72f, s.crownRadius = 7.8f, s.crownBase = 0.20f, s.trunkSides = 10;
    s.branches = 12, s.gnarl = 0.34f, s.angleLow = 80, s.cards = 245, s.cardSize = 3.5f, s.clumpSize = 0.38f, s.fill = 12;
    return s;
}
TreeShape birch()
{
    return {.bark = "bark_birch", .leaf = "leaf_birch", .seed = 23, .height = 15.5f, .trunkRadius = 0.19f, .crownBase = 0.24f, .crownRadius = 3.0f,
            .widest = 0.35f, .trunkSides = 7, .trunkRings = 8, .branches = 13, .branchSides = 3, .branchRings = 4, .twigs = 1, .angleLow = 58,
            .angleHigh = 24, .upturn = 0.35f, .gnarl = 0.2f, .droop = 0.28f, .lean = 0.05f, .cards = 172, .cardSize = 2.1f, .clumpSize = 0.46f};
}
TreeShape birchYoung()
{
    TreeShape s = birch();
    s.seed = 29, s.height = 7.2f, s.trunkRadius = 0.085f, s.crownRadius = 1.5f, s.crownBase = 0.26f, s.trunkSides = 5, s.trunkRings = 6;
    s.branches = 9, s.branchRings = 3, s.twigs = 0, s.cards = 84, s.cardSize = 1.25f, s.clumpSize = 0.55f;
    return s;
}
TreeShape birchOld()
{
    TreeShape s = birch();
    s.seed = 31, s.height = 20, s.trunkRadius = 0.27f, s.crownRadius = 4.0f, s.crownBase = 0.34f, s.branches = 15, s.cards = 215, s.cardSize = 2.2f, s.lean = 0.07f;
    return s;
}
TreeShape beech()
{
    return {.bark = "bark_beech", .leaf = "leaf_beech", .seed = 37, .height = 18, .trunkRadius = 0.36f, .crownBase = 0.21f, .crownRadius = 5.0f,
            .widest = 0.45f, .trunkSides = 8, .trunkRings = 7, .branches = 12, .branchSides = 4, .branchRings = 4, .twigs = 2, .angleLow = 62,
            .angleHigh = 20, .upturn = 0.6f, .gnarl = 0.16f, .cards = 205, .cardSize = 2.75f, .clumpSize = 0.44f};
}
TreeShape beechYoung()
{
    TreeShape s = beech();
    s.seed = 41, s.height = 8.2f, s.trunkRadius = 0.12f, s.crownRadius = 2.1f, s.crownBase = 0.2f, s.trunkSides = 6, s.trunkRings = 6;
    s.branches = 8, s.branchSides = 3, s.branchRings = 3, s.twigs = 1, s.cards = 100, s.cardSize = 1.5f, s.clumpSize = 0.50f, s.fill = 5;
    return s;
}
TreeShape beechOld()
{
    TreeShape s = beech();
    s.seed = 43, s.height = 24, s.trunkRadius = 0.58f, s.crownRadius = 7.0f, s.crownBase = 0.2f, s.trunkSides = 10, s.branches = 13;
    s.cards = 245, s.cardSize = 3.5f, s.clumpSize = 0.40f, s.fill = 12;
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
    return {.seed = seed, .height = height, .trunkRadius = radius, .crownBase = base, .crownRadius = crown, .trunkSides = 6,
            .trunkRings = height > 10 ? 6 : 4, .branches = branches};
}

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
    {"beech_autumn", "Trees", [] { return growTree(inAutumn(beech(), "leaf_beech_autumn", 59)); }, treeLook(0.7f, 0.15f)},
    {"fir_young", "Trees", [] { return growFir(firOf(61, 5.2f, 0.09f, 1.5f, 74, 0.04f)); }, treeLook(0.3f)},
    {"fir", "Trees", [] { return growFir(firOf(67, 14.5f, 0.22f, 2.9f, 128, 0.07f)); }, treeLook(0.6f)},
    {"fir_old", "Trees", [] { return growFir(firOf(71, 24, 0.38f, 4.1f, 190, 0.13f)); }, treeLook(0.9f, 0.15f)},
    {"dead_tree", "Deadwood", [] { return growDead({.seed = 73, .radius = 0.34f, .sides = 7, .rings = 8, .branches = 10, .branchSides = 4, .branchRings = 4, .twigs = 2, .triangles = 620}); }, treeLook(0.6f, 0.2f)},
    {"dead_branch", "Deadwood", [] { return growDead({.seed = 79, .height = 3.4f, .radius = 0.10f, .sides = 5, .rings = 6, .branches = 5, .branchSides = 3, .branchRings = 4, .twigs = 1, .lying = true, .triangles = 210}); },
     {.scale = {0.7f, 1.4f}, .alignToGround = true, .sink = 0.03f, .collision = io::Collision::None, .footprint = 0.2f}},
    {"stump", "Deadwood", [] { return makeStump({.seed = 83, .triangles = 260}); }, {.scale = {0.8f, 1.3f}, .tilt = 3, .sink = 0.05f, .footprint = 0.5f}},
    {"stump_broken", "Deadwood", [] { return makeStump({.seed = 89, .height = 0.9f, .radius = 0.40f, .broken = true, .bark = "bark_oak_mossy", .triangles = 420}); },
     {.scale = {0.8f, 1.3f}, .tilt = 4, .sink = 0.05f, .footprint = 0.6f}},
    {"log", "Deadwood", [] { return makeLog(97, 1.9f, 0.21f); }, {.scale = {0.9f, 1.1f}, .alignToGround = true, .sink = 0.03f, .footprint = 0.4f}},
    {"rock_small", "Rocks", [] { return makeStone({.seed = 101, .triangles = 96, .size = {0.9f, 0.62f, 0.75f}, .metres = 1}); }, stoneLook({0.5f, 1.5f}, 0.1f, 25)},
    {"rock", "Rocks", [] { return makeStone({.seed = 103, .triangles = 180, .size = {2.1f, 1.4f, 1.7f}, .metres = 1.7f}); }, stoneLook({0.6f, 1.5f}, 0.25f, 20)},
    {"rock_mossy", "Rocks", [] { return makeStone({.seed = 107, .triangles = 200, .size = {2.4f, 1.5f, 2.0f}, .metres = 1.8f, .surface = {.texture = "rock_mossy"}}); }, stoneLook({0.6f, 1.5f}, 0.3f)},
    {"boulder", "Rocks", [] { return makeStone({.seed = 109, .triangles = 300, .size = {4.2f, 3.1f, 3.6f}, .cuts = 18, .metres = 2.4f}); }, stoneLook({0.7f, 1.6f}, 0.6f)},
    {"rock_slab", "Rocks", [] { return makeStone({.seed = 113, .triangles = 340, .size = {7.5f, 4.2f, 3.4f}, .cuts = 22, .roughness = 0.09f, .metres = 2.8f}); }, stoneLook({0.7f, 1.5f}, 1.0f, 10)},
    {"bush", "Plants", [] { return growShrub({.seed = 127}); }, plantLook({0.7f, 1.4f}, 0.05f)},
    {"bush_low", "Plants", [] { return growShrub({.seed = 131, .leaf = "leaf_beech", .leafTint = {0.9f, 0.95f, 0.8f}, .height = 0.9f, .radius = 0.95f, .cards = 40, .cardSize = 0.8f}); }, plantLook({0.7f, 1.3f}, 0.05f)},
    {"fern", "Plants", [] { return growFern(137, 8, 0.95f); }, plantLook({0.7f, 1.3f}, 0.02f)},
    {"grass", "Plants", [] { return growTuft(139, "leaf_grass", 4, {0.95f, 0.62f}); }, tuftLook({0.7f, 1.4f})},
    {"grass_dry", "Plants", [] { return growTuft(149, "leaf_grass_dry", 4, {0.95f, 0.72f}); }, tuftLook({0.7f, 1.4f})},
    {"flowers", "Plants", [] { return growTuft(151, "leaf_flowers", 3, {0.8f, 0.62f}); }, tuftLook({0.7f, 1.2f})},
    {"axe", "Camp", [] { return makeAxe(320); }, builtLook(0.1f)},
    {"campfire", "Camp", [] { return makeCampfire({.seed = 3}); }, {.alignToGround = true, .footprint = 1.1f}},
    {"tent", "Camp", [] { return makeTent(); }, builtLook(1.8f, 0.02f)},
    {"hut", "Camp", [] { return makeHut(); }, builtLook(3.4f)},
    {"fence", "Camp", [] { return makeFence(157); }, {.yaw = {0, 0}, .sink = 0.03f, .footprint = 0.3f}},
};

const Entry kForest[] = {
    {"Rock2", "Rocks", [] { return makeStone({.seed = 211, .triangles = 356, .size = {2.3f, 1.5f, 1.9f}, .cuts = 18, .metres = 1.8f, .surface = {.texture = "rock_mossy"}}); }, stoneLook({0.6f, 1.8f}, 0.3f)},
    {"Campfire", "Camp", [] { return makeCampfire({.seed = 5, .stones = 12, .stoneTriangles = 320, .logs = 9, .logSides = 14, .logRings = 9, .potSides = 24, .triangles = 7202}); }, {.alignToGround = true, .footprint = 1.1f}},
    {"Axe", "Camp", [] { return makeAxe(548); }, builtLook(0.1f)},
    {"Tree1", "Trees", [] { return exactTree(oak(), 1576); }, treeLook(0.8f, 0.15f)},
    {"Tree2", "Trees", [] { return exactTree(beech(), 1754); }, treeLook(0.8f, 0.15f)},
    {"AutumnTree1", "Trees", [] { return exactTree(inAutumn(birch(), "leaf_birch_autumn", 223), 1596); }, treeLook(0.4f)},
    {"Tree3", "Trees", [] { return exactTree(birchOld(), 1442); }, treeLook(0.6f, 0.15f)},
    {"AutumnTree2", "Trees", [] { return exactTree(inAutumn(beechOld(), "leaf_beech_autumn", 227), 2630); }, treeLook(1.2f, 0.2f)},
    {"FirTree", "Trees", [] { FirShape s = firOf(229, 17, 0.26f, 3.2f, 0, 0.08f); s.triangles = 736; return growFir(s); }, treeLook(0.6f)},
    {"DeadBranch", "Deadwood", [] { return growDead({.seed = 233, .height = 4.2f, .radius = 0.13f, .sides = 9, .rings = 12, .branches = 8, .branchSides = 6, .branchRings = 7, .twigs = 3, .twigSides = 4, .lying = true, .triangles = 1500}); },
     {.scale = {0.7f, 1.4f}, .alignToGround = true, .sink = 0.03f, .collision = io::Collision::None}},
    {"DeadTree", "Deadwood", [] { return growDead({.seed = 239, .height = 10, .radius = 0.30f, .sides = 14, .rings = 16, .branches = 14, .branchSides = 8, .branchRings = 8, .twigs = 4, .twigSides = 4, .triangles = 3600}); }, treeLook(0.6f, 0.2f)},
    {"Stump", "Deadwood", [] { return makeStump({.seed = 241, .height = 0.6f, .radius = 0.42f, .sides = 26, .rings = 10, .triangles = 2999}); }, {.sink = 0.05f}},
    {"Stump2", "Deadwood", [] { return makeStump({.seed = 251, .height = 1.1f, .radius = 0.50f, .sides = 30, .rings = 12, .broken = true, .bark = "bark_oak_mossy", .triangles = 8704}); }, {.sink = 0.05f}},
};

} // namespace

std::span<const Entry> valleyEntries()
{
    return kValley;
}
std::span<const Entry> forestEntries()
{
    return kForest;
}

const Entry& entryOf(std::string_view name)
{
    for (const std::span<const Entry> entries : {valleyEntries(), forestEntries()})
        for (const Entry& entry : entries)
            if (entry.name == name) return entry;
    EXPECTS(!"a name of the catalogue");
    return kValley[0];
}

io::Model buildModel(std::string_view name, Textures& textures)
{
    return modelOf(entryOf(name).build(), std::string{name}, textures);
}

io::Template templateOf(const Entry& entry)
{
    io::Template result = entry.look;
    result.name = entry.name;
    result.category = entry.category;
    result.model = "models/" + std::string{entry.name} + ".glb";
    return result;
}

} // namespace make
