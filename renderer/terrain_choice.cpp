#include "renderer/terrain_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace renderer {
namespace {

constexpr float kNested = 1.25f; // morphing goes on while the parent's reach is 1 .. kNested
// Smaller reaches are not looked for: what one would split by lifting is three levels coarser, beside it, and strays little itself.
constexpr float kWatched = 1 / (kNested * kNested * kNested);
constexpr float kSplitForSure = 1e6f;
constexpr double kNearest = 1e-3; // m
constexpr std::array<glm::ivec2, 4> kBeside{{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}}; // in the order of ChosenNode::edges

float morphOf(float parentsReach)
{
    return std::clamp((kNested - parentsReach) / (kNested - 1), 0.0f, 1.0f);
}

std::size_t indexOf(const TerrainTree& tree, int level, glm::ivec2 node)
{
    return std::size_t(node.y) * tree.nodes(level).x + node.x;
}

bool inside(const TerrainTree& tree, int level, glm::ivec2 node)
{
    return glm::all(glm::greaterThanEqual(node, glm::ivec2{0})) && glm::all(glm::lessThan(node, tree.nodes(level)));
}

} // namespace

void TerrainChoice::choose(const TerrainTree& tree, const Eye& eye)
{
    m_eye = eye;
    ++m_turn;
    m_farthest.clear();
    for (int level = 0; level < tree.levels(); ++level)
        m_farthest.push_back(eye.reach ? eye.reach(level) * eye.metresPerTexel : INFINITY);
    m_reaches.resize(std::size_t(tree.levels()));
    m_visited.resize(m_reaches.size());
    for (int level = 0; level < tree.levels(); ++level) {
        const glm::ivec2 count = tree.nodes(level);
        m_reaches[std::size_t(level)].resize(std::size_t(count.x) * count.y);
        m_visited[std::size_t(level)].clear();
    }
    descend(tree, tree.levels() - 1, {0, 0});
    for (int level = 0; level + 1 < tree.levels(); ++level)
        for (std::size_t i = 0; i < m_visited[std::size_t(level)].size(); ++i) {
            const glm::ivec2 node = m_visited[std::size_t(level)][i];
            const float own = reach(tree, level, node);
            if (own < kWatched) continue;
            lift(tree, level + 1, node / 2, own * kNested);
            for (const glm::ivec2 beside : kBeside)
                if (inside(tree, level, node + beside)) lift(tree, level + 1, (node + beside) / 2, own * kNested);
        }
}

float TerrainChoice::reach(const TerrainTree& tree, int level, glm::ivec2 node) const
{
    const Reach& own = m_reaches[std::size_t(level)][indexOf(tree, level, node)];
    return own.turn == m_turn ? own.value : 0;
}

TerrainChoice::Reach& TerrainChoice::visit(const TerrainTree& tree, int level, glm::ivec2 node)
{
    Reach& own = m_reaches[std::size_t(level)][indexOf(tree, level, node)];
    if (own.turn == m_turn) return own;
    own.turn = m_turn;
    m_visited[std::size_t(level)].push_back(node);
    const GroundNode box = tree.nodeAt(level, node);
    const glm::dvec2 low = glm::dvec2{box.origin} * m_eye.metresPerTexel, high = low + m_eye.metresPerTexel * double(TERRAIN_QUADS << level);
    const glm::dvec3 from{low.x, box.low, low.y}, to{high.x, box.high, high.y};
    if (m_eye.onlyLevel) {
        own.value = level > *m_eye.onlyLevel ? kSplitForSure : 0;
    } else {
        const glm::dvec3 away = glm::max(glm::max(from - m_eye.place, m_eye.place - to), glm::dvec3{0});
        const double distance = std::max(glm::length(away), kNearest), quad = m_eye.metresPerTexel * double(1 << level);
        own.value = float(std::min(double(tree.error(level, node)) * m_eye.smallestQuad, quad * m_eye.errorAngle) / (m_eye.errorAngle * m_eye.smallestQuad * distance));
    }
    if (level > 0 && std::isfinite(m_farthest[std::size_t(level) - 1])) {
        const glm::dvec3 far = glm::max(glm::abs(from - m_eye.place), glm::abs(to - m_eye.place));
        own.value = std::min(own.value, float(m_farthest[std::size_t(level) - 1] / std::max(far.x, far.z)));
    }
    return own;
}

void TerrainChoice::descend(const TerrainTree& tree, int level, glm::ivec2 node)
{
    if (level == 0 || visit(tree, level, node).value < kWatched) return;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const glm::ivec2 child = node * 2 + glm::ivec2{quarter & 1, quarter >> 1};
        if (inside(tree, level - 1, child)) descend(tree, level - 1, child);
    }
}

void TerrainChoice::lift(const TerrainTree& tree, int level, glm::ivec2 node, float least)
{
    Reach& own = visit(tree, level, node);
    own.value = std::max(own.value, least);
}

ChosenNode TerrainChoice::finished(const TerrainTree& tree, const GroundNode& node, glm::ivec2 place) const
{
    ChosenNode chosen{.node = node};
    if (node.level + 1 == tree.levels()) return chosen;
    chosen.morph = morphOf(reach(tree, node.level + 1, place / 2));
    for (int edge = 0; edge < 4; ++edge) {
        const glm::ivec2 beside = place + kBeside[std::size_t(edge)];
        float& morph = chosen.edges[edge];
        morph = chosen.morph;
        if (!inside(tree, node.level, beside)) continue;
        morph = std::max(morph, morphOf(reach(tree, node.level + 1, beside / 2)));
        if (split(tree, node.level, beside)) morph = kFinerBeside;
    }
    return chosen;
}

} // namespace renderer
