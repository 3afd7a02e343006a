#include "projects/make/brush.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

constexpr float kPi = 3.14159265f;

float edge(float distance) // coverage of a texel whose centre is `distance` texels inside
{
    return std::clamp(distance + 0.5f, 0.0f, 1.0f);
}

// Light and dark on a leaf: one half turned to the light, the midrib pale, side veins faint.
float leafLight(float t, float across)
{
    const float fold = across < 0 ? 1.10f : 0.90f;
    const float rib = std::exp(-across * across * 260) * 0.28f;
    const float vein = std::pow(std::abs(std::sin((t * 7 - std::abs(across) * 2.2f) * kPi)), 6.0f) * 0.07f;
    return fold * (0.90f + 0.16f * t) + rib - vein - 0.12f * across * across;
}

} // namespace

void lay(Texel& under, glm::vec3 colour, float coverage)
{
    const float alpha = coverage + under.alpha * (1 - coverage);
    if (alpha <= 0) return;
    under.colour = (colour * coverage + under.colour * (under.alpha * (1 - coverage))) / alpha;
    under.alpha = alpha;
}

void paint(Canvas& canvas, const Stroke& stroke)
{
    const glm::vec2 middle = (stroke.from + stroke.to) * 0.5f;
    const glm::vec2 along = stroke.to - stroke.from;
    const float length = std::max(glm::length(along), 1e-3f);
    const float reach = length / 2 + std::max(stroke.widthFrom, stroke.widthTo) + 1;
    canvas.stamp(middle, reach, stroke.tiles, [&](Texel& texel, glm::vec2 offset) {
        const glm::vec2 p = offset + along * 0.5f;
        const float t = std::clamp(glm::dot(p, along) / (length * length), 0.0f, 1.0f);
        const float half = glm::mix(stroke.widthFrom, stroke.widthTo, t) / 2;
        const float distance = glm::length(p - along * t);
        const float coverage = edge(half - distance) * std::min(1.0f, half * 2);
        if (coverage <= 0) return;
        const float across = std::clamp(distance / std::max(half, 0.5f), 0.0f, 1.0f);
        const float light = 1.08f - 0.3f * across * across;
        lay(texel, glm::mix(stroke.colourFrom, stroke.colourTo, t) * light, coverage);
        texel.height += stroke.height * coverage * std::sqrt(1 - 0.9f * across * across);
    });
}

float halfWidth(Leaf kind, float t)
{
    if (t <= 0 || t >= 1) return 0;
    switch (kind) {
    case Leaf::Oak: {
        const float body = 0.34f * std::pow(std::sin(kPi * std::pow(t, 1.35f)), 0.7f);
        return body * (0.80f + 0.20f * std::cos(2 * kPi * (3.6f * t - 0.35f)));
    }
    case Leaf::Birch: {
        const float body = t < 0.28f ? 0.40f * std::sqrt(t / 0.28f) : 0.40f * std::pow((1 - t) / 0.72f, 0.85f);
        return body * (0.94f + 0.06f * std::abs(std::fmod(t * 12, 1.0f) * 2 - 1));
    }
    case Leaf::Beech:
        return 0.31f * std::pow(std::sin(kPi * std::pow(t, 0.9f)), 0.85f) * (1 + 0.03f * std::sin(t * 50));
    case Leaf::Simple:
        break;
    }
    return 0.24f * std::sin(kPi * std::pow(t, 0.8f));
}

void paint(Canvas& canvas, const LeafMark& leaf)
{
    const glm::vec2 along{std::sin(leaf.angle), -std::cos(leaf.angle)};
    const glm::vec2 right{-along.y, along.x};
    const glm::vec2 middle = leaf.base + along * (leaf.length / 2);
    const auto place = [&](glm::vec2 offset) {
        const glm::vec2 p = offset + along * (leaf.length / 2);
        return glm::vec2{glm::dot(p, along) / leaf.length, glm::dot(p, right) / leaf.length / leaf.squash};
    };
    // A soft dark rim on what lies under it tells leaf from leaf at a distance.
    canvas.stamp(middle, leaf.length * 0.62f, leaf.tiles, [&](Texel& texel, glm::vec2 offset) {
        const glm::vec2 p = place(offset - glm::vec2{0.6f, 1.6f} * (leaf.length / 30));
        const float half = halfWidth(leaf.kind, glm::clamp(p.x * 0.9f + 0.05f, 0.02f, 0.98f)) * 1.25f;
        const float inside = (half - std::abs(p.y)) * leaf.length / 4;
        if (p.x > -0.03f && p.x < 1.04f) texel.colour *= 1 - leaf.shade * std::clamp(inside, 0.0f, 1.0f);
    });
    canvas.stamp(middle, leaf.length * 0.6f, leaf.tiles, [&](Texel& texel, glm::vec2 offset) {
        const glm::vec2 p = place(offset);
        const float half = halfWidth(leaf.kind, p.x);
        if (half <= 0) return;
        const float coverage = edge((half - std::abs(p.y)) * leaf.length * leaf.squash);
        if (coverage <= 0) return;
        const float across = p.y / half;
        lay(texel, leaf.colour * leafLight(p.x, across), coverage);
        texel.height += leaf.height * coverage * (1 - 0.6f * across * across);
    });
}

} // namespace make
