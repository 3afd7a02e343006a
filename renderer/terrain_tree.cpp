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
    Level& finest = m_levels.front();
    for (int z = 0; z < finest.nodes.y; ++z)
        for (int x = 0; x < finest.nodes.x; ++x) {
            glm::vec2& range = finest.lowHigh[std::size_t(z) * finest.nodes.x + x];
            const glm::ivec2 last = glm::min((glm::ivec2{x, z} + 1) * TERRAIN_QUADS, m_size - 1);
            for (int tz = z * TERRAIN_QUADS; tz <= last.y; ++tz)
                for (int tx = x * TERRAIN_QUADS; tx <= last.x; ++tx) {
                    const float h = heights.at(tx, tz);
                    range = {std::min(range.x, h), std::max(range.y, h)};
                }
        }
    for (std::size_t l = 1; l < m_levels.size(); ++l)
        for (int z = 0; z < m_levels[l - 1].nodes.y; ++z)
            for (int x = 0; x < m_levels[l - 1].nodes.x; ++x) {
                const glm::vec2 child = m_levels[l - 1].lowHigh[std::size_t(z) * m_levels[l - 1].nodes.x + x];
                glm::vec2& own = m_levels[l].lowHigh[std::size_t(z / 2) * m_levels[l].nodes.x + x / 2];
                own = {std::min(own.x, child.x), std::max(own.y, child.y)};
            }
    measureError(heights);
}

// On a sparse set of texels: how far the middle of an edge of the coarser grid lies from the map.
void TerrainTree::measureError(const io::HeightMap& heights)
{
    for (int level = 1; level < levels(); ++level) {
        const int step = 1 << level;
        std::vector<float> errors;
        const glm::ivec2 stride = glm::max((m_size / (step * 96)) * step, glm::ivec2{step});
        for (int z = 0; z + step < m_size.y; z += stride.y)
            for (int x = 0; x + step < m_size.x; x += stride.x) {
                const float a = heights.at(x, z), b = heights.at(x + step, z), c = heights.at(x, z + step);
                errors.push_back(std::abs(heights.at(x + step / 2, z) - (a + b) / 2));
                errors.push_back(std::abs(heights.at(x, z + step / 2) - (a + c) / 2));
                errors.push_back(std::abs(heights.at(x + step / 2, z + step / 2) - (b + c) / 2));
            }
        if (errors.empty()) continue;
        const auto rank = errors.begin() + std::ptrdiff_t(double(errors.size() - 1) * 0.98);
        std::ranges::nth_element(errors, rank);
        m_levels[std::size_t(level)].error = std::max(*rank, m_levels[std::size_t(level) - 1].error);
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
