#include "projects/make/brush.h"
#include "projects/make/noise.h"
#include "projects/make/random.h"
#include "projects/make/textures.h"

#include "io/base/contract.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr int kSide = 512;

float smooth(float low, float high, float x)
{
    return glm::smoothstep(low, high, x);
}

// Plates between furrows: cells stretched along the trunk, their borders bent by noise.
struct Plates {
    glm::ivec2 count{8, 3};
    float warp = 0.5f;    // cells
    float furrow = 0.30f; // width of a furrow, cells
    glm::vec3 deep, low, high;
    float depth = 9;     // texels
    float grain = 0.35f; // fine vertical streaks
};

Canvas paintPlates(const Plates& plates, std::uint32_t seed)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const glm::vec2 grid = p * glm::vec2{plates.count};
        const glm::vec2 bend{fbm(p * 8.0f, seed + 1, {.count = 4, .period = {8, 8}}),
                             fbm(p * 8.0f, seed + 2, {.count = 3, .period = {8, 8}})};
        const Cells cell = cells(grid + bend * plates.warp, seed + 3, plates.count);
        const float ridge = smooth(0.02f, plates.furrow, cell.second - cell.nearest);
        const float streak = fbm(p * glm::vec2{64, 8}, seed + 4, {.count = 4, .gain = 0.65f, .period = {64, 8}});
        const float blotch = fbm(p * 4.0f, seed + 5, {.count = 4, .period = {4, 4}});
        const float rough = fbm(p * 32.0f, seed + 6, {.count = 4, .gain = 0.6f, .period = {32, 32}});
        const float tone =
            std::clamp(0.5f + 0.5f * blotch + plates.grain * streak + 0.35f * rough + 0.25f * (unitOf(cell.id) - 0.5f),
                       0.0f, 1.0f);
        texel.colour = glm::mix(plates.deep, glm::mix(plates.low, plates.high, tone), 0.12f + 0.88f * ridge);
        texel.height = plates.depth * (ridge + 0.25f * streak * ridge + 0.16f * rough + 0.12f * unitOf(cell.id));
    });
    return canvas;
}

void growMoss(Canvas& canvas, std::uint32_t seed, glm::vec3 colour, float share)
{
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float patch = fbm(p * 4.0f, seed, {.count = 5, .gain = 0.6f, .period = {4, 4}});
        const float fine = fbm(p * 64.0f, seed + 9, {.count = 2, .period = {64, 64}});
        const float moss = smooth(0.45f - share, 0.75f - share, patch + fine * 0.25f);
        texel.colour = glm::mix(texel.colour, colour * (0.9f + 0.5f * fine), moss * 0.75f);
    });
}

Canvas paintBirch(std::uint32_t seed)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float sheet = fbm(p * glm::vec2{4, 16}, seed, {.count = 4, .period = {4, 16}});
        const float fine = fbm(p * glm::vec2{16, 64}, seed + 1, {.count = 3, .period = {16, 64}});
        const float warm = fbm(p * 4.0f, seed + 2, {.count = 3, .period = {4, 4}});
        texel.colour = rgb(0xbdb6a8) + glm::vec3{0.10f, 0.09f, 0.085f} * sheet + 0.05f * fine +
                       glm::vec3{0.05f, 0.01f, -0.04f} * warm;
        const glm::vec2 grid = p * glm::vec2{3, 5};
        const glm::vec2 bend{0.3f * sheet, 0.35f * fbm(p * 16.0f, seed + 4, {.count = 3, .period = {16, 16}})};
        const Cells scar = cells(grid + bend, seed + 3, {3, 5});
        const float shape = std::abs(scar.offset.x) * 0.75f + std::abs(scar.offset.y) * 2.1f;
        const float dark = unitOf(hash(scar.id)) < 0.5f ? smooth(0.42f, 0.22f, shape + 0.12f * fine) : 0.0f;
        texel.colour = glm::mix(texel.colour, rgb(0x26221f) * (1 + 0.8f * fine), dark * 0.93f);
        texel.height = 1.5f * sheet + 1.2f * fine + 2.5f * dark * (0.5f + fine);
    });
    Random random{seed};
    for (int i = 0; i < 210; ++i) { // lenticels
        const glm::vec2 at{random.range(0, kSide), random.range(0, kSide)};
        const float length = random.range(6, 44);
        const glm::vec3 colour = glm::mix(rgb(0x4a4038), rgb(0x8a7a68), random.unit());
        paint(canvas, Stroke{.from = at,
                             .to = at + glm::vec2{length, random.bell()},
                             .widthFrom = random.range(1.2f, 3),
                             .widthTo = 1,
                             .colourFrom = colour,
                             .colourTo = colour,
                             .height = -1.2f,
                             .tiles = true});
    }
    return canvas;
}

Canvas paintBeech(std::uint32_t seed)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float blotch = fbm(p * 4.0f, seed, {.count = 5, .gain = 0.55f, .period = {4, 4}});
        const float wrinkle = ridged(p * glm::vec2{3, 24} + 0.4f * blotch, seed + 1, {.count = 3, .period = {3, 24}});
        const float rough = fbm(p * 32.0f, seed + 2, {.count = 4, .gain = 0.65f, .period = {32, 32}});
        const float lichen =
            smooth(0.16f, 0.34f, fbm(p * 6.0f, seed + 3, {.count = 5, .gain = 0.6f, .period = {6, 6}}));
        texel.colour =
            glm::mix(rgb(0x454139), rgb(0x7b7467), std::clamp(0.5f + 0.7f * blotch + 0.3f * rough, 0.0f, 1.0f));
        texel.colour = glm::mix(texel.colour, rgb(0x96988a), lichen * 0.6f);
        texel.colour *= 1 - 0.22f * smooth(0.55f, 0.9f, wrinkle);
        texel.height = 2.0f * blotch - 2.2f * smooth(0.5f, 0.9f, wrinkle) + 0.9f * rough + 0.8f * lichen;
    });
    growMoss(canvas, seed + 7, rgb(0x5d6438), 0.10f);
    return canvas;
}

Canvas paintDeadWood(std::uint32_t seed)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float bend = 0.05f * fbm(p * 4.0f, seed, {.count = 3, .period = {4, 4}});
        const glm::vec2 q{p.x + bend, p.y};
        const float grain = fbm(q * glm::vec2{48, 4}, seed + 1, {.count = 5, .gain = 0.65f, .period = {48, 4}});
        const float crack = ridged(q * glm::vec2{12, 2}, seed + 2, {.count = 3, .period = {12, 2}});
        const float blotch = fbm(p * 4.0f, seed + 3, {.count = 4, .period = {4, 4}});
        const float split = smooth(0.62f, 0.86f, crack);
        texel.colour =
            glm::mix(rgb(0x6d6459), rgb(0xb0a796), std::clamp(0.5f + 0.55f * grain + 0.45f * blotch, 0.0f, 1.0f));
        texel.colour = glm::mix(texel.colour, rgb(0x2c261f), split * 0.85f);
        texel.height = 2.5f * grain - 7 * split;
    });
    return canvas;
}

} // namespace

Canvas paintBark(std::string_view name)
{
    const std::uint32_t seed = hash(name);
    if (name == "bark_birch") return paintBirch(seed);
    if (name == "bark_beech") return paintBeech(seed);
    if (name == "bark_dead") return paintDeadWood(seed);
    if (name == "bark_fir")
        return paintPlates({.count = {9, 7},
                            .warp = 0.8f,
                            .furrow = 0.34f,
                            .deep = rgb(0x2a1f19),
                            .low = rgb(0x5a4638),
                            .high = rgb(0x917d6c),
                            .depth = 7,
                            .grain = 0.2f},
                           seed);
    EXPECTS(name == "bark_oak" || name == "bark_oak_mossy");
    Canvas canvas = paintPlates({.count = {9, 2},
                                 .warp = 0.55f,
                                 .furrow = 0.40f,
                                 .deep = rgb(0x231d18),
                                 .low = rgb(0x55493c),
                                 .high = rgb(0x94846f),
                                 .depth = 11},
                                seed);
    growMoss(canvas, seed + 11, rgb(0x586030), name == "bark_oak" ? 0.12f : 0.45f);
    return canvas;
}

} // namespace make
