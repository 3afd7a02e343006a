#include "projects/make/brush.h"
#include "projects/make/noise.h"
#include "projects/make/random.h"
#include "projects/make/textures.h"

#include "io/base/contract.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr int kSide = 1024; // painted at twice the size it is kept in

struct Palette {
    glm::vec3 dark, middle, light;
    glm::vec3 odd; // a few leaves
    float oddShare = 0.06f;

    glm::vec3 pick(Random& random, float depth) const // depth 0 back … 1 front
    {
        const float t = std::clamp(depth + random.bell() * 0.35f, 0.0f, 1.0f);
        glm::vec3 colour = t < 0.5f ? glm::mix(dark, middle, t * 2) : glm::mix(middle, light, t * 2 - 1);
        if (random.chance(oddShare)) colour = glm::mix(colour, odd, random.range(0.4f, 0.9f));
        return colour * (0.93f + 0.14f * random.unit());
    }
};

struct Spray {
    Leaf leaf = Leaf::Oak;
    Palette palette;
    glm::vec3 twig{0.30f, 0.24f, 0.17f};
    float leafLength = 118; // texels of the painting
    float spacing = 46;     // texels between leaves along a twig
    float droop = 0;        // how much side twigs bend back to the stalk's end
    int passes = 3;         // back to front
};

struct Twig {
    glm::vec2 from{0}, to{0};
    float width = 4;
};

// An outline with bays: a smooth one would show where a card ends.
bool inside(glm::vec2 p, std::uint32_t seed)
{
    const float margin = 12;
    const glm::vec2 centre{kSide / 2.0f, kSide * 0.48f};
    const glm::vec2 d = (p - centre) / glm::vec2{kSide / 2.0f - margin, kSide * 0.48f - margin};
    const float radius = glm::length(d);
    const glm::vec2 towards = d / std::max(radius, 1e-3f);
    const float bays = 0.5f + 0.6f * noise(towards * 2.4f + 9.0f, seed) + 0.5f * noise(towards * 5.0f, seed + 1);
    const bool stalk = p.y > centre.y && std::abs(p.x - centre.x) < 40 && p.y < kSide;
    const bool gap = noise(p / 105.0f, seed + 2) > 0.50f; // the sky shows through
    return (radius < 0.52f + 0.48f * std::clamp(bays, 0.0f, 1.0f) && !gap) || stalk;
}

// One stem from the middle of the bottom edge, and side twigs to both sides that fill a round outline.
std::vector<Twig> twigsOf(const Spray& spray, Random& random)
{
    std::vector<Twig> twigs;
    glm::vec2 at{kSide / 2.0f, float(kSide)};
    float heading = random.range(-0.06f, 0.06f);
    for (int step = 0; step < 11; ++step) {
        heading = heading * 0.7f + random.bell() * 0.16f;
        const glm::vec2 next = at + glm::vec2{std::sin(heading), -std::cos(heading)} * (kSide * 0.084f);
        twigs.push_back({at, next, 13.0f - step});
        at = next;
        if (step < 1) continue;
        for (const float side : {-1.0f, 1.0f}) {
            const float angle = heading + side * random.range(0.75f, 1.25f);
            const float height = step / 11.0f;
            const float reach = kSide * 0.54f * std::sin(3.14159f * std::clamp(height * 0.84f + 0.15f, 0.0f, 1.0f));
            const float length = reach * random.range(0.72f, 1.0f);
            const glm::vec2 out{std::sin(angle), -std::cos(angle) + spray.droop * random.range(0.5f, 1.0f)};
            const glm::vec2 knee = at + out * length * 0.5f;
            twigs.push_back({at, knee, 6});
            const float bend = angle - side * random.range(0.0f, 0.4f);
            twigs.push_back({knee, knee + glm::vec2{std::sin(bend), -std::cos(bend) + spray.droop} * length * 0.5f, 4});
        }
    }
    return twigs;
}

void leavesAlong(Canvas& canvas, const Spray& spray, const Twig& twig, float depth, std::uint32_t outline,
                 Random& random)
{
    const glm::vec2 along = twig.to - twig.from;
    const float length = glm::length(along);
    const float heading = std::atan2(along.x, -along.y);
    int side = random.chance(0.5f) ? 1 : -1;
    for (float d = random.range(0, spray.spacing); d < length; d += spray.spacing * random.range(0.7f, 1.3f)) {
        side = -side;
        LeafMark leaf{.kind = spray.leaf, .base = twig.from + along * (d / length)};
        leaf.angle = heading + float(side) * random.range(0.35f, 1.25f) + random.bell() * 0.3f;
        leaf.length = spray.leafLength * random.range(0.68f, 1.08f);
        leaf.squash = random.range(0.55f, 1.0f);
        leaf.colour = spray.palette.pick(random, depth);
        leaf.shade = 0.30f;
        const glm::vec2 tip = leaf.base + glm::vec2{std::sin(leaf.angle), -std::cos(leaf.angle)} * leaf.length;
        if (inside(tip, outline) && inside(leaf.base, outline)) paint(canvas, leaf);
    }
}

Canvas paintSpray(const Spray& spray, std::uint32_t seed)
{
    Canvas canvas{kSide, {.colour = spray.palette.dark, .alpha = 0}};
    Random random{seed};
    const std::vector<Twig> twigs = twigsOf(spray, random);
    for (int pass = 0; pass < spray.passes; ++pass) {
        const float depth = float(pass) / float(spray.passes - 1);
        std::vector<Twig> order = twigs;
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[std::size_t(random.below(int(i)))]);
        for (const Twig& twig : order) {
            if (pass == 1 && inside(twig.to, seed)) {
                paint(canvas, Stroke{.from = twig.from,
                                     .to = twig.to,
                                     .widthFrom = twig.width,
                                     .widthTo = twig.width * 0.7f,
                                     .colourFrom = spray.twig,
                                     .colourTo = spray.twig});
            }
            leavesAlong(canvas, spray, twig, depth, seed, random);
        }
    }
    return canvas;
}

void needles(Canvas& canvas, const Twig& twig, float length, float tint, Random& random)
{
    const glm::vec2 along = twig.to - twig.from;
    const float reach = glm::length(along);
    const float heading = std::atan2(along.x, -along.y);
    const glm::vec3 dark = glm::mix(rgb(0x16240f), rgb(0x22331a), tint);
    const glm::vec3 bright = glm::mix(rgb(0x3c5428), rgb(0x6d8440), tint);
    for (float d = 0; d < reach; d += 2.6f) {
        const float t = d / reach;
        for (const float side : {-1.0f, 1.0f}) {
            const float angle = heading + side * random.range(0.5f, 1.15f);
            const glm::vec2 base = twig.from + along * t;
            const glm::vec2 tip =
                base + glm::vec2{std::sin(angle), -std::cos(angle)} * length * random.range(0.7f, 1.1f);
            const glm::vec3 colour =
                glm::mix(dark, bright, std::clamp(0.35f + 0.5f * t + random.bell() * 0.4f, 0.0f, 1.0f));
            paint(canvas, Stroke{.from = base,
                                 .to = tip,
                                 .widthFrom = 4.4f,
                                 .widthTo = 2.0f,
                                 .colourFrom = colour * 0.75f,
                                 .colourTo = colour});
        }
    }
}

// A fir's branch seen from above: a triangle of side twigs, each a comb of needles.
Canvas paintFir(std::uint32_t seed)
{
    Canvas canvas{kSide, {.colour = rgb(0x22331a), .alpha = 0}};
    Random random{seed};
    const glm::vec2 root{kSide / 2.0f, float(kSide)};
    const glm::vec2 top{kSide / 2.0f, 24};
    for (int pass = 0; pass < 2; ++pass) {
        for (float t = 0.04f; t < 0.97f; t += 0.066f)
            for (const float side : {-1.0f, 1.0f}) {
                const float width = 0.47f * std::pow(1 - t, 0.62f) * std::min(1.0f, 0.55f + t * 2.2f);
                const float length = kSide * width * random.range(0.84f, 1.0f);
                const float angle = side * random.range(0.78f, 1.02f);
                const glm::vec2 from = glm::mix(root, top, t + random.bell() * 0.01f);
                const glm::vec2 to = from + glm::vec2{std::sin(angle), -std::cos(angle)} * length;
                const Twig twig{from, to, 5};
                paint(canvas, Stroke{.from = from,
                                     .to = to,
                                     .widthFrom = 7,
                                     .widthTo = 3,
                                     .colourFrom = rgb(0x3a2c1c),
                                     .colourTo = rgb(0x35401f)});
                needles(canvas, twig, 25, pass == 0 ? 0.1f : 0.8f, random);
            }
        paint(canvas, Stroke{.from = root,
                             .to = top,
                             .widthFrom = 14,
                             .widthTo = 5,
                             .colourFrom = rgb(0x3b2d1e),
                             .colourTo = rgb(0x3a3a20)});
        needles(canvas, {root, top, 8}, 34, 0.7f, random);
    }
    return canvas;
}

Spray sprayOf(std::string_view name)
{
    const Palette oak{rgb(0x222e13), rgb(0x4c5c28), rgb(0x848e4c), rgb(0xa08c48), 0.09f};
    const Palette birch{rgb(0x2f3a18), rgb(0x667434), rgb(0x9ea45c), rgb(0xc0aa50), 0.14f};
    const Palette beech{rgb(0x1f2d14), rgb(0x475a2a), rgb(0x7c8a4c), rgb(0xa4984c), 0.08f};
    const Palette russet{rgb(0x46301a), rgb(0x7d5a34), rgb(0xa68a52), rgb(0x747638), 0.22f};
    const Palette gold{rgb(0x6a5418), rgb(0xa88c3a), rgb(0xccb468), rgb(0x8c9440), 0.10f};
    const Palette copper{rgb(0x4c2c14), rgb(0x8c6234), rgb(0xb89656), rgb(0x94904a), 0.28f};
    const Palette shrub{rgb(0x26341a), rgb(0x4a5c2c), rgb(0x76864a), rgb(0x8a5a40)};
    if (name == "leaf_oak") return {.leaf = Leaf::Oak, .palette = oak, .leafLength = 68, .spacing = 31};
    if (name == "leaf_birch")
        return {.leaf = Leaf::Birch, .palette = birch, .leafLength = 52, .spacing = 29, .droop = 0.35f};
    if (name == "leaf_beech") return {.leaf = Leaf::Beech, .palette = beech, .leafLength = 60, .spacing = 30};
    if (name == "leaf_oak_autumn") return {.leaf = Leaf::Oak, .palette = russet, .leafLength = 68, .spacing = 33};
    if (name == "leaf_birch_autumn")
        return {.leaf = Leaf::Birch, .palette = gold, .leafLength = 52, .spacing = 30, .droop = 0.35f};
    if (name == "leaf_beech_autumn") return {.leaf = Leaf::Beech, .palette = copper, .leafLength = 60, .spacing = 31};
    EXPECTS(name == "leaf_bush");
    return {.leaf = Leaf::Beech, .palette = shrub, .leafLength = 52, .spacing = 31};
}

Canvas paintLarge(std::string_view name)
{
    const std::uint32_t seed = hash(name);
    if (name == "leaf_fir") return paintFir(seed);
    if (name == "leaf_grass" || name == "leaf_grass_dry" || name == "leaf_fern" || name == "leaf_flowers")
        return paintPlant(name, kSide);
    return paintSpray(sprayOf(name), seed);
}

} // namespace

Canvas paintLeafCard(std::string_view name)
{
    Canvas canvas = halved(paintLarge(name));
    bleedColour(canvas);
    return canvas;
}

} // namespace make
