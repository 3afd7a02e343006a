#include "editor/brush.h"

#include "io/base/contract.h"
#include "io/base/in_parallel.h"
#include "io/base/noise.h"
#include "io/base/random.h"
#include "io/scene/rain.h"
#include "io/scene/settling.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace editor {
namespace {

constexpr int kMostBlur = 24; // texels to a side; wider ones take longer than a frame
constexpr int kOctaves = 5;
constexpr int kRowsWorthAThread = 80; // below that a thread costs what it saves

// The ground under a brush with a margin around it, as it was.
struct Under {
    io::HeightGrid before;
    glm::ivec2 low{0};  // of the inner part, in `before`
    glm::ivec2 size{0}; // of it
};

std::optional<Under> under(const io::HeightMap& map, const glm::dvec2& low, const glm::dvec2& high, int margin, HeightPatch& patch)
{
    const io::Texel first{glm::ceil((low - map.origin) / map.metresPerTexel)}, last{glm::floor((high - map.origin) / map.metresPerTexel)};
    const io::TexelRect inner = common({first, last + io::Texel{1}}, map.texels());
    if (inner.empty()) return std::nullopt;
    const io::TexelRect outer = common({inner.low - io::Texel{margin}, inner.high + io::Texel{margin}}, map.texels());
    patch.at = inner.low;
    patch.heights = map.read(inner);
    return Under{map.read(outer), inner.low - outer.low, inner.high - inner.low};
}

float slopeAt(const io::HeightGrid& heights, int x, int z) // degrees
{
    const auto step = float(2 * heights.metresPerTexel);
    const float dx = (heights.clampedAt(x + 1, z) - heights.clampedAt(x - 1, z)) / step;
    const float dz = (heights.clampedAt(x, z + 1) - heights.clampedAt(x, z - 1)) / step;
    return glm::degrees(std::atan(std::sqrt(dx * dx + dz * dz)));
}

// Where the brush may change the ground, softly at the borders of its ranges.
float allowed(const Brush& brush, const io::HeightGrid& before, int x, int z)
{
    float share = 1;
    if (brush.slope.x > 0 || brush.slope.y < 90) {
        const float slope = slopeAt(before, x, z);
        share *= std::clamp((slope - brush.slope.x) / 4 + 0.5f, 0.0f, 1.0f) * std::clamp((brush.slope.y - slope) / 4 + 0.5f, 0.0f, 1.0f);
        if (brush.slope.x <= 0) share = std::clamp((brush.slope.y - slope) / 4 + 0.5f, 0.0f, 1.0f);
        if (brush.slope.y >= 90) share = std::clamp((slope - brush.slope.x) / 4 + 0.5f, 0.0f, 1.0f);
    }
    const float metres = before.at(x, z);
    return metres < brush.altitude.x || metres > brush.altitude.y ? 0.0f : share;
}

bool masked(const Brush& brush)
{
    return brush.slope.x > 0 || brush.slope.y < 90 || brush.altitude.x > -1e5f || brush.altitude.y < 1e5f;
}

// change(x, z, share): in texels of `before`; share of the dab there. Called by several threads where the dab is wide.
template <class Change> void forTexels(const Under& ground, const Brush& brush, const Dab& dab, HeightPatch& patch, Change&& change)
{
    const bool mask = masked(brush);
    const double texel = ground.before.metresPerTexel;
    io::inParallel(ground.size.y, kRowsWorthAThread, [&](int from, int to) {
        for (int row = from; row < to; ++row)
            for (int column = 0; column < ground.size.x; ++column) {
                const int x = ground.low.x + column, z = ground.low.y + row;
                const glm::dvec2 place = ground.before.origin + glm::dvec2{x, z} * texel;
                float share = fading(brush, float(glm::distance(place, dab.centre) / brush.radius));
                if (share > 0 && mask) share *= allowed(brush, ground.before, x, z);
                if (share > 0) patch.heights.at(column, row) = change(x, z, share);
            }
    });
}

// The mean of the squares around each texel, as sums along rows and then along columns.
std::vector<float> blurred(const io::HeightGrid& heights, int reach)
{
    const glm::ivec2 size = heights.size;
    std::vector<float> rows(heights.metres.size()), result(heights.metres.size());
    const auto pass = [reach](const std::vector<float>& from, std::vector<float>& to, int count, int lines, std::size_t step, std::size_t lineStep) {
        for (int line = 0; line < lines; ++line) {
            const std::size_t first = std::size_t(line) * lineStep;
            double sum = 0;
            int low = 0, high = 0; // the sum is of [low, high)
            for (int i = 0; i < count; ++i) {
                for (; high < std::min(i + reach + 1, count); ++high)
                    sum += double(from[first + std::size_t(high) * step]);
                for (; low < i - reach; ++low)
                    sum -= double(from[first + std::size_t(low) * step]);
                to[first + std::size_t(i) * step] = float(sum / (high - low));
            }
        }
    };
    pass(heights.metres, rows, size.x, size.y, 1, std::size_t(size.x));
    pass(rows, result, size.y, size.x, std::size_t(size.x), 1);
    return result;
}

// Octaves that texels can hold: finer ones than two of them would be chance from texel to texel.
int octavesOn(const Brush& brush, double texel)
{
    return std::clamp(int(std::floor(std::log2(double(brush.scale) / (2 * texel)))) + 1, 1, kOctaves);
}

float noiseAt(const Brush& brush, int octaves, const glm::dvec2& place)
{
    const glm::vec2 p{place / double(brush.scale)};
    const auto seed = std::uint32_t(brush.seed);
    switch (brush.noise) {
    case BrushNoise::Simplex: return io::simplex(p, seed);
    case BrushNoise::Ridged: return io::simplexRidged(p, seed, {.count = octaves}) * 2 - 1;
    default: return io::simplexFbm(p, seed, {.count = octaves});
    }
}

// Rain under the brush, with heights in texels.
io::HeightGrid eroded(io::HeightGrid heights, const Brush& brush, const Dab& dab)
{
    const auto texel = float(heights.metresPerTexel);
    const glm::vec2 centre{(dab.centre - heights.origin) / heights.metresPerTexel};
    const float reach = brush.radius / texel;
    io::Rainfall rain{heights, {.steps = 32, .reach = 2, .unit = texel, .inertia = 0.1f, .capacity = 4.8f, .gravity = 4, .lasting = 0.98f, .seesItself = false, .leavesAll = true}};
    io::Random random{io::hash(int(dab.number), brush.seed, 77u)};
    const int drops = std::clamp(int(reach * reach * 0.17f), 8, 34'000);
    for (int i = 0; i < drops; ++i) {
        const float angle = random.range(0, glm::two_pi<float>()), away = std::sqrt(random.unit()) * reach;
        if (const glm::vec2 at = centre + away * glm::vec2{std::cos(angle), std::sin(angle)}; rain.inside(at)) rain.drop(at);
    }
    return heights;
}

// The longer sides are as long as the brush is wide. Bilinear; 0 beyond its sides.
float stampAt(const Brush& brush, const Dab& dab, const glm::dvec2& place)
{
    const io::HeightGrid& stamp = *brush.stamp;
    const double turn = glm::radians(double(brush.rotation));
    const glm::dvec2 away = (place - dab.centre) / double(brush.radius);
    const glm::dvec2 turned{away.x * std::cos(turn) + away.y * std::sin(turn), away.y * std::cos(turn) - away.x * std::sin(turn)};
    const glm::dvec2 last{stamp.size - 1}, at = (turned * std::max(last.x, last.y) + last) * 0.5;
    if (at.x < 0 || at.y < 0 || at.x > stamp.size.x - 1 || at.y > stamp.size.y - 1) return 0;
    const glm::ivec2 low = glm::min(glm::ivec2{at}, stamp.size - 2);
    const glm::vec2 f{at - glm::dvec2{low}};
    return glm::mix(glm::mix(stamp.at(low.x, low.y), stamp.at(low.x + 1, low.y), f.x),
                    glm::mix(stamp.at(low.x, low.y + 1), stamp.at(low.x + 1, low.y + 1), f.x), f.y);
}

// One that falls between texels would change nothing.
Brush coveringTexels(Brush brush, double metresPerTexel)
{
    brush.radius = std::max(brush.radius, float(metresPerTexel));
    return brush;
}

int marginOf(const Brush& brush, double metresPerTexel)
{
    switch (brush.tool) {
    case BrushTool::Smooth: return 2 * std::clamp(int(brush.radius * 0.08f / float(metresPerTexel)), 1, kMostBlur);
    case BrushTool::Erode: return 6;
    case BrushTool::Slump: return 3;
    default: return 1;
    }
}

} // namespace

float fading(const Brush& brush, float away)
{
    if (away >= 1) return 0;
    const float begin = 1 - std::clamp(brush.falloff, 0.0f, 1.0f);
    if (away <= begin) return 1;
    const float left = (1 - away) / (1 - begin); // 1 where it begins to fade
    switch (brush.curve) {
    case BrushCurve::Linear: return left;
    case BrushCurve::Dome: return std::sqrt(std::max(0.0f, 1 - (1 - left) * (1 - left)));
    case BrushCurve::Point: return left * left;
    default: return left * left * (3 - 2 * left);
    }
}

std::optional<HeightPatch> dabOn(const io::HeightMap& map, const Brush& given, const Dab& dab)
{
    EXPECTS(given.tool != BrushTool::Ramp && shapes(given.tool) && given.radius > 0);
    const Brush brush = coveringTexels(given, map.metresPerTexel);
    HeightPatch patch;
    const auto ground = under(map, dab.centre - double(brush.radius), dab.centre + double(brush.radius), marginOf(brush, map.metresPerTexel), patch);
    if (!ground) return std::nullopt;
    const io::HeightGrid& before = ground->before;
    const auto change = [&](auto&& height) { forTexels(*ground, brush, dab, patch, height); };
    const auto place = [&](int x, int z) { return before.origin + glm::dvec2{x, z} * before.metresPerTexel; };
    const auto towards = [&](const std::vector<float>& aim) {
        change([&](int x, int z, float share) {
            return glm::mix(before.at(x, z), aim[std::size_t(z) * before.size.x + x], std::min(share * dab.amount, 1.0f));
        });
    };
    switch (brush.tool) {
    case BrushTool::Raise: change([&](int x, int z, float share) { return before.at(x, z) + dab.amount * share; }); break;
    case BrushTool::Lower: change([&](int x, int z, float share) { return before.at(x, z) - dab.amount * share; }); break;
    case BrushTool::Flatten:
        change([&](int x, int z, float share) { return glm::mix(before.at(x, z), float(dab.level), std::min(share * dab.amount, 1.0f)); });
        break;
    case BrushTool::Terrace:
        change([&](int x, int z, float share) {
            const float steps = before.at(x, z) / brush.step, base = std::floor(steps);
            const float aim = (base + glm::smoothstep(0.3f, 0.7f, steps - base)) * brush.step;
            return glm::mix(before.at(x, z), aim, std::min(share * dab.amount, 1.0f));
        });
        break;
    case BrushTool::Noise: {
        const int octaves = octavesOn(brush, map.metresPerTexel);
        change([&](int x, int z, float share) { return before.at(x, z) + dab.amount * share * noiseAt(brush, octaves, place(x, z)); });
        break;
    }
    case BrushTool::Stamp:
        if (brush.stamp && brush.stamp->size.x > 1 && brush.stamp->size.y > 1)
            change([&](int x, int z, float share) { return before.at(x, z) + dab.amount * share * stampAt(brush, dab, place(x, z)); });
        break;
    case BrushTool::Smooth: {
        io::HeightGrid once = before;
        once.metres = blurred(before, marginOf(brush, map.metresPerTexel) / 2);
        towards(blurred(once, marginOf(brush, map.metresPerTexel) / 2));
        break;
    }
    case BrushTool::Erode: towards(eroded(before, brush, dab).metres); break;
    case BrushTool::Slump: {
        io::HeightGrid settled = before;
        io::settle(settled, brush.talus, 4);
        towards(settled.metres);
        break;
    }
    default: break;
    }
    return patch;
}

// A texel knows two layers: a third takes the place of the weaker one.
io::Cover painted(io::Cover cover, BrushTool tool, int layer, int replaced, float share)
{
    if (tool == BrushTool::Hole) {
        cover.hole = share > 0;
        return cover;
    }
    if (tool == BrushTool::Erase) {
        cover.painted *= 1 - share;
        return cover.painted < 1.0f / 255 ? io::Cover{.hole = cover.hole} : cover;
    }
    if (tool == BrushTool::Replace) {
        if (share < 0.5f || cover.painted == 0) return cover;
        if (cover.base == replaced) cover.base = layer;
        if (cover.over == replaced) cover.over = layer;
        return cover;
    }
    if (cover.painted == 0) return {layer, layer, 0, share, cover.hole};
    const float before = cover.painted;
    cover.painted += (1 - cover.painted) * share;
    // What is painted anew is all of this layer; what was painted already gets its share of it.
    const float gained = (share * before + cover.painted - before) / cover.painted;
    if (cover.base == layer && cover.over == layer) {
        cover.share = 0;
    } else if (cover.over == layer) {
        cover.share += (1 - cover.share) * gained;
    } else if (cover.base == layer) {
        cover.share -= cover.share * gained;
    } else {
        if (cover.share > 0.5f) cover.base = cover.over;
        cover.over = layer;
        cover.share = gained;
    }
    return cover;
}

std::optional<CoverPatch> paintOn(const io::HeightMap& map, const io::CoverMap& cover, const Brush& given, const Dab& dab, bool everywhere)
{
    const Brush brush = coveringTexels(given, map.metresPerTexel);
    EXPECTS(paints(brush.tool) && cover.size() == map.size);
    HeightPatch where;
    const glm::dvec2 reach{everywhere ? 1e9 : double(brush.radius)};
    const auto ground = under(map, dab.centre - reach, dab.centre + reach, 1, where);
    if (!ground) return std::nullopt;
    CoverPatch patch{where.at, ground->size, cover.read(where.rect())};
    const bool mask = masked(brush);
    for (int row = 0; row < patch.size.y; ++row)
        for (int column = 0; column < patch.size.x; ++column) {
            const int x = ground->low.x + column, z = ground->low.y + row;
            const glm::dvec2 place = ground->before.origin + glm::dvec2{x, z} * ground->before.metresPerTexel;
            const bool cuts = brush.tool == BrushTool::Hole;
            float share = everywhere ? 1.0f : cuts ? float(glm::distance(place, dab.centre) < double(brush.radius)) : fading(brush, float(glm::distance(place, dab.centre) / brush.radius));
            if (share > 0 && mask) share *= allowed(brush, ground->before, x, z);
            if (share <= 0) continue;
            std::uint32_t& texel = patch.texels[std::size_t(row) * std::size_t(patch.size.x) + std::size_t(column)];
            texel = io::packed(painted(io::unpacked(texel), brush.tool, brush.layer, brush.replaced, std::min(share * dab.amount, 1.0f)));
        }
    return patch;
}

std::optional<HeightPatch> rampOn(const io::HeightMap& map, const Brush& given, const glm::dvec3& from, const glm::dvec3& to, float amount)
{
    const Brush brush = coveringTexels(given, map.metresPerTexel);
    HeightPatch patch;
    const glm::dvec2 a{from.x, from.z}, b{to.x, to.z}, along = b - a;
    const auto ground = under(map, glm::min(a, b) - double(brush.radius), glm::max(a, b) + double(brush.radius), 1, patch);
    const double length = glm::dot(along, along);
    if (!ground || length < 1e-6) return std::nullopt;
    for (int row = 0; row < ground->size.y; ++row)
        for (int column = 0; column < ground->size.x; ++column) {
            const int x = ground->low.x + column, z = ground->low.y + row;
            const glm::dvec2 place = ground->before.origin + glm::dvec2{x, z} * ground->before.metresPerTexel;
            const double t = std::clamp(glm::dot(place - a, along) / length, 0.0, 1.0);
            float share = fading(brush, float(glm::distance(place, a + along * t) / brush.radius)) * amount;
            if (share > 0 && masked(brush)) share *= allowed(brush, ground->before, x, z);
            if (share > 0) patch.heights.at(column, row) = glm::mix(ground->before.at(x, z), float(glm::mix(from.y, to.y, t)), std::min(share, 1.0f));
        }
    return patch;
}

std::optional<HeightPatch> patchOf(const io::HeightMap& map, const Brush& brush, const glm::dvec2& from, const glm::dvec2& to, float amount)
{
    const glm::dvec2 last = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel;
    const auto heightAt = [&](const glm::dvec2& at) { // of the map's edge, beyond it
        const glm::dvec2 on = glm::clamp(at, map.origin, last);
        return map.height(on.x, on.y);
    };
    const auto start = heightAt(from), end = heightAt(to);
    if (brush.tool != BrushTool::Ramp)
        return dabOn(map, brush, {.centre = from, .amount = amount, .level = brush.levelGiven ? double(brush.level) : start.value_or(0)});
    if (!start || !end) return std::nullopt;
    return rampOn(map, brush, {from.x, *start, from.y}, {to.x, *end, to.y}, std::min(amount, 1.0f));
}

} // namespace editor
