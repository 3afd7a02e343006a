#include "renderer/terrain_tree.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr float kUsual = 2.3f; // standard deviations that hold 98 % of what is spread as chance would have it

int nodeSide(int level)
{
    return TERRAIN_QUADS << level; // texels
}

glm::ivec2 nodesAcross(glm::ivec2 size, int level)
{
    return (glm::max(size - 1, glm::ivec2{1}) + nodeSide(level) - 1) / nodeSide(level);
}

} // namespace

TerrainTree::TerrainTree(const io::HeightMap& heights) : m_size{heights.size}
{
    for (int level = 0; level < TERRAIN_LEVELS; ++level) {
        Level& made = m_levels.emplace_back();
        made.nodes = nodesAcross(m_size, level);
        made.lowHigh.resize(std::size_t(made.nodes.x) * made.nodes.y);
        made.errors.resize(made.lowHigh.size());
        if (made.nodes == glm::ivec2{1}) break;
    }
    measure(heights, {0, 0}, nodes(0));
}

void TerrainTree::update(const io::HeightMap& heights, const io::TexelRect& changed)
{
    // Nodes share the texels of their borders.
    const glm::ivec2 low = glm::max(glm::ivec2{changed.low} - 1, glm::ivec2{0}) / TERRAIN_QUADS;
    measure(heights, low, glm::min((glm::ivec2{changed.high} - 1) / TERRAIN_QUADS + 1, nodes(0)));
}

glm::vec2 TerrainTree::rangeOf(const io::TexelRect& rect) const
{
    const glm::ivec2 high = glm::min((glm::ivec2{rect.high} - 1) / TERRAIN_QUADS + 1, nodes(0));
    const glm::ivec2 low = glm::max(glm::ivec2{rect.low} - 1, glm::ivec2{0}) / TERRAIN_QUADS;
    glm::vec2 range{INFINITY, -INFINITY};
    for (int z = low.y; z < high.y; ++z)
        for (int x = low.x; x < high.x; ++x) {
            const glm::vec2 own = m_levels.front().lowHigh[indexOf(0, {x, z})];
            range = {std::min(range.x, own.x), std::max(range.y, own.y)};
        }
    return range;
}

void TerrainTree::measure(const io::HeightMap& heights, glm::ivec2 low, glm::ivec2 high)
{
    float usual = 0;
    for (int level = 0; level < levels(); ++level, low /= 2, high = (high + 1) / 2) {
        Level& own = m_levels[std::size_t(level)];
        for (int z = low.y; z < std::min(high.y, own.nodes.y); ++z)
            for (int x = low.x; x < std::min(high.x, own.nodes.x); ++x) {
                glm::vec2& range = own.lowHigh[indexOf(level, {x, z})];
                if (level == 0) {
                    range = finestRange(heights, {x, z});
                    continue;
                }
                Error error = errorOf(heights, level, {x, z});
                range = {INFINITY, -INFINITY};
                const glm::ivec2 last = glm::min(glm::ivec2{2 * x + 2, 2 * z + 2}, nodes(level - 1));
                for (int cz = 2 * z; cz < last.y; ++cz)
                    for (int cx = 2 * x; cx < last.x; ++cx) {
                        const Level& below = m_levels[std::size_t(level) - 1];
                        const std::size_t child = indexOf(level - 1, {cx, cz});
                        range = {std::min(range.x, below.lowHigh[child].x), std::max(range.y, below.lowHigh[child].y)};
                        error.most = std::max(error.most, below.errors[child].most);
                    }
                own.errors[indexOf(level, {x, z})] = error;
            }
        double squares = 0;
        for (const Error& error : own.errors)
            squares += double(error.square);
        usual = std::max(usual, kUsual * float(std::sqrt(squares / double(own.errors.size()))));
        own.usual = usual;
    }
}

glm::vec2 TerrainTree::finestRange(const io::HeightMap& heights, glm::ivec2 node) const
{
    const glm::ivec2 first = node * TERRAIN_QUADS, last = glm::min(first + TERRAIN_QUADS, m_size - 1);
    float low = INFINITY, high = -INFINITY;
    heights.field().eachRun({first, last + 1}, [&](const float* row, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            low = std::min(low, row[i]);
            high = std::max(high, row[i]);
        }
    });
    return {low, high};
}

// Measured in the middle of each edge and diagonal: smooth ground lies farthest away there, and a crease elsewhere at most twice as
// far. Vertices beyond the map's edge are drawn on it, so edges there are shorter.
TerrainTree::Error TerrainTree::errorOf(const io::HeightMap& heights, int level, glm::ivec2 node) const
{
    const int step = 1 << level, half = step / 2;
    const glm::ivec2 first = node * nodeSide(level), last = m_size - 1, end = glm::min(first + nodeSide(level), last);
    float largest = 0, squares = 0;
    int count = 0;
    const auto add = [&](float middle, float a, float b, int length) { // `middle` lies half a step from a
        const float away = std::abs(middle - (a + (b - a) * (float(half) / float(length))));
        largest = std::max(largest, away);
        squares += away * away;
        ++count;
    };
    for (int z = first.y; z <= end.y; z += step)
        for (int x = first.x; x <= end.x; x += step) {
            const int right = std::min(x + step, last.x), below = std::min(z + step, last.y);
            const bool across = x < end.x && x + half <= right, down = z < end.y && z + half <= below;
            if (across) add(heights.at(x + half, z), heights.at(x, z), heights.at(right, z), right - x);
            if (down) add(heights.at(x, z + half), heights.at(x, z), heights.at(x, below), below - z);
            if (!across || !down || right != x + step || below != z + step) continue;
            const float middle = heights.at(x + half, z + half); // tessellated quads may be cut along either diagonal
            add(middle, heights.at(right, z), heights.at(x, below), step);
            add(middle, heights.at(x, z), heights.at(right, below), step);
        }
    return {.most = largest, .square = squares / float(std::max(count, 1))};
}

int TerrainTree::coarsestWithin(double metres) const
{
    int coarsest = 0;
    for (int level = 1; level < levels() && double(m_levels[std::size_t(level)].usual) <= metres; ++level)
        coarsest = level;
    return coarsest;
}

GroundNode TerrainTree::nodeAt(int level, glm::ivec2 node) const
{
    const glm::vec2 lowHigh = m_levels[std::size_t(level)].lowHigh[indexOf(level, node)];
    return {.origin = node * nodeSide(level), .level = level, .low = lowHigh.x, .high = lowHigh.y};
}

} // namespace renderer
