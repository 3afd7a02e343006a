#include "projects/make/camp.h"
#include "projects/make/limbs.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

glm::vec3 around(float angle, float radius, float y)
{
    return {std::cos(angle) * radius, y, std::sin(angle) * radius};
}

void addStones(Mesh& mesh, const FireShape& shape, Random& random)
{
    for (int i = 0; i < shape.stones; ++i) {
        const float size = random.range(0.22f, 0.34f);
        const Mesh stone = makeStone({.seed = shape.seed * 100 + std::uint64_t(i),
                                      .triangles = shape.stoneTriangles,
                                      .size = {size * 1.2f, size * 0.85f, size},
                                      .metres = 0.6f});
        const float angle = 6.2831853f * (float(i) + 0.25f * random.bell()) / float(shape.stones);
        glm::mat4 to{1};
        to[3] = glm::vec4{around(angle, 0.62f + 0.05f * random.bell(), -0.05f), 1};
        const float turn = random.range(0, 6.28f);
        to[0] = {std::cos(turn), 0, std::sin(turn), 0};
        to[2] = {-std::sin(turn), 0, std::cos(turn), 0};
        mesh.append(stone, to);
    }
}

void addAsh(Mesh& mesh, int sides)
{
    const int ash = mesh.surface({.texture = "ash", .roughness = 1});
    const int embers = mesh.surface(
        {.texture = "ash", .tint = {0.25f, 0.08f, 0.03f}, .roughness = 1, .emissive = {1.6f, 0.35f, 0.05f}});
    const auto disc = [&](float radius, float y, float rise, int surface) {
        for (int i = 0; i < sides; ++i) {
            const auto corner = [&](float angle, float r, float height) {
                const glm::vec3 p = around(angle, r, height);
                return io::Vertex{.position = p, .normal = {0, 1, 0}, .uv0 = {p.x * 0.9f, p.z * 0.9f}};
            };
            const float a = 6.2831853f * float(i) / float(sides), b = 6.2831853f * float(i + 1) / float(sides);
            mesh.add({{corner(0, 0, y + rise), corner(b, radius, y), corner(a, radius, y)}, surface});
        }
    };
    disc(0.66f, 0.005f, 0.07f, ash);
    disc(0.17f, 0.055f, 0.035f, embers);
}

void addLogs(Mesh& mesh, const FireShape& shape, Random& random)
{
    const int charred = mesh.surface({.texture = "charred", .roughness = 1});
    for (int i = 0; i < shape.logs; ++i) {
        const float angle = 6.2831853f * (float(i) + 0.3f * random.bell()) / float(shape.logs);
        const glm::vec3 foot = around(angle, random.range(0.40f, 0.52f), 0.05f);
        const glm::vec3 head = around(angle + 3.0f + 0.4f * random.bell(), 0.05f, random.range(0.36f, 0.48f));
        const glm::vec3 end = head + (head - foot) * 0.12f;
        std::vector<Ring> rings;
        for (int r = 0; r < shape.logRings; ++r) {
            const float t = float(r) / float(shape.logRings - 1);
            rings.push_back({.centre = glm::mix(foot, end, t),
                             .radius = 0.055f * random.range(0.85f, 1.1f),
                             .light = glm::mix(0.9f, 0.6f, t)});
        }
        const TubeLook look{
            .sides = shape.logSides, .surface = charred, .metres = 0.5f, .seed = std::uint32_t(i), .wobble = 0.15f};
        addTube(mesh, rings, look);
        std::vector<glm::vec3> rim = rimOf(rings[rings.size() - 2], rings.back(), look);
        addCap(mesh, rim, charred);
        std::vector<glm::vec3> bottom = rimOf(rings[0], rings[1], look);
        for (glm::vec3& p : bottom)
            p += rings[0].centre - rings[1].centre;
        std::reverse(bottom.begin(), bottom.end());
        addCap(mesh, bottom, charred);
    }
}

// Three poles bound at the top, and a pot that hangs from them on a chain.
void addPot(Mesh& mesh, const FireShape& shape)
{
    const int wood = mesh.surface({.texture = "bark_dead", .roughness = 0.9f});
    const int iron = mesh.surface({.texture = "iron", .tint = glm::vec3{0.35f}, .roughness = 0.6f, .metallic = 0.4f});
    for (int i = 0; i < 3; ++i) {
        const float angle = 2.0944f * float(i) + 0.4f;
        const Ring rings[] = {{.centre = around(angle, 0.80f, -0.05f), .radius = 0.028f},
                              {.centre = around(angle, 0.38f, 0.82f), .radius = 0.024f},
                              {.centre = around(angle + 3.14159f, 0.08f, 1.75f), .radius = 0.018f}};
        addTube(mesh, rings, {.sides = std::max(4, shape.logSides - 1), .surface = wood, .metres = 0.8f});
    }
    const Ring chain[] = {{.centre = {0, 1.56f, 0}, .radius = 0.008f}, {.centre = {0, 0.93f, 0}, .radius = 0.008f}};
    addTube(mesh, chain, {.sides = 3, .surface = iron});
    // Radius and height of the pot's profile, from under its belly over the rim to its inside.
    const glm::vec2 profile[] = {{0.02f, 0.52f}, {0.10f, 0.53f}, {0.155f, 0.59f}, {0.165f, 0.67f}, {0.145f, 0.75f},
                                 {0.16f, 0.78f}, {0.14f, 0.78f}, {0.14f, 0.66f},  {0.01f, 0.62f}};
    std::vector<Ring> rings;
    for (const glm::vec2& p : profile)
        rings.push_back({.centre = {0, p.y, 0}, .radius = p.x, .light = p.x < 0.145f && p.y > 0.6f ? 0.3f : 0.9f});
    for (std::size_t i = 0; i < rings.size(); ++i) { // one ring after another; the profile turns back on itself inside
        if (i == 0) continue;
        for (int s = 0; s < shape.potSides; ++s) {
            const auto corner = [&](const Ring& ring, int side) {
                const float a = 6.2831853f * float(side % shape.potSides) / float(shape.potSides);
                const glm::vec3 p = around(a, ring.radius, ring.centre.y);
                return io::Vertex{.position = p,
                                  .normal = around(a, 1, 0),
                                  .uv0 = {float(side) / float(shape.potSides) * 2, -ring.centre.y * 3},
                                  .colour = shade(ring.light)};
            };
            mesh.addQuad(
                {corner(rings[i - 1], s), corner(rings[i], s), corner(rings[i], s + 1), corner(rings[i - 1], s + 1)},
                iron);
        }
    }
    for (int i = 0; i < 8; ++i) { // its handle
        const auto point = [](int k) {
            const float a = 3.14159f * float(k) / 8;
            return glm::vec3{std::cos(a) * 0.15f, 0.77f + std::sin(a) * 0.17f, 0};
        };
        const Ring piece[] = {{.centre = point(i), .radius = 0.007f}, {.centre = point(i + 1), .radius = 0.007f}};
        addTube(mesh, piece, {.sides = 3, .surface = iron});
    }
}

} // namespace

Mesh makeCampfire(const FireShape& shape)
{
    Random random{shape.seed};
    Mesh mesh;
    addAsh(mesh, shape.potSides + 4);
    addLogs(mesh, shape, random);
    addPot(mesh, shape);
    smoothNormals(mesh, 50);
    Mesh stones;
    addStones(stones, shape, random);
    mesh.append(stones);
    if (shape.triangles > 0) refineTo(mesh, shape.triangles);
    return mesh;
}

} // namespace make
