#include "io/base/contract.h"
#include "projects/make/limbs.h"
#include "projects/make/trees.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

// One branch: two leaning halves of a spray picture that meet in a ridge, like a roof. Four triangles.
struct Bough {
    glm::vec3 root{0}, tip{0};
    float halfWidth = 0.6f;
    float slope = 0.45f; // how far the edges hang below the ridge, as a share of the half width
    float light = 1;
};

void addBough(Mesh& mesh, int surface, const Bough& bough, const FirShape& shape, Random& random)
{
    const glm::vec3 along = bough.tip - bough.root;
    const glm::vec3 side =
        glm::normalize(glm::cross(along, glm::vec3{0, 1, 0}) + glm::vec3{1e-4f, 0, 0}) * bough.halfWidth;
    const glm::vec3 fall{0, -bough.halfWidth * bough.slope, 0};
    const float tone = random.range(0.82f, 1.0f);
    const glm::vec3 tint{tone * random.range(0.92f, 1.0f), tone, tone * random.range(0.85f, 1.0f)};
    const auto corner = [&](float t, float across) {
        io::Vertex v{.position = bough.root + along * t + side * across + fall * std::abs(across),
                     .uv0 = {0.5f + across * 0.5f, 1 - t}};
        const glm::vec3 axis{0, v.position.y, 0};
        const glm::vec3 out = glm::normalize(v.position - axis + glm::vec3{1e-4f, 0, 0});
        v.normal = glm::normalize(out * 0.75f + glm::vec3{0, 0.62f, 0} + side / bough.halfWidth * across * 0.35f);
        v.colour =
            shade(bough.light * glm::mix(0.42f, 1.0f, t) * (v.position.y < shape.height * 0.3f ? 0.9f : 1.0f), tint);
        return v;
    };
    mesh.addQuad({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)}, surface);
    mesh.addQuad({corner(0, -1), corner(0, 0), corner(1, 0), corner(1, -1)}, surface);
}

void addBoughs(Mesh& mesh, const FirShape& shape, int count)
{
    const int surface = mesh.surface({.texture = "leaf_fir", .roughness = 0.8f, .leaves = true});
    Random random{shape.seed, 3};
    for (int i = 0; i < count; ++i) {
        const float s = (float(i) + random.range(0.0f, 0.9f)) / float(count);
        const float share = 1 - std::pow(1 - s, 0.78f); // closer together towards the top, where they are short
        const float height = glm::mix(shape.crownBase, 0.985f, share) * shape.height;
        const float azimuth = float(i) * 2.39996f + random.bell() * 0.4f;
        const float lower = std::min(1.0f, 0.72f + share * 3.0f); // the lowest branches are thin
        const float reach = std::max(0.32f, shape.crownRadius * (std::pow(1 - share, 0.82f) + 0.035f) * lower *
                                                random.range(0.82f, 1.1f));
        const float pitch = glm::mix(-0.36f, 0.62f, std::pow(share, 1.3f)) + random.bell() * 0.10f;
        const glm::vec3 out{std::cos(azimuth) * std::cos(pitch), std::sin(pitch), std::sin(azimuth) * std::cos(pitch)};
        addBough(mesh, surface,
                 {.root = glm::vec3{0, height, 0} + out * 0.04f,
                  .tip = glm::vec3{0, height, 0} + out * reach,
                  .halfWidth = reach * glm::mix(0.44f, 0.62f, share),
                  .slope = random.range(0.35f, 0.75f),
                  .light = random.range(0.85f, 1.0f)},
                 shape, random);
    }
    for (int i = 0; i < 2; ++i) { // the leader
        const glm::vec3 right =
            i == 0 ? glm::vec3{shape.height * 0.014f, 0, 0} : glm::vec3{0, 0, shape.height * 0.014f};
        std::array<io::Vertex, 4> corners =
            cornersOf({.base = {0, shape.height * 0.955f, 0}, .up = {0, shape.height * 0.07f, 0}, .right = right});
        for (io::Vertex& corner : corners) {
            corner.normal =
                glm::normalize(glm::vec3{corner.position.x, 0.3f, corner.position.z} + glm::vec3{0, 1e-3f, 0});
            corner.colour = shade(0.95f);
        }
        mesh.addQuad(corners, surface);
    }
}

} // namespace

Mesh growFir(const FirShape& shape)
{
    Random random{shape.seed};
    Limb trunk = growTrunk({.height = shape.height * 0.97f,
                            .radius = shape.trunkRadius,
                            .rings = shape.trunkRings,
                            .gnarl = 0,
                            .lean = 0,
                            .tipShare = 0.06f,
                            .flare = 0.4f},
                           random);
    for (Ring& ring : trunk.rings)
        ring.light = ring.centre.y > shape.height * shape.crownBase ? 0.42f : 0.75f;
    Mesh mesh;
    const int bark = mesh.surface({.texture = "bark_fir", .roughness = 0.92f});
    addTube(mesh, trunk.rings,
            {.sides = shape.trunkSides,
             .surface = bark,
             .around = 3,
             .metres = 0.9f,
             .seed = std::uint32_t(shape.seed),
             .wobble = 0.06f});
    smoothNormals(mesh, 80);

    int boughs = shape.branches;
    if (shape.triangles > 0) {
        EXPECTS(mesh.count() + 8 <= shape.triangles);
        boughs = int(shape.triangles - mesh.count() - 4) / 4;
        refineTo(mesh, shape.triangles - std::size_t(boughs) * 4 - 4);
    }
    Mesh needles;
    addBoughs(needles, shape, boughs);
    mesh.append(needles);
    return mesh;
}

} // namespace make
