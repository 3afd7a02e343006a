#include "io/base/contract.h"
#include "projects/make/limbs.h"
#include "projects/make/noise.h"
#include "projects/make/trees.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

struct Wood {
    Mesh mesh;
    std::vector<Ring> rings; // of all its limbs
};

void addBare(Wood& wood, const Limb& limb, int sides, int surface, std::uint32_t seed)
{
    wood.rings.insert(wood.rings.end(), limb.rings.begin(), limb.rings.end());
    addTube(wood.mesh, limb.rings,
            {.sides = sides, .surface = surface, .metres = 1.3f, .pointed = true, .seed = seed, .wobble = 0.12f});
}

void addBareBranch(Wood& wood, const DeadShape& shape, const Limb& parent, int i, int surface, Random& random)
{
    const float share = glm::mix(0.28f, 0.96f, (float(i) + random.unit() * 0.8f) / float(shape.branches));
    const Ring start = ringAt(parent, share);
    const glm::vec3 ahead = directionAt(parent, share);
    glm::vec3 side = random.direction();
    side = glm::normalize(side - ahead * glm::dot(side, ahead) + glm::vec3{1e-3f, 0, 0});
    if (shape.lying && side.y < -0.2f) side.y = -side.y;
    const float broken = random.chance(0.3f) ? 0.35f : 1.0f;
    const float length = shape.height * random.range(0.28f, 0.48f) * (1.15f - share * 0.6f) * broken;
    const Limb branch = growLimb({.from = start.centre,
                                  .direction = glm::normalize(ahead * random.range(0.35f, 0.8f) + side),
                                  .length = length,
                                  .radius = start.radius * 0.55f,
                                  .tipRadius = start.radius * 0.08f,
                                  .rings = shape.branchRings,
                                  .upturn = shape.lying ? 0.0f : 0.5f,
                                  .gnarl = 0.36f},
                                 random);
    addBare(wood, branch, shape.branchSides, surface, std::uint32_t(i));
    for (int k = 0; k < (broken < 1 ? 1 : shape.twigs); ++k) {
        const float at = random.range(0.35f, 0.92f);
        const Ring knot = ringAt(branch, at);
        const glm::vec3 direction = glm::normalize(directionAt(branch, at) * 0.7f + random.direction() * 0.8f);
        addBare(wood,
                growLimb({.from = knot.centre,
                          .direction = direction,
                          .length = length * random.range(0.25f, 0.5f),
                          .radius = knot.radius * 0.6f,
                          .tipRadius = 0.003f,
                          .rings = 3,
                          .upturn = 0.2f,
                          .gnarl = 0.4f},
                         random),
                shape.twigSides, surface, 5);
    }
}

Limb lyingTrunk(const DeadShape& shape, Random& random)
{
    Limb limb = growLimb({.from = {-shape.height * 0.45f, shape.radius * 0.7f, 0},
                          .direction = {1, 0.02f, 0},
                          .length = shape.height,
                          .radius = shape.radius,
                          .tipRadius = shape.radius * 0.12f,
                          .rings = shape.rings,
                          .upturn = 0,
                          .gnarl = 0.13f},
                         random);
    for (Ring& ring : limb.rings)
        ring.centre.y = std::max(ring.radius * 0.6f, ring.centre.y * 0.35f + ring.radius * 0.4f);
    return limb;
}

float thicknessAt(const std::vector<Ring>& rings, glm::vec3 p) // radius of the nearest ring, m
{
    const auto away = [p](const Ring& ring) { return glm::length(ring.centre - p); };
    return std::ranges::min_element(rings, {}, away)->radius;
}

// Fine unevenness for points that refining adds, so that more triangles show more wood. Never so deep that a twig
// would turn inside out.
std::function<void(io::Vertex&)> grain(float depth, std::uint32_t seed, const std::vector<Ring>& rings)
{
    return [depth, seed, &rings](io::Vertex& v) {
        const float lines = fbm(glm::vec3{v.position.x * 9, v.position.y * 2.5f, v.position.z * 9}, seed, {.count = 3});
        v.position += v.normal * (lines * std::min(depth, 0.25f * thicknessAt(rings, v.position)));
    };
}

} // namespace

Mesh growDead(const DeadShape& shape)
{
    Random random{shape.seed};
    Wood wood;
    const int surface = wood.mesh.surface({.texture = "bark_dead", .roughness = 0.9f});
    Limb trunk = shape.lying ? lyingTrunk(shape, random)
                             : growTrunk({.height = shape.height,
                                          .radius = shape.radius,
                                          .rings = shape.rings,
                                          .gnarl = 0.10f,
                                          .lean = 0.05f,
                                          .tipShare = 0.16f,
                                          .flare = 0.7f},
                                         random);
    for (Ring& ring : trunk.rings)
        ring.light = shape.lying ? 0.85f : glm::mix(0.55f, 1.0f, glm::smoothstep(-0.2f, 1.2f, ring.centre.y));
    wood.rings = trunk.rings;
    addTube(wood.mesh, trunk.rings,
            {.sides = shape.sides,
             .surface = surface,
             .around = 2,
             .metres = 1.8f,
             .pointed = true,
             .seed = std::uint32_t(shape.seed),
             .wobble = 0.16f});
    for (int i = 0; i < shape.branches; ++i)
        addBareBranch(wood, shape, trunk, i, surface, random);
    refineTo(wood.mesh, shape.triangles, grain(shape.radius * 0.10f, std::uint32_t(shape.seed), wood.rings));
    smoothNormals(wood.mesh, 70);
    return std::move(wood.mesh);
}

Mesh makeStump(const StumpShape& shape)
{
    const auto seed = std::uint32_t(shape.seed);
    Mesh mesh;
    const int bark = mesh.surface({.texture = shape.bark, .roughness = 0.93f});
    const int wood = mesh.surface({.texture = shape.broken ? "bark_dead" : "wood_rings", .roughness = 0.85f});
    std::vector<Ring> rings;
    for (int i = 0; i < shape.rings; ++i) {
        const float t = float(i) / float(shape.rings - 1);
        const float y = glm::mix(-0.25f, shape.height, t);
        const float foot = std::exp(-std::max(0.0f, y) / (shape.radius * 0.55f));
        rings.push_back({.centre = {0, y, 0},
                         .radius = shape.radius * (1 + 0.45f * foot),
                         .light = glm::mix(0.5f, 1.0f, glm::smoothstep(-0.1f, 0.4f, y)),
                         .flare = 0.75f * foot});
    }
    const TubeLook look{
        .sides = shape.sides, .surface = bark, .around = 2, .metres = 1.1f, .seed = seed, .wobble = 0.13f};
    addTube(mesh, rings, look);
    addCap(mesh, rimOf(rings[rings.size() - 2], rings.back(), look), wood);

    // The top is not level: sawn askew, or torn into splinters that stand up where it broke.
    const auto lift = [&](glm::vec3 p) {
        const float top = glm::smoothstep(shape.height * 0.55f, shape.height, p.y);
        if (!shape.broken) return top * (p.x * 0.10f + p.z * 0.05f);
        const float torn = ridged(glm::vec2{p.x, p.z} * (2.2f / shape.radius), seed + 3, {.count = 3}) - 0.35f;
        return top * shape.height * (0.85f * torn + 0.35f * p.x / shape.radius);
    };
    for (Triangle& t : mesh.triangles())
        for (io::Vertex& corner : t.corners)
            corner.position.y += lift(corner.position);
    refineTo(mesh, shape.triangles, [&](io::Vertex& v) {
        const float rough = fbm(glm::vec3{v.position.x * 7, v.position.y * 2.2f, v.position.z * 7}, seed, {.count = 3});
        const bool onTop = v.normal.y > 0.8f;
        if (onTop && shape.broken) v.position.y += 0.10f * shape.height * rough;
        if (!onTop) v.position += v.normal * (rough * shape.radius * 0.06f);
    });
    smoothNormals(mesh, shape.broken ? 50 : 60, bark);
    smoothNormals(mesh, shape.broken ? 35 : 60, wood);
    return mesh;
}

} // namespace make
