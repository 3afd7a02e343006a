#include "projects/make/camp.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr float kWide = 2.5f;  // half of its length along x, m
constexpr float kDeep = 2.0f;  // half of its depth along z
constexpr float kWall = 2.15f; // height of the walls
constexpr float kRidge = 4.0f;

struct Surfaces {
    int planks, thatch, dark, stone;
};

// Boards side by side, upright, between two points at ground level; `top` answers their height.
template <class Top>
void addBoards(Mesh& mesh, glm::vec3 from, glm::vec3 to, int count, int surface, Top top, Random& random)
{
    const glm::vec3 step = (to - from) / float(count);
    const glm::vec3 out = glm::normalize(glm::cross(step, glm::vec3{0, 1, 0}));
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at = from + step * (float(i) + 0.5f) + out * random.range(0.0f, 0.025f);
        const float height = top(at);
        addBeam(mesh, {.from = at - glm::vec3{0, 1.0f, 0},
                       .to = at + glm::vec3{0, height, 0},
                       .width = glm::length(step) * 1.02f,
                       .height = 0.06f,
                       .up = out,
                       .board = random.below(64),
                       .surface = surface,
                       .light = random.range(0.78f, 1.0f)});
    }
}

void addRoof(Mesh& mesh, int thatch)
{
    constexpr float kEaveOut = 0.55f, kGableOut = 0.45f, kThick = 0.26f;
    constexpr int kAcross = 8, kDown = 4;
    const float fall = (kRidge - kWall) / kDeep;
    for (const float side : {-1.0f, 1.0f}) {
        const auto corner = [&](int i, int j, float lift) {
            const float s = float(i) / kAcross * 2 - 1, t = float(j) / kDown;
            const float z = t * (kDeep + kEaveOut);
            const float x = s * (kWide + kGableOut);
            const float sag = 0.10f * (1 - s * s) * (1 - t) + 0.03f * std::sin(s * 9 + side + t * 4);
            return io::Vertex{.position = {x, kRidge + 0.12f - z * fall - sag + lift, side * z},
                              .uv0 = {x / 2.2f, t * 1.45f},
                              .colour = shade(lift < 0 ? 0.35f : 0.92f + 0.08f * t)};
        };
        const auto quad = [&](const std::array<io::Vertex, 4>& c) {
            if (side > 0)
                mesh.addQuad(c, thatch);
            else
                mesh.addQuad({c[3], c[2], c[1], c[0]}, thatch);
        };
        for (int j = 0; j < kDown; ++j)
            for (int i = 0; i < kAcross; ++i) {
                quad({corner(i, j + 1, 0), corner(i + 1, j + 1, 0), corner(i + 1, j, 0), corner(i, j, 0)});
                quad({corner(i, j, -kThick), corner(i + 1, j, -kThick), corner(i + 1, j + 1, -kThick),
                      corner(i, j + 1, -kThick)});
            }
        for (int i = 0; i < kAcross; ++i)
            quad({corner(i, kDown, -kThick), corner(i + 1, kDown, -kThick), corner(i + 1, kDown, 0),
                  corner(i, kDown, 0)});
        for (int j = 0; j < kDown; ++j) {
            quad({corner(0, j, -kThick), corner(0, j + 1, -kThick), corner(0, j + 1, 0), corner(0, j, 0)});
            quad({corner(kAcross, j, 0), corner(kAcross, j + 1, 0), corner(kAcross, j + 1, -kThick),
                  corner(kAcross, j, -kThick)});
        }
    }
    smoothNormals(mesh, 40, thatch);
}

void addFrame(Mesh& mesh, int surface)
{
    for (const float x : {-1.0f, 1.0f})
        for (const float z : {-1.0f, 1.0f})
            addBeam(mesh, {.from = {x * kWide, -1.0f, z * kDeep},
                           .to = {x * kWide, kWall + 0.05f, z * kDeep},
                           .width = 0.2f,
                           .height = 0.2f,
                           .up = {0, 0, 1},
                           .board = 7,
                           .surface = surface,
                           .light = 0.7f});
    for (const float z : {-1.0f, 1.0f})
        addBeam(mesh, {.from = {-kWide - 0.3f, kWall, z * kDeep},
                       .to = {kWide + 0.3f, kWall, z * kDeep},
                       .width = 0.16f,
                       .height = 0.16f,
                       .board = 2,
                       .surface = surface,
                       .light = 0.6f});
    for (const float x : {-1.0f, 1.0f})
        addBeam(mesh, {.from = {x * (kWide + 0.05f), kWall, -kDeep},
                       .to = {x * (kWide + 0.05f), kWall, kDeep},
                       .width = 0.16f,
                       .height = 0.14f,
                       .board = 3,
                       .surface = surface,
                       .light = 0.65f});
}

// An opening in the front wall: a dark recess behind a frame, and what closes it.
void addOpening(Mesh& mesh, const Surfaces& s, glm::vec2 low, glm::vec2 high, bool door)
{
    const float z = kDeep + 0.045f;
    const glm::vec3 a{low.x, low.y, z}, b{high.x, low.y, z}, c{high.x, high.y, z}, d{low.x, high.y, z};
    const auto vertex = [](glm::vec3 p) { return io::Vertex{.position = p, .normal = {0, 0, 1}, .uv0 = {p.x, p.y}}; };
    mesh.addQuad({vertex(a), vertex(b), vertex(c), vertex(d)}, s.dark);
    const auto beam = [&](glm::vec3 from, glm::vec3 to, int board) {
        addBeam(mesh, {.from = from,
                       .to = to,
                       .width = 0.11f,
                       .height = 0.1f,
                       .up = {0, 0, 1},
                       .board = board,
                       .surface = s.planks,
                       .light = 0.75f});
    };
    beam(a, d, 4);
    beam(b, c, 5);
    beam(d - glm::vec3{0.1f, 0, 0}, c + glm::vec3{0.1f, 0, 0}, 6);
    if (!door) {
        beam(a - glm::vec3{0.1f, 0, 0}, b + glm::vec3{0.1f, 0, 0}, 8);
        beam((a + b) * 0.5f, (c + d) * 0.5f, 9);
        return;
    }
    const float width = (high.x - low.x) / 4;
    for (int i = 0; i < 4; ++i) { // the door stands ajar
        const glm::vec3 hinge = a + glm::vec3{0, 0.05f, 0.02f};
        const glm::vec3 along = glm::normalize(glm::vec3{0.86f, 0, 0.5f}) * width;
        const glm::vec3 at = hinge + along * (float(i) + 0.5f);
        addBeam(mesh, {.from = at,
                       .to = at + glm::vec3{0, high.y - low.y - 0.08f, 0},
                       .width = width * 0.98f,
                       .height = 0.05f,
                       .up = glm::normalize(glm::cross(along, glm::vec3{0, 1, 0})),
                       .board = i + 20,
                       .surface = s.planks,
                       .light = 0.82f});
    }
}

void addFooting(Mesh& mesh, Random& random)
{
    for (int i = 0; i < 22; ++i) {
        const float t = float(i) / 22 * 4;
        const float s = (t - std::floor(t)) * 2 - 1;
        const glm::vec3 at = t < 1   ? glm::vec3{s * kWide, 0, kDeep}
                             : t < 2 ? glm::vec3{kWide, 0, -s * kDeep}
                             : t < 3 ? glm::vec3{-s * kWide, 0, -kDeep}
                                     : glm::vec3{-kWide, 0, s * kDeep};
        if (t < 1 && s > -0.45f && s < 0.1f) continue; // the way in
        const float size = random.range(0.35f, 0.6f);
        glm::mat4 to{1};
        to[3] = glm::vec4{at + glm::vec3{0, -0.18f, 0}, 1};
        mesh.append(makeStone({.seed = std::uint64_t(i) + 300,
                               .triangles = 24,
                               .size = {size, size * 0.75f, size * 0.8f},
                               .metres = 0.9f}),
                    to);
    }
}

} // namespace

Mesh makeHut()
{
    Random random{17};
    Mesh mesh;
    const Surfaces s{.planks = mesh.surface({.texture = "planks", .roughness = 0.9f}),
                     .thatch = mesh.surface({.texture = "thatch", .roughness = 1}),
                     .dark = mesh.surface({.texture = "charred", .tint = glm::vec3{0.25f}, .roughness = 1}),
                     .stone = 0};
    const auto eaves = [](glm::vec3) { return kWall; };
    const auto gable = [](glm::vec3 p) { return kRidge - 0.12f - std::abs(p.z) * (kRidge - kWall) / kDeep; };
    addBoards(mesh, {kWide, 0, kDeep}, {-kWide, 0, kDeep}, 16, s.planks, eaves, random);
    addBoards(mesh, {-kWide, 0, -kDeep}, {kWide, 0, -kDeep}, 16, s.planks, eaves, random);
    addBoards(mesh, {-kWide, 0, kDeep}, {-kWide, 0, -kDeep}, 13, s.planks, gable, random);
    addBoards(mesh, {kWide, 0, -kDeep}, {kWide, 0, kDeep}, 13, s.planks, gable, random);
    addFrame(mesh, s.planks);
    addOpening(mesh, s, {-0.95f, 0.05f}, {0.05f, 1.85f}, true);
    addOpening(mesh, s, {1.0f, 0.95f}, {1.75f, 1.6f}, false);
    addRoof(mesh, s.thatch);
    addFooting(mesh, random);
    return mesh;
}

} // namespace make
