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

Canvas paintRock(std::uint32_t seed, float mossShare)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float large = fbm(p * 3.0f, seed, {.count = 5, .gain = 0.55f, .period = {3, 3}});
        const glm::vec2 warp{large, fbm(p * 4.0f, seed + 1, {.count = 4, .period = {4, 4}})};
        const float fine = fbm(p * 32.0f, seed + 2, {.count = 4, .gain = 0.68f, .period = {32, 32}});
        const Cells chip = cells(p * 9.0f + warp * 1.4f, seed + 3, {9, 9});
        const float crack = smooth(0.07f, 0.0f,
                                   ridged(p * 3.0f + warp * 0.3f, seed + 4, {.count = 2, .period = {3, 3}}) < 0.78f
                                       ? 1.0f
                                       : chip.second - chip.nearest);
        const float speckle = smooth(0.35f, 0.6f, fine) * 0.5f;
        const float tone =
            std::clamp(0.48f + 0.55f * large + 0.28f * fine + 0.16f * (unitOf(chip.id) - 0.5f), 0.0f, 1.0f);
        texel.colour = glm::mix(rgb(0x57534d), rgb(0xa39c90), tone) + speckle * 0.12f;
        texel.colour += glm::vec3{0.04f, 0.012f, -0.025f} * warp.y;
        texel.colour *= 1 - 0.5f * crack;
        const float lichen = smooth(0.2f, 0.42f, fbm(p * 7.0f, seed + 5, {.count = 5, .gain = 0.6f, .period = {7, 7}}));
        texel.colour = glm::mix(texel.colour, unitOf(chip.id) < 0.3f ? rgb(0xa8904c) : rgb(0xb4b4a2), lichen * 0.42f);
        const float moss = smooth(0.35f - mossShare, 0.6f - mossShare, large + 0.3f * fine);
        const glm::vec3 green = glm::mix(rgb(0x363f20), rgb(0x6c7440), std::clamp(0.5f + 0.8f * fine, 0.0f, 1.0f));
        texel.colour = glm::mix(texel.colour, green, mossShare > 0 ? moss * 0.9f : 0.0f);
        texel.height = 9 * large + 3.2f * fine + 2 * unitOf(chip.id) - 5 * crack;
    });
    return canvas;
}

Canvas paintRings(std::uint32_t seed)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const glm::vec2 d = p - glm::vec2{0.49f, 0.52f};
        const float bend = 0.035f * fbm(p * 5.0f, seed, {.count = 3});
        const float radius = glm::length(d) + bend;
        const float angle = std::atan2(d.y, d.x);
        const float ring = 0.5f + 0.5f * std::sin(radius * 190 + 3 * noise(glm::vec2{radius * 20, 0}, seed + 1));
        const float split = smooth(0.975f, 0.995f, std::cos(angle * 2.5f + 30 * bend)) * smooth(0.03f, 0.3f, radius);
        const float fine = fbm(p * 60.0f, seed + 2, {.count = 3, .gain = 0.6f});
        texel.colour = glm::mix(rgb(0x9a7a50), rgb(0xcaac7c), 0.35f + 0.45f * ring + 0.25f * fine);
        texel.colour *= 1 - 0.25f * smooth(0.2f, 0.5f, radius) - 0.5f * split;
        texel.colour = glm::mix(texel.colour, rgb(0x6d6658), smooth(-0.1f, 0.5f, fbm(p * 4.0f, seed + 3)) * 0.5f);
        if (radius > 0.465f) texel.colour = rgb(0x3c3026) * (1 + 0.4f * fine);
        texel.height = 1.2f * ring + fine - 4 * split;
    });
    return canvas;
}

// Boards side by side, their grain along the picture's height.
Canvas paintPlanks(std::uint32_t seed)
{
    constexpr int kBoards = 4;
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const int board = int(p.x * kBoards);
        const float across = p.x * kBoards - float(board);
        const std::uint32_t own = hash(board, 0, seed);
        const glm::vec2 q{p.x + 0.012f * noise(p * 6.0f, own, {6, 6}), p.y + unitOf(own)};
        const float grain = fbm(q * glm::vec2{72, 4}, own, {.count = 4, .gain = 0.65f, .period = {72, 4}});
        const Cells knot = cells(glm::vec2{across * 1.0f, q.y * 3}, own + 1, {0, 3});
        const float eye = smooth(0.16f, 0.05f, knot.nearest) * (unitOf(knot.id) < 0.4f ? 1.0f : 0.0f);
        const float stain = fbm(p * 4.0f, seed + 5, {.count = 4, .period = {4, 4}});
        const float gap = smooth(0.045f, 0.015f, std::min(across, 1 - across));
        const float tone =
            std::clamp(0.45f + 0.5f * grain + 0.35f * stain + 0.4f * (unitOf(hash(own)) - 0.5f), 0.0f, 1.0f);
        texel.colour = glm::mix(rgb(0x53432f), rgb(0xa18a68), tone);
        texel.colour = glm::mix(texel.colour, rgb(0x8c877c), 0.35f * smooth(-0.2f, 0.5f, stain)); // weathered grey
        texel.colour *= (1 - 0.45f * eye) * (1 - 0.85f * gap);
        texel.height = 1.6f * grain - 9 * gap + 1.5f * unitOf(own);
    });
    return canvas;
}

// Courses of straw that hang down, each over the next one below.
Canvas paintThatch(std::uint32_t seed)
{
    Canvas canvas{kSide, {.colour = rgb(0x3a2d18)}};
    Random random{seed};
    constexpr int kCourses = 4;
    for (int course = kCourses - 1; course >= 0; --course)
        for (int i = 0; i < 2600; ++i) {
            const float top = float(course) * kSide / kCourses + random.range(-46, 30);
            const glm::vec2 from{random.range(0, kSide), top};
            const float length = kSide / kCourses * random.range(0.75f, 1.28f);
            const glm::vec2 to = from + glm::vec2{random.bell() * 14, length};
            const float age = fbm(from / 128.0f, seed + 1, {.period = {4, 4}});
            glm::vec3 colour = glm::mix(rgb(0x6d5a34), rgb(0xc4aa6c),
                                        std::clamp(0.45f + 0.35f * random.bell() + 0.6f * age, 0.0f, 1.0f));
            if (random.chance(0.12f)) colour = glm::mix(colour, rgb(0x6b685c), 0.7f);
            paint(canvas, Stroke{.from = from,
                                 .to = to,
                                 .widthFrom = random.range(2, 3.4f),
                                 .widthTo = 1.6f,
                                 .colourFrom = colour * 0.55f,
                                 .colourTo = colour,
                                 .height = 0.8f,
                                 .tiles = true});
        }
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float fall = p.y * kCourses - std::floor(p.y * kCourses);
        texel.colour *= 0.86f + 0.16f * fall;
        texel.height = texel.height * 0.25f + 8 * fall;
    });
    return canvas;
}

Canvas paintCloth(std::uint32_t seed)
{
    Canvas canvas{kSide, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float stain = fbm(p * 3.0f, seed, {.count = 5, .gain = 0.55f, .period = {3, 3}});
        const float weave = std::sin(p.x * kSide * 0.785f) * std::sin(p.y * kSide * 0.785f);
        const float crease = fbm(p * glm::vec2{5, 5}, seed + 1, {.count = 4, .period = {5, 5}});
        texel.colour =
            glm::mix(rgb(0x8a7a58), rgb(0xcfc2a0), std::clamp(0.55f + 0.45f * stain + 0.06f * weave, 0.0f, 1.0f));
        texel.colour = glm::mix(texel.colour, rgb(0x6d6244), smooth(0.6f, 1.0f, p.y + 0.2f * stain) * 0.55f);
        texel.height = 0.35f * weave + 6 * crease;
    });
    return canvas;
}

Canvas paintIron(std::uint32_t seed)
{
    Canvas canvas{kSide / 2, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float rust = smooth(0.05f, 0.4f, fbm(p * 4.0f, seed, {.count = 5, .gain = 0.6f, .period = {4, 4}}));
        const float fine = fbm(p * 32.0f, seed + 1, {.count = 3, .period = {32, 32}});
        const float scratch = fbm(p * glm::vec2{64, 6}, seed + 2, {.count = 2, .period = {64, 6}});
        texel.colour = glm::mix(rgb(0x77787a) * (1 + 0.18f * scratch), rgb(0x6a4630) * (1 + 0.5f * fine), rust * 0.7f);
        texel.height = fine + rust;
    });
    return canvas;
}

Canvas paintAsh(std::uint32_t seed)
{
    Canvas canvas{kSide / 2, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const float flake = fbm(p * 10.0f, seed, {.count = 5, .gain = 0.65f, .period = {10, 10}});
        const Cells lump = cells(p * 16.0f, seed + 1, {16, 16});
        const float coal = smooth(0.42f, 0.2f, lump.nearest) * (unitOf(lump.id) < 0.45f ? 1.0f : 0.0f);
        texel.colour = glm::mix(rgb(0x3c3936), rgb(0x9d9892), std::clamp(0.45f + 0.8f * flake, 0.0f, 1.0f));
        texel.colour = glm::mix(texel.colour, rgb(0x161413), coal * 0.9f);
        texel.height = 3 * flake + 4 * coal;
    });
    return canvas;
}

Canvas paintCharred(std::uint32_t seed)
{
    Canvas canvas{kSide / 2, {}};
    canvas.each([&](Texel& texel, glm::vec2 p) {
        const Cells block =
            cells(p * glm::vec2{8, 6} + 0.3f * fbm(p * 8.0f, seed, {.period = {8, 8}}), seed + 1, {8, 6});
        const float gap = smooth(0.14f, 0.02f, block.second - block.nearest);
        const float fine = fbm(p * 32.0f, seed + 2, {.count = 3, .period = {32, 32}});
        texel.colour = glm::mix(rgb(0x1d1a18), rgb(0x474240),
                                std::clamp(0.35f + 0.6f * fine + 0.4f * (unitOf(block.id) - 0.5f), 0.0f, 1.0f));
        texel.colour = glm::mix(texel.colour, rgb(0x8a857e), gap * 0.5f);
        texel.height = 4 - 5 * gap + fine;
    });
    return canvas;
}

} // namespace

Canvas paintMaterial(std::string_view name)
{
    const std::uint32_t seed = hash(name);
    if (name == "rock") return paintRock(seed, 0);
    if (name == "rock_mossy") return paintRock(seed, 0.35f);
    if (name == "wood_rings") return paintRings(seed);
    if (name == "planks") return paintPlanks(seed);
    if (name == "thatch") return paintThatch(seed);
    if (name == "cloth") return paintCloth(seed);
    if (name == "iron") return paintIron(seed);
    if (name == "charred") return paintCharred(seed);
    EXPECTS(name == "ash");
    return paintAsh(seed);
}

} // namespace make
