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
constexpr float kNearest = 1e-3f; // m
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
    m_perError = float(1 / eye.errorAngle);
    m_perSide = float(1 / (eye.smallestQuad * TERRAIN_QUADS));
    ++m_turn;
    m_farthest.clear();
    for (int level = 0; level < tree.levels(); ++level)
        m_farthest.push_back(eye.reach ? eye.reach(level) * eye.metresPerTexel : INFINITY);
    m_reaches.resize(std::size_t(tree.levels()));
    m_visited.resize(m_reaches.size());
    for (auto& visited : m_visited)
        visited.clear();
    for (int level = 1; level < tree.levels(); ++level) // the finest are not split, and are most of them
        m_reaches[std::size_t(level)].resize(std::size_t(tree.nodes(level).x) * tree.nodes(level).y);
    descend(tree, tree.levels() - 1, {0, 0});
    for (int level = 0; level + 1 < tree.levels(); ++level)
        for (std::size_t i = 0; i < m_visited[std::size_t(level)].size(); ++i) {
            const glm::ivec2 node = m_visited[std::size_t(level)][i];
            const float own = reach(tree, level, node);
            if (own < kWatched) continue;
            // Two of the nodes beside it have its own parent.
            const glm::ivec2 parent = node / 2, outwards = (node & 1) * 2 - 1;
            lift(tree, level + 1, parent, own * kNested);
            for (const glm::ivec2 beside : {parent + glm::ivec2{outwards.x, 0}, parent + glm::ivec2{0, outwards.y}})
                if (inside(tree, level + 1, beside)) lift(tree, level + 1, beside, own * kNested);
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
    const glm::vec2 corner{glm::dvec2{box.origin} * m_eye.metresPerTexel - glm::dvec2{m_eye.place.x, m_eye.place.z}};
    const float height = float(m_eye.place.y), side = float(m_eye.metresPerTexel * double(TERRAIN_QUADS << level));
    const glm::vec3 from{corner.x, box.low - height, corner.y}, to{corner.x + side, box.high - height, corner.y + side}; // from the eye, m
    if (m_eye.onlyLevel) {
        own.value = level > *m_eye.onlyLevel ? kSplitForSure : 0;
    } else {
        const glm::vec3 away = glm::max(glm::max(from, -to), glm::vec3{0});
        own.value = std::min(tree.error(level, node) * m_perError, side * m_perSide) / std::max(glm::length(away), kNearest);
    }
    if (level > 0 && std::isfinite(m_farthest[std::size_t(level) - 1])) {
        const glm::vec3 far = glm::max(glm::abs(from), glm::abs(to));
        own.value = std::min(own.value, float(m_farthest[std::size_t(level) - 1]) / std::max(far.x, far.z));
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
