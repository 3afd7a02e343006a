#include "renderer/terrain_tree.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr double kSmallestRange = 3.2 * TERRAIN_QUADS; // texels; less would break the rule that neighbours differ by one

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
        made.lowHigh.assign(std::size_t(made.nodes.x) * made.nodes.y, {INFINITY, -INFINITY});
        if (made.nodes == glm::ivec2{1}) break;
    }
    measureNodes(heights, {0, 0}, m_levels.front().nodes);
    measureErrors(heights, heights.texels());
}

void TerrainTree::update(const io::HeightMap& heights, const io::TexelRect& changed)
{
    // Nodes share the texels of their borders.
    const glm::ivec2 low = glm::max(glm::ivec2{changed.low} - 1, glm::ivec2{0}) / TERRAIN_QUADS;
    measureNodes(heights, low, glm::min((glm::ivec2{changed.high} - 1) / TERRAIN_QUADS + 1, m_levels.front().nodes));
    measureErrors(heights, changed);
}

glm::vec2 TerrainTree::rangeOf(const io::TexelRect& rect) const
{
    const Level& finest = m_levels.front();
    const glm::ivec2 high = glm::min((glm::ivec2{rect.high} - 1) / TERRAIN_QUADS + 1, finest.nodes);
    glm::vec2 range{INFINITY, -INFINITY};
    const glm::ivec2 low = glm::max(glm::ivec2{rect.low} - 1, glm::ivec2{0}) / TERRAIN_QUADS; // nodes share the texels of their borders
    for (int z = low.y; z < high.y; ++z)
        for (int x = low.x; x < high.x; ++x) {
            const glm::vec2 own = finest.lowHigh[std::size_t(z) * finest.nodes.x + x];
            range = {std::min(range.x, own.x), std::max(range.y, own.y)};
        }
    return range;
}

// Nodes [low, high) of the finest level, and those above them.
void TerrainTree::measureNodes(const io::HeightMap& heights, glm::ivec2 low, glm::ivec2 high)
{
    for (std::size_t l = 0; l < m_levels.size(); ++l, low /= 2, high = (high + 1) / 2)
        for (int z = low.y; z < std::min(high.y, m_levels[l].nodes.y); ++z)
            for (int x = low.x; x < std::min(high.x, m_levels[l].nodes.x); ++x) {
                glm::vec2 range{INFINITY, -INFINITY};
                const auto add = [&range](float lowest, float highest) {
                    range = {std::min(range.x, lowest), std::max(range.y, highest)};
                };
                if (l == 0) {
                    const glm::ivec2 first = glm::ivec2{x, z} * TERRAIN_QUADS, last = glm::min(first + TERRAIN_QUADS, m_size - 1);
                    for (int tz = first.y; tz <= last.y; ++tz)
                        for (int tx = first.x; tx <= last.x; ++tx)
                            add(heights.at(tx, tz), heights.at(tx, tz));
                } else {
                    const Level& below = m_levels[l - 1];
                    for (int cz = 2 * z; cz < std::min(2 * z + 2, below.nodes.y); ++cz)
                        for (int cx = 2 * x; cx < std::min(2 * x + 2, below.nodes.x); ++cx) {
                            const glm::vec2 child = below.lowHigh[std::size_t(cz) * below.nodes.x + cx];
                            add(child.x, child.y);
                        }
                }
                m_levels[l].lowHigh[std::size_t(z) * m_levels[l].nodes.x + x] = range;
            }
}

// On a sparse set of texels: how far the middle of an edge of the coarser grid lies from the map. Where heights changed; the
// share that nearly all stay under is sought again only if one of those crossed it.
void TerrainTree::measureErrors(const io::HeightMap& heights, const io::TexelRect& changed)
{
    for (int l = 1; l < levels(); ++l) {
        Level& level = m_levels[std::size_t(l)];
        const int step = 1 << l;
        const glm::ivec2 stride = glm::max((m_size / (step * 96)) * step, glm::ivec2{step});
        const glm::ivec2 count = glm::max((m_size - step + stride - 1) / stride, glm::ivec2{0});
        bool crossed = level.strays.empty();
        level.strays.resize(std::size_t(count.x) * count.y * 3);
        if (level.strays.empty()) continue;
        const glm::ivec2 first = glm::max(glm::ivec2{changed.low} - step, glm::ivec2{0}) / stride;
        const glm::ivec2 last = glm::min((glm::ivec2{changed.high} - 1) / stride, count - 1);
        for (int row = first.y; row <= last.y; ++row)
            for (int column = first.x; column <= last.x; ++column) {
                const int x = column * stride.x, z = row * stride.y;
                const float a = heights.at(x, z), b = heights.at(x + step, z), c = heights.at(x, z + step);
                const float now[] = {std::abs(heights.at(x + step / 2, z) - (a + b) / 2), std::abs(heights.at(x, z + step / 2) - (a + c) / 2),
                                     std::abs(heights.at(x + step / 2, z + step / 2) - (b + c) / 2)};
                float* before = &level.strays[(std::size_t(row) * count.x + column) * 3];
                for (int i = 0; i < 3; ++i) {
                    crossed |= now[i] != before[i] && (before[i] - level.usual) * (now[i] - level.usual) <= 0;
                    before[i] = now[i];
                }
            }
        if (crossed) {
            std::vector<float> sorted = level.strays;
            const auto rank = sorted.begin() + std::ptrdiff_t(double(sorted.size() - 1) * 0.98);
            std::ranges::nth_element(sorted, rank);
            level.usual = *rank;
        }
        level.error = std::max(level.usual, m_levels[std::size_t(l) - 1].error);
    }
}

double TerrainTree::firstRange(double pixels, double pixelAngle, double metresPerTexel) const
{
    double range = kSmallestRange;
    for (int level = 1; level < levels(); ++level) {
        const double metres = double(m_levels[std::size_t(level)].error) / (pixels * pixelAngle);
        range = std::max(range, metres / metresPerTexel / std::exp2(level - 1));
    }
    // Never finer than quads of about three pixels: below that, more triangles show nothing more.
    const double finest = 1 / (3 * pixelAngle);
    return std::max(kSmallestRange, std::min(range, finest));
}

int TerrainTree::coarsestWithin(double metres) const
{
    int coarsest = 0;
    for (int level = 1; level < levels() && double(m_levels[std::size_t(level)].error) <= metres; ++level)
        coarsest = level;
    return coarsest;
}

GroundNode TerrainTree::nodeAt(int level, glm::ivec2 node) const
{
    const Level& own = m_levels[std::size_t(level)];
    const glm::vec2 lowHigh = own.lowHigh[std::size_t(node.y) * own.nodes.x + node.x];
    return {.origin = node * nodeSide(level), .level = level, .low = lowHigh.x, .high = lowHigh.y};
}

bool TerrainTree::touches(const Eye& eye, int level, glm::ivec2 node, double range) const
{
    const glm::dvec2 low = glm::dvec2{node * nodeSide(level)};
    const glm::dvec2 high = low + double(nodeSide(level));
    const glm::dvec2 away = glm::max(glm::max(low - eye.texel, eye.texel - high), glm::dvec2{0});
    return glm::dot(away, away) + eye.eyeAbove * eye.eyeAbove < range * range;
}

// False when the node lies beyond its level's range: its parent then shows that quarter.
bool TerrainTree::selectNode(const Eye& eye, int level, glm::ivec2 node, std::vector<GroundNode>& out) const
{
    const bool root = level + 1 == levels();
    const double range = eye.firstRange * std::exp2(level);
    if (!root && !touches(eye, level, node, range)) return false;

    GroundNode made = nodeAt(level, node);
    if (level == 0 || !touches(eye, level, node, range / 2)) {
        out.push_back(made);
        return true;
    }
    for (int quarter = 0; quarter < 4; ++quarter) {
        const glm::ivec2 child = node * 2 + glm::ivec2{quarter & 1, quarter >> 1};
        const glm::ivec2 nodes = m_levels[std::size_t(level) - 1].nodes;
        if (child.x >= nodes.x || child.y >= nodes.y) continue; // past the map's edge
        if (selectNode(eye, level - 1, child, out)) continue;
        made.quarter = quarter;
        out.push_back(made);
    }
    return true;
}

std::vector<GroundNode> TerrainTree::select(const Eye& eye) const
{
    std::vector<GroundNode> nodes;
    if (levels() > 0) selectNode(eye, levels() - 1, {0, 0}, nodes);
    return nodes;
}

} // namespace renderer
