#include "projects/make/valley_land.h"

#include "projects/make/noise.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

float smooth(float low, float high, float x)
{
    return glm::smoothstep(low, high, x);
}

// The bed falls so little that one altitude tells it from its banks all the way.
float bedLevel(float z)
{
    return 27.6f - z * 0.0005f;
}

// The valley's own middle: the stream winds about it.
float valleyX(float z)
{
    return 88 * std::sin(z / 236 + 0.5f) + 34 * std::sin(z / 97 + 2.1f) + 0.10f * z - 30;
}

float valleyHalfWidth(glm::vec2 p)
{
    const float east = smooth(-60, 60, p.x - valleyX(p.y));
    const float plain = smooth(40, 560, p.y) * smooth(1080, 640, p.y) *
                        glm::mix(70.0f, 470.0f, east); // the plain lies in the south-east
    return 50 + 24 * noise(glm::vec2{p.y / 190, east * 7}, 5) + plain;
}

// How high the mountains may become: highest in the north, a lower range in the west, hills in the south.
float ambition(glm::vec2 p)
{
    const float north = smooth(250, -800, p.y);
    const float west = smooth(100, -700, p.x);
    const float peak = std::exp(-glm::dot(p - glm::vec2{-190, -880}, p - glm::vec2{-190, -880}) / (330.0f * 330.0f));
    return 95 + 125 * north + 70 * west + 120 * peak;
}

float rawHeight(glm::vec2 p)
{
    const glm::vec2 warp = 90.0f * glm::vec2{fbm(p / 420.0f, 21, {.count = 3}), fbm(p / 420.0f, 22, {.count = 3})};
    const glm::vec2 edge = 46.0f * glm::vec2{fbm(p / 130.0f, 26, {.count = 4}), fbm(p / 130.0f, 27, {.count = 4})};
    const glm::vec2 q = p + edge;
    const float away = std::max(0.0f, std::abs(q.x - valleyX(q.y)) * 0.9f - valleyHalfWidth(q));
    const float rise = 1 - std::exp(-away / 260);
    const float crest = ridged((p + warp) / 520.0f, 23, {.count = 5, .gain = 0.48f});
    const float spur = 0.5f + 0.5f * fbm((p + warp) / 260.0f, 24, {.count = 4});
    const float mountain = ambition(p) * rise * (0.30f + 0.95f * crest * rise + 0.30f * (spur - 0.5f));
    const float fromMiddle = std::abs(p.x - valleyX(p.y));
    const float knolls = 6.5f * (0.25f + fbm(p / 150.0f, 25, {.count = 4})) * smooth(30, 130, fromMiddle);
    const glm::vec2 border = glm::abs(p + warp * 0.9f);
    const float rim =
        (34 + 30 * spur) * smooth(760, 1060, std::max(border.x, border.y)); // hides the world's edge from below
    return 31.4f + fromMiddle * 0.012f + std::max(0.0f, knolls) + mountain + rim * smooth(40, 260, fromMiddle);
}

// How sharply the stream turns, -1..1; positive where it bends towards +x.
float bendAt(float z)
{
    const float turn = (streamX(z + 12) - 2 * streamX(z) + streamX(z - 12)) / 144;
    return std::clamp(turn * 60, -1.0f, 1.0f);
}

// The stream cuts its bed: steep outer banks, gravel bars that slope gently inside the bends. Never does the plain
// sink to the bed's level.
float carved(glm::vec2 p, float height)
{
    const float distance = streamDistance(p);
    if (distance > 90) return std::max(height, 30.7f);
    const float inner = std::max(0.0f, bendAt(p.y) * (p.x > streamX(p.y) ? 1.0f : -1.0f));
    const float half = 5.6f + 2.6f * noise(glm::vec2{p.y / 41, 3}, 31) + 1.1f * noise(p / 9.0f, 35) + 5.0f * inner;
    const float bars = 0.35f * fbm(p / 14.0f, 32, {.count = 3}) + 0.10f * fbm(p / 2.5f, 33, {.count = 2});
    const float bed = bedLevel(p.y) + bars + 0.5f * smooth(0, half, distance) + 0.5f * inner * smooth(2, 12, distance);
    const float floor = std::max(height, 30.2f + 0.5f * smooth(half, half + 30, distance));
    const float bank = 4.5f + 9 * inner + 2.5f * (1 + noise(p / 22.0f, 34));
    return glm::mix(bed, floor, smooth(half, half + bank, distance));
}

// Level ground for the camp and, where the slope begins, for the hut.
void level(io::HeightGrid& land, glm::vec2 middle, float radius, float height)
{
    change(land, [&](glm::vec2 p, float h) {
        const float away = glm::length(p - middle) + 0.25f * radius * noise(p / 18.0f, 41);
        return glm::mix(height + 0.12f * fbm(p / 9.0f, 42, {.count = 2}), h, smooth(radius, radius * 2.6f, away));
    });
}

// Heights of steep, rough ground in steps that no one sees there: the file shrinks by a fifth.
void coarsen(io::HeightGrid& land)
{
    const io::HeightGrid before = land;
    change(land, [&](glm::vec2 p, float h) {
        const float step = 8 * kValleyTop / 65535; // of the file's own, 5 cm
        return slopeAt(before, p) > 22 ? std::round(h / step) * step : h;
    });
}

} // namespace

float streamX(float z)
{
    return valleyX(z) + 20 * std::sin(z / 43 + 1.3f + 0.6f * std::sin(z / 111)) + 7 * std::sin(z / 19.0f);
}

float streamDistance(glm::vec2 p)
{
    // The curve is steep nowhere, so the nearest of a few points up and down it is close enough.
    float nearest = 1e9f;
    for (int i = -5; i <= 4; ++i) {
        const float step = 8;
        const float z0 = p.y + step * float(i), z1 = z0 + step;
        const glm::vec2 a{streamX(z0), z0}, b{streamX(z1), z1};
        const float t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
        nearest = std::min(nearest, glm::length(p - glm::mix(a, b, t)));
    }
    return std::min(nearest, std::abs(p.x - streamX(p.y)));
}

io::HeightGrid makeValleyLand()
{
    io::HeightGrid land = blankHeights(513, 4);
    fill(land, rawHeight);
    rainOn(land, {.drops = 170000, .steps = 48, .seed = 51});
    settle(land, 52, 6);

    land = doubled(land);
    change(land, [](glm::vec2 p, float h) {
        const float rough = smooth(34, 90, h);
        return h +
               rough * (5.5f * fbm(p / 36.0f, 61, {.count = 3}) + 3.0f * (ridged(p / 54.0f, 62, {.count = 3}) - 0.4f));
    });
    rainOn(land, {.drops = 330000, .steps = 42, .seed = 52});
    settle(land, 54, 4);

    land = doubled(land);
    change(land, [](glm::vec2 p, float h) {
        const float rough = smooth(36, 110, h);
        return h + 0.10f * fbm(p / 7.0f, 63, {.count = 3}) + rough * 0.8f * fbm(p / 11.0f, 64, {.count = 3});
    });
    rainOn(land, {.drops = 420000, .steps = 34, .brush = 2, .strength = 0.8f, .seed = 53});
    settle(land, 58, 2);

    level(land, kCamp, 16, 32.1f);
    level(land, kCamp + kHut, 6, heightAt(land, kCamp + kHut));
    change(land, carved);
    change(land, [](glm::vec2, float h) { return std::clamp(h, 0.0f, kValleyTop); });
    coarsen(land);
    return land;
}

} // namespace make
