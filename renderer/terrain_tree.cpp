#include "renderer/terrain_tree.h"

#include "io/base/in_parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace renderer {
namespace {

constexpr float kUsual = 2.3f; // standard deviations that hold 98 % of what is spread as chance would have it
constexpr int kBlockLevel = 5;   // 512 texels a side, as tiles of the map
constexpr int kCopiedLevel = 3;  // up to which nodes read most of the texels beneath them
constexpr int kBlocksWorthAThread = 8;

int nodeSide(int level)
{
    return TERRAIN_QUADS << level; // texels
}

glm::ivec2 nodesAcross(glm::ivec2 size, int level)
{
    return (glm::max(size - 1, glm::ivec2{1}) + nodeSide(level) - 1) / nodeSide(level);
}

} // namespace

// Texels of a rectangle, side by side in memory.
class TerrainTree::Copied {
public:
    Copied(const io::HeightMap& heights, const io::TexelRect& rect)
        : m_low{rect.low}, m_width{std::size_t(rect.high.x - rect.low.x)}, m_texels{heights.field().read(rect)}
    {
    }
    const float* row(int x, int z) const { return &m_texels[std::size_t(z - m_low.y) * m_width + std::size_t(x - m_low.x)]; } // from x on
    float at(int x, int z) const { return *row(x, z); }

private:
    glm::ivec2 m_low;
    std::size_t m_width;
    std::vector<float> m_texels;
};

namespace {

// Measured in the middle of each edge and diagonal: smooth ground lies farthest away there, and a crease elsewhere at most twice as
// far. Tessellated quads may be cut along either diagonal.
template <class Heights> TerrainTree::Error errorWithin(const Heights& heights, int level, glm::ivec2 first)
{
    constexpr std::size_t kQuads = TERRAIN_QUADS;
    struct Row { // a height at every half step, those on vertices apart, for vector instructions
        std::array<float, kQuads + 1> vertices;
        std::array<float, kQuads> middles;
    };
    const int half = 1 << level >> 1;
    const auto read = [&](Row& row, int z) {
        for (std::size_t i = 0; i < kQuads; ++i) {
            row.vertices[i] = heights.at(first.x + int(2 * i) * half, z);
            row.middles[i] = heights.at(first.x + int(2 * i + 1) * half, z);
        }
        row.vertices[kQuads] = heights.at(first.x + int(2 * kQuads) * half, z);
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
template <class Heights> TerrainTree::Error errorAtTheEdge(const Heights& heights, int level, glm::ivec2 first, glm::ivec2 last)
{
    const int step = 1 << level, half = step / 2;
    const glm::ivec2 end = glm::min(first + nodeSide(level), last);
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

} // namespace

TerrainTree::TerrainTree(const io::HeightMap& heights) : m_size{heights.size}
{
    for (int level = 0; level < TERRAIN_LEVELS; ++level) {
        Level& made = m_levels.emplace_back();
        made.nodes = nodesAcross(m_size, level);
        made.lowHigh.resize(std::size_t(made.nodes.x) * made.nodes.y);
        if (level > 0) made.errors.resize(made.lowHigh.size());
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

// Block by block, all the levels of one before the next: then the map comes from memory once, not once for each level.
void TerrainTree::measure(const io::HeightMap& heights, glm::ivec2 low, glm::ivec2 high)
{
    const int whole = std::min(kBlockLevel, levels() - 1);
    const glm::ivec2 first = low >> whole, count = ((high - 1) >> whole) + 1 - first;
    io::inParallel(count.x * count.y, kBlocksWorthAThread, [&](int from, int to) {
        for (int i = from; i < to; ++i)
            measureBlock(heights, whole, first + glm::ivec2{i % count.x, i / count.x}, {low, high});
    });
    for (int level = whole + 1; level < levels(); ++level)
        for (int z = low.y >> level; z <= (high.y - 1) >> level; ++z)
            for (int x = low.x >> level; x <= (high.x - 1) >> level; ++x)
                measureNode(heights, level, {x, z});
    findUsual();
}

void TerrainTree::findUsual()
{
    float usual = 0;
    for (Level& level : std::span{m_levels}.subspan(1)) {
        double squares = 0;
        for (const Error& error : level.errors)
            squares += double(error.square);
        usual = std::max(usual, kUsual * float(std::sqrt(squares / double(level.errors.size()))));
        level.usual = usual;
    }
}

void TerrainTree::measureBlock(const io::HeightMap& heights, int whole, glm::ivec2 block, const Nodes& changed)
{
    const auto touched = [&](int level) { // nodes of a level, as those of the finest are given
        const int shift = whole - level;
        const glm::ivec2 low = glm::max(changed.low >> level, block << shift);
        return Nodes{low, glm::min(((changed.high - 1) >> level) + 1, glm::min((block + 1) << shift, nodes(level)))};
    };
    const auto each = [](const Nodes& nodes, auto&& visit) {
        for (int z = nodes.low.y; z < nodes.high.y; ++z)
            for (int x = nodes.low.x; x < nodes.high.x; ++x)
                visit(glm::ivec2{x, z});
    };
    const int fine = std::min(kCopiedLevel, whole);
    const Nodes coarsestCopied = touched(fine);
    const Copied texels{heights, {coarsestCopied.low * nodeSide(fine), glm::min(coarsestCopied.high * nodeSide(fine) + 1, m_size)}};
    findRanges(texels, touched(0));
    for (int level = 1; level <= whole; ++level)
        each(touched(level), [&](glm::ivec2 node) {
            if (level <= fine) measureNode(texels, level, node);
            else measureNode(heights, level, node);
        });
}

template <class Heights> void TerrainTree::measureNode(const Heights& heights, int level, glm::ivec2 node)
{
    Level& own = m_levels[std::size_t(level)];
    glm::vec2& range = own.lowHigh[indexOf(level, node)];
    const glm::ivec2 first = node * nodeSide(level);
    const bool atTheEdge = glm::any(glm::greaterThan(first + nodeSide(level), m_size - 1));
    Error error = atTheEdge ? errorAtTheEdge(heights, level, first, m_size - 1) : errorWithin(heights, level, first);
    range = {INFINITY, -INFINITY};
    const Level& below = m_levels[std::size_t(level) - 1];
    const glm::ivec2 last = glm::min(node * 2 + 2, below.nodes);
    for (int z = node.y * 2; z < last.y; ++z)
        for (int x = node.x * 2; x < last.x; ++x) {
            const std::size_t child = indexOf(level - 1, {x, z});
            range = {std::min(range.x, below.lowHigh[child].x), std::max(range.y, below.lowHigh[child].y)};
            error.most = std::max(error.most, this->error(level - 1, {x, z}));
        }
    own.errors[indexOf(level, node)] = error;
}

// Of a row of nodes at a time: first down its columns, then along.
void TerrainTree::findRanges(const Copied& texels, const Nodes& finest)
{
    const int from = finest.low.x * TERRAIN_QUADS, to = std::min(finest.high.x * TERRAIN_QUADS, m_size.x - 1);
    std::vector<float> low(std::size_t(to - from) + 1), high(low.size());
    for (int z = finest.low.y; z < finest.high.y; ++z) {
        std::ranges::fill(low, INFINITY);
        std::ranges::fill(high, -INFINITY);
        const int last = std::min((z + 1) * TERRAIN_QUADS, m_size.y - 1);
        for (int row = z * TERRAIN_QUADS; row <= last; ++row) {
            const float* own = texels.row(from, row);
            for (std::size_t i = 0; i < low.size(); ++i) {
                low[i] = std::min(low[i], own[i]);
                high[i] = std::max(high[i], own[i]);
            }
        }
        for (int x = finest.low.x; x < finest.high.x; ++x) {
            const auto begin = std::ptrdiff_t(x * TERRAIN_QUADS - from), end = std::min(begin + TERRAIN_QUADS + 1, std::ptrdiff_t(low.size()));
            m_levels.front().lowHigh[indexOf(0, {x, z})] = {*std::min_element(low.begin() + begin, low.begin() + end),
                                                            *std::max_element(high.begin() + begin, high.begin() + end)};
        }
    }
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
