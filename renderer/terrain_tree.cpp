#include "renderer/terrain_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <numeric>
#include <thread>

namespace renderer {
namespace {

constexpr float kUsual = 2.3f; // standard deviations that hold 98 % of what is spread as chance would have it
constexpr int kManyNodes = 4096; // worth a thread for each processor

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
        const glm::ivec2 last = glm::min(high, own.nodes);
        const auto rows = [&](int from, int to) {
            for (int z = from; z < to; ++z)
                for (int x = low.x; x < last.x; ++x)
                    measureNode(heights, level, {x, z});
        };
        const int all = last.y - low.y, threads = int(std::thread::hardware_concurrency());
        std::vector<std::future<void>> others;
        if (all * (last.x - low.x) > kManyNodes)
            for (int i = 1; i < threads; ++i)
                others.push_back(std::async(std::launch::async, rows, low.y + all * i / threads, low.y + all * (i + 1) / threads));
        rows(low.y, others.empty() ? last.y : low.y + all / threads);
        for (std::future<void>& other : others)
            other.get();
        double squares = 0;
        for (const Error& error : own.errors)
            squares += double(error.square);
        usual = std::max(usual, kUsual * float(std::sqrt(squares / double(own.errors.size()))));
        own.usual = usual;
    }
}

void TerrainTree::measureNode(const io::HeightMap& heights, int level, glm::ivec2 node)
{
    Level& own = m_levels[std::size_t(level)];
    glm::vec2& range = own.lowHigh[indexOf(level, node)];
    if (level == 0) {
        range = finestRange(heights, node);
        return;
    }
    Error error = errorOf(heights, level, node);
    range = {INFINITY, -INFINITY};
    const Level& below = m_levels[std::size_t(level) - 1];
    const glm::ivec2 last = glm::min(node * 2 + 2, below.nodes);
    for (int z = node.y * 2; z < last.y; ++z)
        for (int x = node.x * 2; x < last.x; ++x) {
            const std::size_t child = indexOf(level - 1, {x, z});
            range = {std::min(range.x, below.lowHigh[child].x), std::max(range.y, below.lowHigh[child].y)};
            error.most = std::max(error.most, below.errors[child].most);
        }
    own.errors[indexOf(level, node)] = error;
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
// far. Tessellated quads may be cut along either diagonal.
TerrainTree::Error TerrainTree::errorOf(const io::HeightMap& heights, int level, glm::ivec2 node) const
{
    const glm::ivec2 first = node * nodeSide(level);
    if (glm::any(glm::greaterThan(first + nodeSide(level), m_size - 1))) return errorAtTheEdge(heights, level, node);
    constexpr std::size_t kQuads = TERRAIN_QUADS;
    struct Row { // a height at every half step, those on vertices apart, for vector instructions
        std::array<float, kQuads + 1> vertices;
        std::array<float, kQuads> middles;
    };
    const int half = 1 << level >> 1;
    std::array<float, 2 * kQuads + 1> texels;
    const auto read = [&](Row& row, int z) {
        if (half == 1) {
            float* to = texels.data();
            heights.field().eachRun({{first.x, z}, {first.x + int(texels.size()), z + 1}}, [&](const float* run, std::size_t count) { to = std::copy_n(run, count, to); });
        } else {
            for (std::size_t i = 0; i < texels.size(); ++i)
                texels[i] = heights.at(first.x + int(i) * half, z);
        }
        for (std::size_t i = 0; i < kQuads; ++i) {
            row.vertices[i] = texels[2 * i];
            row.middles[i] = texels[2 * i + 1];
        }
        row.vertices[kQuads] = texels[2 * kQuads];
    };
    std::array<float, kQuads + 1> largest{}, squares{}; // of each column
    const auto add = [&](std::size_t column, float middle, float a, float b) {
        const float away = std::abs(middle - (a + b) * 0.5f);
        largest[column] = std::max(largest[column], away);
        squares[column] += away * away;
    };
    Row here, between, next;
    read(here, first.y);
    for (std::size_t z = 0; z < kQuads; ++z, here = next) {
        read(between, first.y + int(2 * z + 1) * half);
        read(next, first.y + int(2 * z + 2) * half);
        for (std::size_t x = 0; x <= kQuads; ++x)
            add(x, between.vertices[x], here.vertices[x], next.vertices[x]);
        for (std::size_t x = 0; x < kQuads; ++x) {
            add(x, here.middles[x], here.vertices[x], here.vertices[x + 1]);
            add(x, between.middles[x], here.vertices[x + 1], next.vertices[x]);
            add(x, between.middles[x], here.vertices[x], next.vertices[x + 1]);
        }
    }
    for (std::size_t x = 0; x < kQuads; ++x) // the last row's edges
        add(x, here.middles[x], here.vertices[x], here.vertices[x + 1]);
    constexpr std::size_t kCount = kQuads * (kQuads + 1) * 2 + kQuads * kQuads * 2;
    return {.most = *std::ranges::max_element(largest), .square = std::accumulate(squares.begin(), squares.end(), 0.0f) / float(kCount)};
}

// Vertices beyond the map's edge are drawn on it, so edges there are shorter.
TerrainTree::Error TerrainTree::errorAtTheEdge(const io::HeightMap& heights, int level, glm::ivec2 node) const
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
            const float middle = heights.at(x + half, z + half);
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
