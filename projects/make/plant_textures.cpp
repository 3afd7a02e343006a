#include "projects/make/brush.h"
#include "projects/make/random.h"
#include "projects/make/textures.h"

#include "io/base/contract.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

// A tuft of blades that rise from the bottom edge; for grass, and with wide blades for reeds.
Canvas paintTuft(int size, std::uint32_t seed, bool dry)
{
    Canvas canvas{size, {.colour = dry ? rgb(0x7a6a3a) : rgb(0x4a5a26), .alpha = 0}};
    Random random{seed};
    for (int i = 0; i < 230; ++i) {
        const float depth = float(i) / 230;
        glm::vec2 at{size * (0.5f + 0.34f * random.bell()), float(size) + 4};
        float heading = (at.x / size - 0.5f) * 1.2f + random.bell() * 0.35f;
        const float bend = (heading > 0 ? 1.0f : -1.0f) * random.range(0.02f, 0.13f);
        const float length = size * random.range(0.45f, 0.98f);
        const glm::vec3 green = glm::mix(rgb(0x36441b), rgb(0x6d7a36), depth);
        const glm::vec3 straw = glm::mix(rgb(0x5c5030), rgb(0x9c8c58), depth);
        const glm::vec3 colour = glm::mix(green, straw, dry ? random.range(0.5f, 1.0f) : random.range(0.0f, 0.22f));
        const int steps = 9;
        for (int s = 0; s < steps; ++s) {
            const float t = float(s) / steps;
            const glm::vec2 next = at + glm::vec2{std::sin(heading), -std::cos(heading)} * (length / steps);
            if (next.x < 6 || next.x > size - 6) break;
            const float width = 15 * (1 - t * 0.85f);
            paint(canvas, Stroke{.from = at,
                                 .to = next,
                                 .widthFrom = width,
                                 .widthTo = width * 0.86f,
                                 .colourFrom = colour * (0.55f + 0.6f * t),
                                 .colourTo = colour * (0.62f + 0.6f * t)});
            at = next;
            heading += bend * (1 + t);
        }
    }
    return canvas;
}

// One fern frond, stalk at the bottom, leaflets in pairs that shorten towards the tip.
Canvas paintFern(int size, std::uint32_t seed)
{
    Canvas canvas{size, {.colour = rgb(0x3c5222), .alpha = 0}};
    Random random{seed};
    for (float t = 0.06f; t < 0.98f; t += 0.040f)
        for (const float side : {-1.0f, 1.0f}) {
            const glm::vec2 from{size * (0.5f + 0.02f * std::sin(t * 5)), size * (1 - t * 0.97f)};
            const float length = size * 0.46f * std::pow(1 - t, 0.75f) * std::min(1.0f, 0.3f + t * 3.5f);
            const float angle = side * (1.25f - 0.35f * t + random.bell() * 0.06f);
            const glm::vec2 out{std::sin(angle), -std::cos(angle)};
            for (float d = 0.03f; d < 1; d += 0.055f)
                for (const float half : {-1.0f, 1.0f}) {
                    LeafMark leaf{.kind = Leaf::Simple, .base = from + out * (length * d)};
                    leaf.angle = angle + half * 0.95f;
                    leaf.length = std::max(20.0f, 62 * (1 - d * 0.55f) * (1 - t * 0.45f));
                    leaf.colour = glm::mix(rgb(0x35501d), rgb(0x7c9440), 0.35f * t + 0.4f * d + 0.25f * random.unit());
                    leaf.shade = 0.2f;
                    paint(canvas, leaf);
                }
        }
    paint(canvas, Stroke{.from = {size * 0.5f, size},
                         .to = {size * 0.5f, size * 0.06f},
                         .widthFrom = 13,
                         .widthTo = 4,
                         .colourFrom = rgb(0x5a4a28),
                         .colourTo = rgb(0x6d7a38)});
    return canvas;
}

// Wild flowers: thin stalks with small leaves, heads of five petals.
Canvas paintFlowers(int size, std::uint32_t seed)
{
    Canvas canvas{size, {.colour = rgb(0x4c5e28), .alpha = 0}};
    Random random{seed};
    for (int i = 0; i < 44; ++i) {
        const glm::vec2 root{size * (0.5f + 0.4f * random.bell()), float(size)};
        const glm::vec2 head =
            root + glm::vec2{(root.x - size * 0.5f) * random.range(0.1f, 0.5f), -size * random.range(0.35f, 0.90f)};
        const glm::vec3 green = glm::mix(rgb(0x3d5020), rgb(0x76863c), random.unit());
        paint(
            canvas,
            Stroke{
                .from = root, .to = head, .widthFrom = 9, .widthTo = 5, .colourFrom = green * 0.7f, .colourTo = green});
        for (int l = 0; l < 4; ++l)
            paint(canvas, LeafMark{.kind = Leaf::Simple,
                                   .base = glm::mix(root, head, random.range(0.05f, 0.7f)),
                                   .angle = random.range(-1.1f, 1.1f),
                                   .length = random.range(50.0f, 110.0f),
                                   .squash = 0.7f,
                                   .colour = green * random.range(0.8f, 1.1f)});
        const int kind = random.below(3);
        const glm::vec3 petal = kind == 0 ? rgb(0xe8e2d0) : kind == 1 ? rgb(0xd9b640) : rgb(0x8a78b8);
        for (int p = 0; p < 8; ++p)
            paint(canvas, LeafMark{.kind = Leaf::Simple,
                                   .base = head,
                                   .angle = float(p) * 0.785f + random.bell() * 0.15f,
                                   .length = random.range(28.0f, 40.0f),
                                   .squash = 1.2f,
                                   .colour = petal * random.range(0.85f, 1.05f),
                                   .shade = 0.1f});
        paint(canvas, Stroke{.from = head,
                             .to = head + glm::vec2{0, 1},
                             .widthFrom = 20,
                             .widthTo = 20,
                             .colourFrom = rgb(0xa87820),
                             .colourTo = rgb(0xa87820)});
    }
    return canvas;
}

} // namespace

Canvas paintPlant(std::string_view name, int size)
{
    const std::uint32_t seed = hash(name);
    if (name == "leaf_fern") return paintFern(size, seed);
    if (name == "leaf_flowers") return paintFlowers(size, seed);
    EXPECTS(name == "leaf_grass" || name == "leaf_grass_dry");
    return paintTuft(size, seed, name == "leaf_grass_dry");
}

} // namespace make
