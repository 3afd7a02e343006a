#include "projects/make/trees.h"

#include "io/base/contract.h"
#include "projects/make/limbs.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

// Radius of the crown as a share of its widest, `s` from its base (0) to its top (1).
float envelope(float s, float widest)
{
    const float t = s < widest ? (widest - s) / widest : (s - widest) / (1 - widest);
    return std::sqrt(std::max(0.0f, 1 - t * t * (s < widest ? 0.75f : 1.0f)));
}

struct Clump {
    glm::vec3 centre;
    float radius;
    float tone; // of its leaves
};

struct Skeleton {
    Limb trunk;
    std::vector<Limb> branches, twigs;
    std::vector<Clump> clumps;
};

class Grower {
public:
    explicit Grower(const TreeShape& shape) : m_shape{shape}, m_random{shape.seed} {}

    Skeleton grow()
    {
        Skeleton tree;
        tree.trunk = growTrunk({.height = m_shape.height * 0.94f,
                                .radius = m_shape.trunkRadius,
                                .rings = m_shape.trunkRings,
                                .gnarl = m_shape.gnarl * 0.35f,
                                .lean = m_shape.lean},
                               m_random);
        for (int i = 0; i < m_shape.branches; ++i)
            addBranch(tree, i);
        addClump(tree, tree.trunk.rings.back().centre, 0.9f);
        for (int i = 0; i < m_shape.fill; ++i)
            fillGap(tree);
        lightOf(tree);
        return tree;
    }

private:
    void addBranch(Skeleton& tree, int i)
    {
        const float s = std::pow((float(i) + 0.35f) / float(m_shape.branches), 0.85f) * 0.92f; // place in the crown
        const float share = m_shape.crownBase + s * (0.97f - m_shape.crownBase);
        const float angle = glm::radians(glm::mix(m_shape.angleLow, m_shape.angleHigh, s) + m_random.bell() * 9);
        const float azimuth = float(i) * 2.39996f + m_random.bell() * 0.5f; // the golden angle keeps neighbours apart
        const Ring start = ringAt(tree.trunk, share);
        // Where the branch ends the crown is higher than where it starts.
        const float reach =
            m_shape.crownRadius * envelope(std::min(1.0f, s + 0.10f), m_shape.widest) * m_random.range(0.80f, 1.02f);
        const float length = std::max(0.12f * m_shape.height, reach / std::max(0.35f, std::sin(angle)) * 0.82f);
        const glm::vec3 direction{std::sin(angle) * std::cos(azimuth), std::cos(angle),
                                  std::sin(angle) * std::sin(azimuth)};
        const float thick = std::min(start.radius * 0.66f, 0.012f * m_shape.height * 0.5f + length * 0.021f);
        Limb branch = growLimb({.from = start.centre,
                                .direction = direction,
                                .length = length,
                                .radius = thick,
                                .tipRadius = thick * 0.25f,
                                .rings = m_shape.branchRings,
                                .upturn = m_shape.upturn,
                                .gnarl = m_shape.gnarl,
                                .droop = m_shape.droop},
                               m_random);
        addClump(tree, branch.rings.back().centre, 1);
        for (int k = 0; k < m_shape.twigs; ++k)
            addTwig(tree, branch, length, k);
        tree.branches.push_back(std::move(branch));
    }

    void addTwig(Skeleton& tree, const Limb& branch, float parentLength, int k)
    {
        const float share = glm::mix(0.42f, 0.86f, (float(k) + m_random.unit()) / float(m_shape.twigs));
        const Ring start = ringAt(branch, share);
        const glm::vec3 ahead = directionAt(branch, share);
        const glm::vec3 side = glm::normalize(glm::cross(ahead, glm::vec3{0, 1, 0}) + glm::vec3{1e-3f, 0, 0});
        const float hand = k % 2 == 0 ? 1.0f : -1.0f;
        const glm::vec3 direction =
            glm::normalize(ahead * 0.8f + side * hand * m_random.range(0.5f, 1.0f) +
                           glm::vec3{0, m_random.range(-0.25f, 0.55f) - m_shape.droop * 0.3f, 0});
        const float length = parentLength * m_random.range(0.34f, 0.52f) * (1.25f - share * 0.5f);
        Limb twig = growLimb({.from = start.centre,
                              .direction = direction,
                              .length = length,
                              .radius = start.radius * 0.62f,
                              .tipRadius = 0.004f,
                              .rings = 3,
                              .upturn = m_shape.upturn,
                              .gnarl = m_shape.gnarl,
                              .droop = m_shape.droop * 1.4f},
                             m_random);
        addClump(tree, twig.rings.back().centre, 0.88f);
        tree.twigs.push_back(std::move(twig));
    }

    void addClump(Skeleton& tree, glm::vec3 centre, float size)
    {
        tree.clumps.push_back({centre, m_shape.crownRadius * m_shape.clumpSize * size * m_random.range(0.85f, 1.15f),
                               0.82f + 0.18f * unitOf(hash(std::uint32_t(m_shape.seed * 131 + tree.clumps.size())))});
    }

    // A clump where the crown's hull is farthest from those there are.
    void fillGap(Skeleton& tree)
    {
        glm::vec3 best{0};
        float most = -1;
        for (int attempt = 0; attempt < 24; ++attempt) {
            const float s = m_random.range(0.05f, 0.95f);
            const float azimuth = m_random.range(0, 6.2831853f);
            const float radius = m_shape.crownRadius * envelope(s, m_shape.widest) * m_random.range(0.35f, 0.72f);
            const float y = m_shape.height * glm::mix(m_shape.crownBase + 0.06f, 0.95f, s);
            const Ring axis = ringAt(tree.trunk, y / m_shape.height);
            const glm::vec3 at{axis.centre.x + std::cos(azimuth) * radius, y,
                               axis.centre.z + std::sin(azimuth) * radius};
            float nearest = 1e9f;
            for (const Clump& clump : tree.clumps)
                nearest = std::min(nearest, glm::length(clump.centre - at) - clump.radius * 0.4f);
            if (nearest > most) {
                most = nearest;
                best = at;
            }
        }
        addClump(tree, best, 1.05f);
    }

    void lightOf(Skeleton& tree) const
    {
        const float base = m_shape.height * m_shape.crownBase;
        for (Ring& ring : tree.trunk.rings) {
            const float inside = glm::smoothstep(base - 1.0f, base + 2.0f, ring.centre.y);
            ring.light = glm::mix(glm::mix(0.62f, 0.95f, glm::smoothstep(-0.2f, 1.0f, ring.centre.y)), 0.5f, inside);
        }
        for (Limb& branch : tree.branches)
            for (Ring& ring : branch.rings)
                ring.light = 0.58f;
        for (Limb& twig : tree.twigs)
            for (Ring& ring : twig.rings)
                ring.light = 0.66f;
    }

    const TreeShape& m_shape;
    Random m_random;
};

// The crown as an ellipsoid: what is near its middle is dark, and leaves face away from it.
struct Crown {
    glm::vec3 centre;
    glm::vec3 radii;

    explicit Crown(const std::vector<Clump>& clumps)
    {
        io::Box box;
        for (const Clump& clump : clumps) {
            box.add(clump.centre - clump.radius);
            box.add(clump.centre + clump.radius);
        }
        centre = box.centre() - glm::vec3{0, box.size().y * 0.08f, 0};
        radii = box.size() * 0.5f;
    }
    glm::vec3 outward(glm::vec3 p) const { return glm::normalize((p - centre) / radii + glm::vec3{0, 1e-4f, 0}); }
    float depth(glm::vec3 p) const { return glm::length((p - centre) / radii); } // 1 at the rim
};

void addLeafCard(Mesh& mesh, int surface, const TreeShape& shape, const Clump& clump, const Crown& crown,
                 glm::vec3 towards, Random& random)
{
    const glm::vec3 at = clump.centre + towards * clump.radius * random.range(0.22f, 0.88f) * glm::vec3{1, 0.85f, 1};
    const glm::vec3 facing = glm::normalize(towards * 0.7f + random.direction() * 0.7f + glm::vec3{0, 0.15f, 0});
    const glm::vec3 growth =
        crown.outward(at) * 0.8f + glm::vec3{0, 0.45f - shape.droop * 1.6f, 0} + random.direction() * 0.45f;
    glm::vec3 up = growth - facing * glm::dot(growth, facing);
    if (glm::dot(up, up) < 1e-4f) up = glm::cross(facing, {0.4f, 0.1f, 0.9f});
    up = glm::normalize(up);
    const float size = shape.cardSize * random.range(0.72f, 1.2f);
    const Card card{.base = at - up * (size * 0.5f),
                    .up = up * size,
                    .right = glm::cross(up, facing) * (size * 0.5f),
                    .bend = facing * (size * random.range(-0.10f, 0.10f)),
                    .mirrored = random.chance(0.5f)};
    std::array<io::Vertex, 4> corners = cornersOf(card);
    // Young leaves are lighter and yellower, old ones darker and bluer; a clump keeps together.
    const float age = random.unit();
    const float tone = clump.tone * glm::mix(0.76f, 1.0f, age);
    const glm::vec3 tint = glm::mix(glm::vec3{0.84f, 0.94f, 0.98f}, glm::vec3{1.0f, 0.98f, 0.80f}, age) * tone;
    for (io::Vertex& corner : corners) {
        const glm::vec3 inClump = (corner.position - clump.centre) / clump.radius;
        const glm::vec3 fromClump = glm::normalize(inClump + glm::vec3{0, 1e-4f, 0});
        corner.normal =
            glm::normalize(fromClump * 0.70f + crown.outward(corner.position) * 0.75f + glm::vec3{0, 0.08f, 0});
        const float depth = crown.depth(corner.position);
        const float below = glm::smoothstep(-1.0f, 0.5f, (corner.position.y - crown.centre.y) / crown.radii.y);
        // Each clump shades itself: its top is in the light, its underside and its heart are not.
        const float under = glm::smoothstep(-0.9f, 0.7f, inClump.y);
        const float heart = glm::smoothstep(0.1f, 1.2f, glm::length(inClump));
        corner.colour =
            shade(glm::mix(0.32f, 1.0f, glm::smoothstep(0.30f, 0.95f, depth)) * glm::mix(0.72f, 1.0f, below) *
                      glm::mix(0.56f, 1.0f, under) * glm::mix(0.76f, 1.0f, heart),
                  tint);
    }
    mesh.addQuad(corners, surface);
}

// Even directions about a clump (Fibonacci sphere), those that look into the crown left out where others are left.
Mesh leavesOf(const TreeShape& shape, const std::vector<Clump>& clumps, int cards)
{
    Mesh mesh;
    const int surface =
        mesh.surface({.texture = shape.leaf, .tint = shape.leafTint, .roughness = 0.75f, .leaves = true});
    Random random{shape.seed, 7};
    const Crown crown{clumps};
    for (int i = 0; i < cards; ++i) {
        const Clump& clump = clumps[std::size_t(i) % clumps.size()];
        glm::vec3 towards = random.direction();
        const glm::vec3 out = crown.outward(clump.centre);
        for (int attempt = 0; attempt < 4 && glm::dot(towards, out) < -0.15f; ++attempt)
            towards = random.direction();
        addLeafCard(mesh, surface, shape, clump, crown, towards, random);
    }
    return mesh;
}

Mesh woodOf(const TreeShape& shape, const Skeleton& tree)
{
    Mesh mesh;
    const int surface = mesh.surface({.texture = shape.bark, .roughness = 0.92f});
    const float repeats = std::max(1.0f, std::round(shape.trunkRadius * 6.28f / 1.1f));
    addTube(mesh, tree.trunk.rings,
            {.sides = shape.trunkSides,
             .surface = surface,
             .around = repeats,
             .metres = 1.6f,
             .seed = std::uint32_t(shape.seed),
             .wobble = 0.10f});
    for (const Limb& branch : tree.branches)
        addTube(mesh, branch.rings, {.sides = shape.branchSides, .surface = surface, .metres = 1.2f, .seed = 3});
    for (const Limb& twig : tree.twigs)
        addTube(mesh, twig.rings, {.sides = 3, .surface = surface, .metres = 1.0f, .pointed = true});
    smoothNormals(mesh, 80);
    return mesh;
}

} // namespace

Mesh growTree(const TreeShape& shape)
{
    const Skeleton tree = Grower{shape}.grow();
    Mesh mesh = woodOf(shape, tree);
    int cards = shape.cards;
    if (shape.triangles > 0) {
        EXPECTS(mesh.count() + 40 < shape.triangles);
        cards = int(shape.triangles - mesh.count()) / 2;
        refineTo(mesh, shape.triangles - std::size_t(cards) * 2);
    }
    mesh.append(leavesOf(shape, tree.clumps, cards));
    return mesh;
}

} // namespace make
