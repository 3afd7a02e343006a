#include "projects/make/camp.h"

#include "projects/make/limbs.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

// A sheet between four corners (a b at the bottom, d c at the top), `sag` metres deep in its middle along its normal.
struct Sheet {
    glm::vec3 a, b, c, d;
    int across = 1, down = 1;
    float sag = 0;
    float metres = 2; // one repeat of the texture
    int surface = 0;
    float light = 1;
};

void addSheet(Mesh& mesh, const Sheet& sheet)
{
    const glm::vec3 normal = glm::normalize(glm::cross(sheet.b - sheet.a, sheet.d - sheet.a));
    const float width = glm::length(sheet.b - sheet.a), height = glm::length(sheet.d - sheet.a);
    const auto corner = [&](int i, int j) {
        const float s = float(i) / float(sheet.across), t = float(j) / float(sheet.down);
        const glm::vec3 p = glm::mix(glm::mix(sheet.a, sheet.b, s), glm::mix(sheet.d, sheet.c, s), t);
        const float hang = sheet.sag * 4 * s * (1 - s) * (0.5f + 0.5f * 4 * t * (1 - t));
        return io::Vertex{.position = p - normal * hang,
                          .normal = normal,
                          .uv0 = {s * width / sheet.metres, (1 - t) * height / sheet.metres},
                          .colour = shade(sheet.light)};
    };
    for (int j = 0; j < sheet.down; ++j)
        for (int i = 0; i < sheet.across; ++i)
            mesh.addQuad({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, sheet.surface);
}

void addPole(Mesh& mesh, glm::vec3 from, glm::vec3 to, float radius, int surface, int sides = 5)
{
    const glm::vec3 middle = (from + to) * 0.5f;
    const Ring rings[] = {{.centre = from, .radius = radius, .light = 0.8f},
                          {.centre = middle, .radius = radius * 0.95f},
                          {.centre = to, .radius = radius * 0.85f}};
    const TubeLook look{.sides = sides,
                        .surface = surface,
                        .metres = 0.9f,
                        .seed = std::uint32_t(from.x * 91 + from.z * 37),
                        .wobble = 0.1f};
    addTube(mesh, rings, look);
    addCap(mesh, rimOf(rings[1], rings[2], look), surface, 0.1f);
}

// The profile of an axe's head seen from the side (x towards the edge, y along the handle), thickness half in z.
struct HeadPoint {
    float x, y, half;
};

void addHead(Mesh& mesh, int surface)
{
    const HeadPoint rows[][3] = {{{-0.055f, 0.045f, 0.022f}, {-0.055f, 0, 0.024f}, {-0.055f, -0.045f, 0.022f}},
                                 {{-0.02f, 0.042f, 0.023f}, {-0.02f, 0, 0.026f}, {-0.02f, -0.042f, 0.023f}},
                                 {{0.03f, 0.040f, 0.021f}, {0.03f, 0, 0.022f}, {0.03f, -0.042f, 0.021f}},
                                 {{0.09f, 0.052f, 0.011f}, {0.09f, 0, 0.012f}, {0.09f, -0.062f, 0.011f}},
                                 {{0.150f, 0.078f, 0.001f}, {0.162f, 0, 0.001f}, {0.145f, -0.100f, 0.001f}}};
    const auto vertex = [](const HeadPoint& p, float side) {
        const float bright = p.x > 0.1f ? 1.0f : 0.62f; // the edge is ground bare
        return io::Vertex{.position = {p.x, p.y, p.half * side},
                          .normal = {0, 0, side},
                          .uv0 = {p.x * 3, p.y * 3},
                          .colour = shade(bright)};
    };
    const auto quad = [&](io::Vertex a, io::Vertex b, io::Vertex c, io::Vertex d, bool flip) {
        if (flip)
            mesh.addQuad({d, c, b, a}, surface);
        else
            mesh.addQuad({a, b, c, d}, surface);
    };
    for (int r = 0; r < 4; ++r) {
        for (const float side : {-1.0f, 1.0f})
            for (int k = 0; k < 2; ++k)
                quad(vertex(rows[r][k], side), vertex(rows[r][k + 1], side), vertex(rows[r + 1][k + 1], side),
                     vertex(rows[r + 1][k], side), side < 0);
        for (const int k : {0, 2}) // top and bottom
            quad(vertex(rows[r][k], -1), vertex(rows[r][k], 1), vertex(rows[r + 1][k], 1), vertex(rows[r + 1][k], -1),
                 k == 2);
    }
    for (int k = 0; k < 2; ++k) // the poll
        quad(vertex(rows[0][k], 1), vertex(rows[0][k], -1), vertex(rows[0][k + 1], -1), vertex(rows[0][k + 1], 1),
             false);
    smoothNormals(mesh, 35, surface);
}

} // namespace

Mesh makeAxe(std::size_t triangles)
{
    Mesh built;
    const int iron = built.surface({.texture = "iron", .roughness = 0.45f, .metallic = 0.85f});
    const int wood = built.surface({.texture = "planks", .tint = {1.0f, 0.88f, 0.7f}, .roughness = 0.7f});
    addHead(built, iron);
    std::vector<Ring> rings;
    for (int i = 0; i <= 9; ++i) {
        const float t = float(i) / 9;
        const float knob = glm::smoothstep(0.88f, 1.0f, t) * 0.35f;
        rings.push_back({.centre = {-0.012f - 0.02f * std::sin(t * 5.2f), 0.06f - t * 0.78f, 0},
                         .radius = 0.0185f * (1 - 0.12f * std::sin(t * 3.1f) + knob)});
    }
    const TubeLook look{.sides = 8, .surface = wood, .around = 0.22f, .metres = 0.7f, .flatten = 0.68f};
    addTube(built, rings, look);
    addCap(built, rimOf(rings[8], rings[9], look), wood, 0.05f);
    smoothNormals(built, 70, wood);
    refineTo(built, triangles);

    // Struck into the block: the edge points down, the handle rises at a slant.
    const glm::vec3 down = glm::normalize(glm::vec3{-0.52f, -0.86f, 0});
    glm::mat4 turn{1};
    turn[0] = glm::vec4{down, 0};
    turn[1] = glm::vec4{glm::cross(glm::vec3{0, 0, 1}, down), 0};
    Mesh placed;
    const glm::vec3 edge = glm::vec3{turn * glm::vec4{0.162f, 0, 0, 0}};
    turn[3] = glm::vec4{-edge - glm::vec3{0, 0.02f, 0}, 1};
    placed.append(built, turn);
    return placed;
}

Mesh makeTent()
{
    constexpr float kHalf = 1.15f, kTop = 1.65f, kFront = 1.35f, kBack = -1.35f;
    Mesh mesh;
    const int cloth = mesh.surface({.texture = "cloth", .roughness = 0.95f, .twoSided = true});
    const int inside = mesh.surface({.texture = "cloth", .tint = {0.55f, 0.5f, 0.42f}, .roughness = 0.95f});
    const int wood = mesh.surface({.texture = "bark_dead", .roughness = 0.9f});
    const glm::vec3 front{0, kTop, kFront}, back{0, kTop - 0.06f, kBack};
    const auto foot = [](float side, float z) { return glm::vec3{side * kHalf, 0.02f, z}; };
    for (const float side : {1.0f, -1.0f}) // the roof: its outside is to the right of whoever walks from a to b
        addSheet(mesh, {.a = foot(side, side > 0 ? kFront : kBack),
                        .b = foot(side, side > 0 ? kBack : kFront),
                        .c = side > 0 ? back : front,
                        .d = side > 0 ? front : back,
                        .across = 5,
                        .down = 4,
                        .sag = 0.16f,
                        .metres = 2,
                        .surface = cloth});
    addSheet(mesh, {.a = foot(1, kBack),
                    .b = foot(-1, kBack),
                    .c = back,
                    .d = back,
                    .across = 3,
                    .down = 3,
                    .sag = -0.08f,
                    .surface = cloth});
    for (const float side : {-1.0f, 1.0f}) { // flaps, folded back
        const glm::vec3 low = foot(side, kFront), out = low + glm::vec3{-side * 0.18f, 0, 0.55f};
        const glm::vec3 loose = front + glm::vec3{-side * 0.02f, -0.05f, 0.04f};
        addSheet(mesh, {.a = side > 0 ? out : low,
                        .b = side > 0 ? low : out,
                        .c = side > 0 ? front : loose,
                        .d = side > 0 ? loose : front,
                        .across = 2,
                        .down = 3,
                        .sag = 0.1f,
                        .surface = cloth});
    }
    addSheet(mesh, {.a = foot(-0.93f, kFront - 0.1f),
                    .b = foot(0.93f, kFront - 0.1f),
                    .c = foot(0.93f, kBack),
                    .d = foot(-0.93f, kBack),
                    .surface = inside,
                    .light = 0.5f});
    smoothNormals(mesh, 40, cloth);
    addPole(mesh, {0, -0.15f, kFront + 0.02f}, {0, kTop + 0.16f, kFront + 0.02f}, 0.03f, wood);
    addPole(mesh, {0, -0.15f, kBack - 0.02f}, {0, kTop + 0.10f, kBack - 0.02f}, 0.03f, wood);
    for (const float end : {-1.0f, 1.0f}) {
        const glm::vec3 top{0, kTop, end > 0 ? kFront : kBack};
        for (const float side : {-1.0f, 1.0f}) {
            const glm::vec3 peg{side * 0.7f, 0.04f, top.z + end * 1.35f};
            addPole(mesh, peg, top + glm::vec3{0, 0.03f, 0}, 0.008f, wood, 3);
            addPole(mesh, peg - glm::vec3{0, 0.12f, end * 0.03f}, peg + glm::vec3{0, 0.14f, end * 0.05f}, 0.018f, wood,
                    4);
        }
    }
    return mesh;
}

Mesh makeFence(std::uint64_t seed)
{
    Random random{seed};
    Mesh mesh;
    const int wood = mesh.surface({.texture = "bark_dead", .roughness = 0.92f});
    for (const float x : {-1.25f, 1.25f}) {
        const glm::vec3 top{x + random.bell() * 0.05f, 1.12f + random.bell() * 0.06f, random.bell() * 0.04f};
        addPole(mesh, {x, -0.4f, 0}, top, 0.075f, wood, 6);
    }
    for (const float y : {0.42f, 0.86f}) {
        const glm::vec3 from{-1.45f, y + random.bell() * 0.06f, 0.07f}, to{1.45f, y + random.bell() * 0.08f, 0.06f};
        addPole(mesh, from, to, 0.048f, wood, 5);
    }
    addPole(mesh, {-1.2f, 0.12f, 0.11f}, {1.2f, 1.0f, 0.11f}, 0.04f, wood, 5);
    smoothNormals(mesh, 60);
    return mesh;
}

Mesh makeLog(std::uint64_t seed, float length, float radius)
{
    Mesh mesh;
    const int bark = mesh.surface({.texture = "bark_oak", .roughness = 0.93f});
    const int cut = mesh.surface({.texture = "wood_rings", .roughness = 0.85f});
    std::vector<Ring> rings;
    for (int i = 0; i < 4; ++i)
        rings.push_back({.centre = {length * (float(i) / 3 - 0.5f), radius * 0.86f, 0},
                         .radius = radius * (1 - 0.04f * float(i)),
                         .light = 0.9f});
    const TubeLook look{.sides = 9, .surface = bark, .metres = 1.2f, .seed = std::uint32_t(seed), .wobble = 0.10f};
    addTube(mesh, rings, look);
    smoothNormals(mesh, 60, bark);
    addCap(mesh, rimOf(rings[2], rings[3], look), cut);
    std::vector<Ring> reversed(rings.rbegin(), rings.rend());
    std::vector<glm::vec3> rim = rimOf(rings[0], rings[1], look); // the same shape, moved to the other end
    for (glm::vec3& p : rim)
        p = glm::vec3{rings[0].centre.x, glm::vec2{p.y - rings[1].centre.y, p.z} * (rings[0].radius / rings[1].radius) +
                                             glm::vec2{rings[0].centre.y, 0}};
    std::reverse(rim.begin(), rim.end());
    addCap(mesh, rim, cut);
    return mesh;
}

} // namespace make
