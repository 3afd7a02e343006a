#include "projects/make/brush.h"
#include "projects/make/noise.h"
#include "projects/make/random.h"
#include "projects/make/textures.h"

#include "io/base/contract.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr int kSide = 1024;

float smooth(float low, float high, float x)
{
    return glm::smoothstep(low, high, x);
}

float patches(glm::vec2 p, std::uint32_t seed, int count) // tiling, -1..1
{
    return fbm(p * float(count), seed, {.count = 4, .gain = 0.55f, .period = {count, count}});
}

Canvas paintSoil(std::uint32_t seed, glm::vec3 dark, glm::vec3 light)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float clod = fbm(p * 24.0f, seed, {.count = 5, .gain = 0.62f, .period = {24, 24}});
        texel.colour = glm::mix(dark, light, std::clamp(0.5f + 0.6f * clod, 0.0f, 1.0f));
        texel.height = 5 * clod;
    });
    return canvas;
}

struct Blades {
    int count = 30000;
    float shortest = 14, longest = 34; // texels
    glm::vec3 dark, light, straw;
    float strawShare = 0.12f;
};

// Blades of grass as they lie when seen from above, with their own lights and darks; they lean in swirls.
void growBlades(Canvas& canvas, const Blades& blades, std::uint32_t seed)
{
    Random random{seed};
    for (int i = 0; i < blades.count; ++i) {
        const float depth = float(i) / float(blades.count);
        const glm::vec2 at{random.range(0, kSide), random.range(0, kSide)};
        const glm::vec2 place = at / float(kSide);
        const float swirl = 6.0f * patches(place, seed + 1, 5);
        const float angle = swirl + random.bell() * 1.7f;
        const float length = random.range(blades.shortest, blades.longest);
        const float patch = patches(place, seed + 2, 6);
        const float tone = std::clamp(0.2f + 0.55f * depth + 0.30f * random.bell() + 0.22f * patch, 0.0f, 1.0f);
        glm::vec3 colour = glm::mix(blades.dark, blades.light, tone);
        const float dry = blades.strawShare * (1 + 1.6f * patches(place, seed + 3, 4));
        if (random.chance(dry)) colour = glm::mix(colour, blades.straw, random.range(0.35f, 0.9f));
        const glm::vec2 to = at + glm::vec2{std::cos(angle), std::sin(angle)} * length;
        paint(canvas, Stroke{.from = at,
                             .to = to,
                             .widthFrom = random.range(2.2f, 3.6f),
                             .widthTo = 1.0f,
                             .colourFrom = colour * 0.72f,
                             .colourTo = colour * 1.08f,
                             .height = 0.9f,
                             .tiles = true});
    }
}

void scatterLeaves(Canvas& canvas, int count, std::uint32_t seed)
{
    Random random{seed};
    const glm::vec3 tones[] = {rgb(0x4a3a26), rgb(0x6a4e2e), rgb(0x7d5c34),
                               rgb(0x57462e), rgb(0x8a6c42), rgb(0x3c3020)};
    for (int i = 0; i < count; ++i) {
        const float depth = float(i) / float(count);
        const glm::vec3 tone = glm::mix(tones[random.below(6)], tones[random.below(6)], random.unit());
        paint(canvas, LeafMark{.kind = Leaf(random.below(4)),
                               .base = {random.range(0, kSide), random.range(0, kSide)},
                               .angle = random.range(0, 6.28f),
                               .length = random.range(22, 46),
                               .squash = random.range(0.45f, 1.0f),
                               .colour = tone * (0.62f + 0.45f * depth),
                               .shade = 0.3f,
                               .tiles = true,
                               .height = 2.2f});
    }
}

void scatterTwigs(Canvas& canvas, int count, std::uint32_t seed)
{
    Random random{seed};
    for (int i = 0; i < count; ++i) {
        const glm::vec2 at{random.range(0, kSide), random.range(0, kSide)};
        const float angle = random.range(0, 6.28f);
        const float length = random.range(20, 110);
        const glm::vec3 colour = glm::mix(rgb(0x42362a), rgb(0x80705c), random.unit());
        paint(canvas, Stroke{.from = at,
                             .to = at + glm::vec2{std::cos(angle), std::sin(angle)} * length,
                             .widthFrom = random.range(2, 5),
                             .widthTo = 1.5f,
                             .colourFrom = colour,
                             .colourTo = colour * 0.9f,
                             .height = 3,
                             .tiles = true});
    }
}

void growMoss(Canvas& canvas, std::uint32_t seed)
{
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float fine = fbm(p * 96.0f, seed, {.count = 3, .gain = 0.6f, .period = {96, 96}});
        const float moss = smooth(-0.10f, 0.26f, patches(p, seed + 1, 5) + 0.3f * fine);
        const glm::vec3 green = glm::mix(rgb(0x323c1a), rgb(0x66722e), std::clamp(0.5f + 0.7f * fine, 0.0f, 1.0f));
        texel.colour = glm::mix(texel.colour, green, moss * 0.85f);
        texel.height += moss * (2 + 2.5f * fine);
    });
}

// A stone lying on the ground: a flattened dome with a bumpy outline.
void layStone(Canvas& canvas, glm::vec2 centre, float radius, glm::vec3 colour, Random& random)
{
    const float turn = random.range(0, 6.28f);
    const float stretch = random.range(0.62f, 1.0f);
    const auto bump = std::uint32_t(random.next());
    const auto outline = [&](glm::vec2 offset) {
        const glm::vec2 q{offset.x * std::cos(turn) + offset.y * std::sin(turn),
                          (offset.y * std::cos(turn) - offset.x * std::sin(turn)) / stretch};
        return glm::length(q) / radius + 0.26f * noise(offset * (1.1f / radius) + 0.5f, bump);
    };
    canvas.stamp(centre + radius * 0.12f, radius * 1.3f, true, [&](Texel& texel, glm::vec2 offset) {
        texel.colour *= 1 - 0.42f * smooth(1.15f, 0.85f, outline(offset)); // contact shadow
    });
    canvas.stamp(centre, radius * 1.25f, true, [&](Texel& texel, glm::vec2 offset) {
        const float r = outline(offset);
        const float coverage = std::clamp((1 - r) * radius * 0.8f, 0.0f, 1.0f);
        if (coverage <= 0) return;
        const float grain = fbm(offset * 0.09f, bump + 1, {.count = 4, .gain = 0.6f});
        const float dome = std::sqrt(std::max(0.0f, 1 - r * r));
        lay(texel, colour * (0.70f + 0.36f * dome + 0.22f * grain), coverage);
        texel.height = glm::mix(texel.height, radius * 0.55f * dome + grain, coverage);
    });
}

glm::vec3 stoneColour(Random& random)
{
    const glm::vec3 tones[] = {rgb(0x807a70), rgb(0x9a9284), rgb(0x6b6862),
                               rgb(0x8d7f6a), rgb(0xa59c90), rgb(0x746a60)};
    return glm::mix(tones[random.below(6)], tones[random.below(6)], random.unit()) * random.range(0.85f, 1.08f);
}

void scatterStones(Canvas& canvas, int count, float smallest, float largest, std::uint32_t seed)
{
    Random random{seed};
    for (int i = 0; i < count; ++i) { // from small to large, so that large ones lie on top
        const float t = float(i) / float(count);
        const float radius = glm::mix(smallest, largest, t * t * t);
        layStone(canvas, {random.range(0, kSide), random.range(0, kSide)}, radius, stoneColour(random), random);
    }
}

// Weathered rock: tilted beds, broken edges where ridged noise crosses them, lichen in the hollows.
Canvas paintRockFace(std::uint32_t seed)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const glm::vec2 warp{patches(p, seed + 1, 4), patches(p, seed + 2, 4)};
        const glm::vec2 bed{p.x * 3 + warp.x, p.y * 9 + warp.y * 1.6f};
        const float strata = fbm(bed, seed + 3, {.count = 6, .gain = 0.62f, .period = {3, 9}});
        const float broken =
            ridged(p * glm::vec2{4, 6} + warp * 0.7f, seed + 4, {.count = 6, .gain = 0.6f, .period = {4, 6}});
        const Cells block = cells(p * glm::vec2{5, 8} + warp * 1.5f, seed + 5, {5, 8});
        const float facet = (unitOf(block.id) - 0.5f) * smooth(0.0f, 0.25f, block.second - block.nearest);
        const float fine = fbm(p * 48.0f, seed + 6, {.count = 4, .gain = 0.68f, .period = {48, 48}});
        const float crack = smooth(0.62f, 0.80f, broken + 0.10f * fine);
        const float tone = std::clamp(0.50f + 0.50f * strata + 0.25f * facet + 0.34f * fine, 0.0f, 1.0f);
        texel.colour = glm::mix(rgb(0x4f4a43), rgb(0x9c9486), tone);
        texel.colour += glm::vec3{0.035f, 0.012f, -0.02f} * patches(p, seed + 7, 4);
        const float lichen = smooth(0.16f, 0.42f, patches(p, seed + 8, 9) + 0.3f * fine);
        texel.colour = glm::mix(texel.colour, rgb(0x8c8a6c), lichen * 0.35f);
        texel.colour *= 1 - 0.45f * crack;
        texel.height = 16 * strata + 8 * facet + 4 * fine - 8 * crack + 6 * broken;
    });
    return canvas;
}

} // namespace

Canvas paintGround(std::string_view name)
{
    const std::uint32_t seed = hash(name);
    if (name == "ground_grass") {
        Canvas canvas = paintSoil(seed, rgb(0x241f12), rgb(0x3f3620));
        growBlades(canvas,
                   {.count = 44000,
                    .dark = rgb(0x2c3a1a),
                    .light = rgb(0x78863f),
                    .straw = rgb(0xa39458),
                    .strawShare = 0.20f},
                   seed + 1);
        return canvas;
    }
    if (name == "ground_dry") {
        Canvas canvas = paintSoil(seed, rgb(0x3a3020), rgb(0x66583c));
        scatterStones(canvas, 260, 4, 15, seed + 2);
        growBlades(canvas,
                   {.count = 26000,
                    .shortest = 12,
                    .longest = 30,
                    .dark = rgb(0x464522),
                    .light = rgb(0x8f8a4c),
                    .straw = rgb(0xb8a468),
                    .strawShare = 0.42f},
                   seed + 1);
        return canvas;
    }
    if (name == "ground_forest") {
        Canvas canvas = paintSoil(seed, rgb(0x231a10), rgb(0x44341f));
        scatterLeaves(canvas, 4200, seed + 1);
        growMoss(canvas, seed + 2);
        growBlades(canvas,
                   {.count = 12500,
                    .shortest = 10,
                    .longest = 26,
                    .dark = rgb(0x2c3616),
                    .light = rgb(0x67743a),
                    .straw = rgb(0x8a7a48)},
                   seed + 3);
        scatterLeaves(canvas, 420, seed + 4);
        scatterTwigs(canvas, 130, seed + 5);
        return canvas;
    }
    if (name == "ground_pebbles") {
        Canvas canvas = paintSoil(seed, rgb(0x5c5140), rgb(0x96886e));
        scatterStones(canvas, 5200, 3, 44, seed + 1);
        return canvas;
    }
    if (name == "ground_scree") {
        Canvas canvas = paintSoil(seed, rgb(0x4a4233), rgb(0x7d7058));
        growBlades(canvas,
                   {.count = 5000,
                    .shortest = 10,
                    .longest = 24,
                    .dark = rgb(0x3c3f1e),
                    .light = rgb(0x7d7c44),
                    .straw = rgb(0xa8965c),
                    .strawShare = 0.35f},
                   seed + 2);
        scatterStones(canvas, 1900, 3, 34, seed + 1);
        return canvas;
    }
    EXPECTS(name == "ground_rock");
    return paintRockFace(seed);
}

} // namespace make
