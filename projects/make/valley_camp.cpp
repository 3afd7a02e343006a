// The camp in its clearing: tent and logs about the fire, an axe in its chopping block, a hut behind a fence.
#include "projects/make/valley.h"
#include "projects/make/valley_land.h"

#include <cmath>

namespace make {
namespace {

constexpr float kHutYaw = 52; // its door looks at the fire

struct Piece {
    std::string_view what;
    glm::vec2 offset; // from the fire
    float yaw;
    float scale = 1;
    const char* name = "";
    float radius = 1.2f; // ground it takes
    float lift = 0;
};

const Piece kPieces[] = {
    {"campfire", {0, 0}, 20, 1, "Campfire", 2.2f},
    {"tent", {-5.2f, 2.0f}, 100, 1.1f, "Tent", 3.2f},
    {"log", {0.4f, 3.0f}, 8, 1.1f, "Log seat"},
    {"log", {2.9f, -0.6f}, 98, 1, "Log seat"},
    {"log", {-0.6f, -3.0f}, -14, 1.05f, "Log seat"},
    {"stump", {4.6f, -3.4f}, 30, 0.9f, "Chopping block"},
    {"axe", {4.6f, -3.4f}, 200, 1.25f, "Axe", 0.1f, 0.435f},
    {"log", {5.9f, -4.6f}, 40, 0.5f, "Firewood", 0.5f},
    {"log", {6.3f, -3.7f}, 120, 0.45f, "Firewood", 0.5f},
    {"log", {5.1f, -5.3f}, 75, 0.5f, "Firewood", 0.5f},
    {"hut", kHut, kHutYaw, 1, "Hut", 5.2f},
    {"log", kHut + glm::vec2{4.6f, -1.2f}, 50, 1, "Firewood", 0.8f},
    {"log", kHut + glm::vec2{5.0f, -1.0f}, 53, 0.95f, "Firewood", 0.8f},
};

// Fences run in straight lengths of 2.5 m from corner to corner; a gap is the way in.
void addFences(Stage& stage, io::ObjectId group, Random& random)
{
    const float turn = glm::radians(kHutYaw);
    const glm::vec2 right{std::cos(turn), -std::sin(turn)}, front{std::sin(turn), std::cos(turn)};
    const auto corner = [&](float x, float z) { return kCamp + kHut + right * x + front * z; };
    const glm::vec2 line[] = {corner(-8, -1),     corner(-8, 8.5f), corner(-1.2f, 8.5f), corner(1.3f, 8.5f),
                              corner(6.5f, 8.5f), corner(8, 3),     corner(8, -3)};
    for (std::size_t i = 0; i + 1 < std::size(line); ++i) {
        if (i == 2) continue; // the way in
        const glm::vec2 along = line[i + 1] - line[i];
        const int pieces = std::max(1, int(std::round(glm::length(along) / 2.55f)));
        for (int k = 0; k < pieces; ++k) {
            const glm::vec2 at = line[i] + along * ((float(k) + 0.5f) / float(pieces));
            const float yaw = glm::degrees(std::atan2(-along.y, along.x)) + (random.chance(0.5f) ? 180.0f : 0.0f);
            stage.put({.what = "fence", .at = at, .yaw = yaw, .scale = 1, .parent = group}, random);
            stage.take(at, 1.3f);
        }
    }
}

} // namespace

io::ObjectId setCamp(Stage& stage)
{
    stage.edit("log", [](io::Template& log) { log.body = {.dynamic = true, .mass = 130, .friction = 0.7f}; });
    Random random{700};
    const io::ObjectId camp = stage.addGroup("Camp", kCamp);
    for (const Piece& piece : kPieces) {
        const glm::vec2 at = kCamp + piece.offset;
        stage.put({.what = piece.what,
                   .at = at,
                   .yaw = piece.yaw,
                   .scale = piece.scale,
                   .name = piece.name,
                   .lift = piece.lift,
                   .parent = camp},
                  random);
        stage.take(at, piece.radius);
    }
    addFences(stage, camp, random);
    stage.put({.what = "spawn_point", .at = kCamp + glm::vec2{12, 9}, .yaw = 120, .scale = 1, .name = "Start"}, random);
    stage.put({.what = "point_of_interest", .at = {-330, -120}, .yaw = 0, .scale = 1, .name = "View over the valley"},
              random);
    return camp;
}

void smokeOverFire(Stage& stage, io::ObjectId camp)
{
    Random random{701};
    stage.put({.what = "campfire_smoke", .at = kCamp, .yaw = 0, .scale = 1, .name = "Smoke of the campfire", .parent = camp}, random);
}

} // namespace make
