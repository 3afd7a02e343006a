#include "editor/ground_making.h"

#include "editor/river_erosion.h"
#include "io/base/noise.h"
#include "io/base/random.h"
#include "io/scene/field_words.h"
#include "io/scene/resampling.h"
#include "io/scene/settling.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr int kFirstCells = 64;    // of the coarsest level, along the longer side; each next one has twice as many
constexpr int kMargin = 16;        // cells around a level, so that no edge of the map is one where all water leaves
constexpr int kMostErosion = 1400; // cells; beyond, ground gets finer without new rivers
constexpr int kRiverSteps[] = {40, 24, 14, 6, 3}; // of each level, with half of all erosion
constexpr float kCutting = 0.4f;   // K dt of one step
constexpr float kUplift = 0.2f;    // of one step, share of the heights times kCutting: more of it makes steeper land
constexpr float kHillside = 0.04f; // length of a hillside without a brook, share of the map
constexpr float kBend = 1.5f;      // texels, by which valleys bend between two levels
constexpr float kRock = 0.08f;     // size of harder and softer rock, share of the map
constexpr float kLowland = 0.06f;  // share of the heights that lies below the land

enum Salt : std::uint32_t { Continents = 11, Ridges = 23, WarpX = 37, WarpZ = 41, Detail = 53, Rock = 59, Ways = 67 };

constexpr int kMostOctaves = 10;

// Octaves of noise down to a wavelength of two texels.
int octavesTo(float metresPerTexel, float scale)
{
    return std::clamp(int(std::floor(std::log2(scale / (2 * metresPerTexel)))) + 1, 1, kMostOctaves);
}

// The rough shape: 0 at the sea's bottom, 1 at the highest crests.
class Shape {
public:
    explicit Shape(const GroundRecipe& recipe) : m_recipe{recipe}, m_seed{io::hash(std::uint32_t(recipe.seed))} {}

    // The height of the coast, so that the recipe's share of the map is land.
    void findCoast(const io::HeightGrid& level)
    {
        std::vector<float> all;
        for (int z = 0; z < level.size.y; z += 2)
            for (int x = 0; x < level.size.x; x += 2)
                all.push_back(continent(bent(placeOf(level, x, z)), level));
        std::ranges::sort(all);
        const float spread = std::max(all.back() - all.front(), 1e-3f);
        m_coast = all[std::size_t(float(all.size() - 1) * (1 - m_recipe.land))];
        if (m_recipe.land >= 1) m_coast -= 0.5f * spread; // finer octaves make no pond where all rivers would end
        m_top = std::max(all.back() - m_coast, 0.15f * spread);
        m_deep = std::max(m_coast - all.front(), 0.4f * spread);
    }

    float at(const io::HeightGrid& level, int x, int z) const
    {
        const glm::vec2 place = bent(placeOf(level, x, z));
        const float inland = continent(place, level) - m_coast;
        if (inland < 0) return kLowland * std::max(0.0f, 1 + inland / m_deep);
        const float high = std::min(1.0f, inland / m_top);
        const float crest = io::simplexRidged(place / m_recipe.ridgeScale, m_seed + Ridges,
                                              {.count = octavesTo(float(level.metresPerTexel), m_recipe.ridgeScale)});
        const float hills = 0.45f * high * (2 - high), mountains = glm::smoothstep(0.0f, 0.55f, high) * crest;
        return kLowland + (1 - kLowland) * glm::mix(hills, 0.35f * hills + 0.85f * mountains, m_recipe.ridges);
    }

    static glm::vec2 placeOf(const io::HeightGrid& level, int x, int z) { return glm::vec2{level.origin + glm::dvec2{x, z} * level.metresPerTexel}; }

private:
    // Moved aside by noise (Quilez 2002, "Domain warping").
    glm::vec2 bent(const glm::vec2& place) const
    {
        if (m_recipe.warp <= 0) return place;
        const glm::vec2 p = place / m_recipe.continents;
        return place + m_recipe.warp * 0.2f * m_recipe.continents *
                           glm::vec2{io::simplexFbm(p, m_seed + WarpX, {.count = 2, .gain = 0.35f}), io::simplexFbm(p, m_seed + WarpZ, {.count = 2, .gain = 0.35f})};
    }
    float continent(const glm::vec2& place, const io::HeightGrid& level) const
    {
        const int octaves = octavesTo(float(level.metresPerTexel), m_recipe.continents);
        const float gain = m_recipe.roughness, share = (1 - std::pow(gain, float(octaves))) / (1 - std::pow(gain, float(kMostOctaves)));
        return share * io::simplexFbm(place / m_recipe.continents, m_seed + Continents, {.count = octaves, .gain = gain}); // fewer octaves, the same coast
    }

    const GroundRecipe& m_recipe;
    std::uint32_t m_seed;
    float m_coast = 0, m_top = 1, m_deep = 1;
};

// A landscape on its way from coarse to fine.
class Making {
public:
    Making(const GroundRecipe& recipe, const io::Progress& progress) : m_recipe{recipe}, m_progress{progress}, m_shape{recipe} {}

    io::Result<io::HeightGrid> run()
    {
        const glm::dvec2 extent = glm::dvec2{m_recipe.width - 1, m_recipe.depth - 1} * m_recipe.metresPerTexel;
        const double longer = std::max(extent.x, extent.y);
        m_extent = longer;
        const int cells = std::max(m_recipe.width, m_recipe.depth) - 1;
        int levels = 1;
        while (kFirstCells << (levels - 1) < cells)
            ++levels;
        m_shape.findCoast(blank(longer / kFirstCells, extent, 0)); // the same whatever the texels
        for (int i = 0; i < levels; ++i) {
            const bool last = i + 1 == levels;
            m_done = std::pow(0.25f, float(levels - i));
            m_share = std::pow(0.25f, float(levels - i - 1)) - m_done;
            const double metres = last ? m_recipe.metresPerTexel : longer / double(kFirstCells << i);
            io::HeightGrid level = blank(metres, extent, longer / metres + 2 * kMargin < kMostErosion ? kMargin : 0);
            if (!refine(level, i)) return io::Error{{}, "making the ground was cancelled"};
        }
        return finished(extent);
    }

private:
    io::HeightGrid blank(double metresPerTexel, const glm::dvec2& extent, int margin) const
    {
        const glm::ivec2 size = glm::ivec2{glm::round(extent / metresPerTexel)} + 1 + 2 * margin;
        io::HeightGrid level{.size = size, .metresPerTexel = metresPerTexel, .origin = -extent / 2.0 - double(margin) * metresPerTexel};
        level.metres.resize(std::size_t(size.x) * std::size_t(size.y));
        return level;
    }
    float range() const { return m_recipe.highest - m_recipe.lowest; }

    // The ground so far with the texels of `level`, the shape's finer forms, and rivers that cut on.
    bool refine(io::HeightGrid& level, int number)
    {
        m_rise.resize(level.metres.size());
        std::vector<float> softness(m_rise.size());
        std::vector<char> sea(m_rise.size());
        const std::uint32_t seed = io::hash(std::uint32_t(m_recipe.seed)) + Rock;
        const int octaves = octavesTo(float(level.metresPerTexel), kRock * float(m_extent));
        for (int z = 0; z < level.size.y; ++z) {
            if (!say(0.4f * float(z) / float(level.size.y))) return false;
            for (int x = 0; x < level.size.x; ++x) {
                const std::size_t i = std::size_t(z) * std::size_t(level.size.x) + std::size_t(x);
                m_rise[i] = m_shape.at(level, x, z) - kLowland;
                sea[i] = m_rise[i] < 0;
                softness[i] = std::exp2(1.3f * io::simplexFbm(Shape::placeOf(level, x, z) / (kRock * float(m_extent)), seed, {.count = octaves, .gain = 0.6f}));
            }
        }
        if (number > 0) {
            level = io::resampled(m_ground, level.size, level.metresPerTexel, level.origin);
            if (!roughen(level, number)) return false;
        }
        for (std::size_t i = 0; i < m_rise.size(); ++i) // above the sea, whose bottom comes at the end
            level.metres[i] = sea[i] ? 0 : number == 0 ? m_rise[i] * range() : std::max(0.0f, level.metres[i]);
        if (level.size.x <= kMostErosion && level.size.y <= kMostErosion && m_recipe.erosion > 0 && !erode(level, number, softness, sea)) return false;
        m_ground = std::move(level);
        return true;
    }

    // What the level before could not hold: bends of valleys, which there ran along the texels, and one more octave, stronger where
    // it is steep, as plains are smooth.
    bool roughen(io::HeightGrid& level, int number) const
    {
        const io::HeightGrid before = level;
        const auto wave = float(4 * level.metresPerTexel);
        const std::uint32_t seed = io::hash(std::uint32_t(m_recipe.seed)) + Detail + std::uint32_t(number) * 7u;
        const float strength = 0.16f * (m_recipe.roughness / 0.5f) * (m_recipe.roughness / 0.5f);
        for (int z = 0; z < level.size.y; ++z) {
            if (!say(0.4f)) return false;
            for (int x = 0; x < level.size.x; ++x) {
                const glm::vec2 place = Shape::placeOf(level, x, z) / wave, bend = place * 0.6f;
                const glm::vec2 moved = kBend * glm::vec2{io::simplex(bend, seed + 1), io::simplex(bend, seed + 2)};
                const float dx = before.clampedAt(x + 1, z) - before.clampedAt(x - 1, z), dz = before.clampedAt(x, z + 1) - before.clampedAt(x, z - 1);
                const float slope = std::sqrt(dx * dx + dz * dz) / float(2 * level.metresPerTexel);
                level.at(x, z) = between(before, glm::vec2{x, z} + moved) + strength * wave * std::min(slope, 1.0f) * io::simplex(place, seed);
            }
        }
        return true;
    }

    static float between(const io::HeightGrid& level, const glm::vec2& texel) // bilinear
    {
        const glm::vec2 p = glm::clamp(texel, glm::vec2{0}, glm::vec2{level.size} - 1.001f);
        const int x = int(p.x), z = int(p.y);
        const float u = p.x - float(x), v = p.y - float(z);
        return glm::mix(glm::mix(level.at(x, z), level.at(x + 1, z), u), glm::mix(level.at(x, z + 1), level.at(x + 1, z + 1), u), v);
    }

    bool erode(io::HeightGrid& level, int number, const std::vector<float>& softness, const std::vector<char>& sea)
    {
        RiverErosion rivers{level};
        const int steps = std::max(1, int(std::lround(2 * m_recipe.erosion * float(kRiverSteps[std::min(number, int(std::size(kRiverSteps)) - 1)]))));
        std::vector<float> uplift = m_rise;
        for (float& rise : uplift)
            rise = kUplift * kCutting * range() * std::max(0.0f, rise);
        const auto hillside = float(kHillside * m_extent);
        for (int step = 0; step < steps; ++step) {
            if (!say(0.4f + 0.6f * float(step) / float(steps))) return false;
            rivers.step({.cutting = kCutting, .hillside = hillside * hillside, .talus = m_recipe.talus, .seed = io::hash(std::uint32_t(m_recipe.seed)) + Ways}, uplift, softness, sea);
        }
        const float factor = (1 - kLowland) * range() / std::max(std::ranges::max(level.metres), 1e-3f);
        for (float& metres : level.metres)
            metres *= factor;
        return true;
    }

    // Its lowest and highest points where they are asked for.
    static void stretch(io::HeightGrid& level, float lowest, float highest)
    {
        const auto [low, high] = std::ranges::minmax(level.metres);
        const float factor = high > low ? (highest - lowest) / (high - low) : 0;
        for (float& metres : level.metres)
            metres = std::clamp(lowest + (metres - low) * factor, lowest, highest);
    }

    io::HeightGrid finished(const glm::dvec2& extent)
    {
        const glm::ivec2 size{m_recipe.width, m_recipe.depth};
        for (std::size_t i = 0; i < m_rise.size(); ++i)
            m_ground.metres[i] += std::min(0.0f, m_rise[i]) * range();
        io::HeightGrid ground = m_ground.size == size ? std::move(m_ground) : io::resampled(m_ground, size, m_recipe.metresPerTexel, -extent / 2.0);
        ground.origin = -extent / 2.0;
        stretch(ground, m_recipe.lowest, m_recipe.highest);
        if (m_recipe.terraces > 0)
            for (float& metres : ground.metres) {
                const float steps = metres / m_recipe.terraceStep, base = std::floor(steps);
                metres = glm::mix(metres, (base + glm::smoothstep(0.35f, 0.9f, steps - base)) * m_recipe.terraceStep, m_recipe.terraces);
            }
        io::settle(ground, m_recipe.talus, 6);
        stretch(ground, m_recipe.lowest, m_recipe.highest);
        return ground;
    }

    bool say(float share) const { return io::report(m_progress, m_done + m_share * share, {}); }

    const GroundRecipe& m_recipe;
    const io::Progress& m_progress;
    Shape m_shape;
    io::HeightGrid m_ground;   // m above the sea
    std::vector<float> m_rise; // of the rough shape above the coast, share of the range; below 0 in the sea
    double m_extent = 1; // m, of the longer side
    float m_done = 0, m_share = 1;
};

// Each number against its range.
struct RangeVisitor {
    std::optional<std::string> fault;
    template <class T> void operator()(const char* key, const T& value, const io::Hint& hint)
    {
        if (fault) return;
        if (const io::FieldFault found = io::checkNumber(double(value), hint, std::is_integral_v<T>)) fault = std::string{key} + ": " + *found;
    }
};

} // namespace

std::optional<std::string> faultOf(const GroundRecipe& recipe)
{
    RangeVisitor visitor;
    fields(visitor, recipe);
    if (!visitor.fault && recipe.highest <= recipe.lowest) return "highest: must be above lowest";
    return visitor.fault;
}

GroundRecipe coarser(GroundRecipe recipe, int side)
{
    const int longer = std::max(recipe.width, recipe.depth);
    if (longer <= side) return recipe;
    const double factor = double(side - 1) / (longer - 1);
    recipe.metresPerTexel /= factor;
    recipe.width = std::max(2, int(std::lround((recipe.width - 1) * factor)) + 1);
    recipe.depth = std::max(2, int(std::lround((recipe.depth - 1) * factor)) + 1);
    return recipe;
}

io::Result<io::HeightGrid> generateGround(const GroundRecipe& recipe, const io::Progress& progress)
{
    if (const auto fault = faultOf(recipe)) return io::Error{{}, *fault};
    return Making{recipe, progress}.run();
}

} // namespace editor
