// Which nodes of the ground are drawn for an eye, and how far each has turned into its parent: a restricted quadtree, split where
// a node's error shows. Continuous: with an eye that moves little, vertices do.
//
// A node's *reach* is its error over the one allowed at its distance; from 1 on it is split. Reaches are lifted until a parent has
// kNested times those of its children and of the nodes beside them. So neighbours differ by one level at most, and vertices between
// two levels are still on the coarser one while that one itself is at rest (compare Strugar, "Continuous Distance-Dependent Level of
// Detail", 2010, whose ranges nest in the same way, but are the same everywhere).
#pragma once

#include "renderer/terrain_tree.h"

#include <functional>
#include <optional>

namespace renderer {

// `morph`: 0 as the map has it .. 1 as the parent is. Odd vertices of an edge use the edge's own, which both sides agree on;
// kFinerBeside where the nodes beside are a level finer.
struct ChosenNode {
    GroundNode node;
    float morph = 0;
    glm::vec4 edges{0}; // at the low x, low z, high x, high z
};
constexpr float kFinerBeside = -1;

class TerrainChoice {
public:
    struct Eye {
        glm::dvec3 place{0};      // m; x and z from the map's first texel
        double metresPerTexel = 1;
        double errorAngle = 0;    // rad; how far the ground may stray
        double smallestQuad = 0;  // rad; no quad is split that shows smaller
        std::optional<int> onlyLevel; // in place of both: that level wherever it is there
        std::function<double(int level)> reach; // texels around the eye, along either axis, that a level is there for; empty: everywhere
    };
    void choose(const TerrainTree& tree, const Eye& eye);
    void clear() { m_visited.clear(); }
    bool empty() const { return m_visited.empty(); }

    // What was chosen and `seen(node)` lets through, each asked after its parent; from front to back, as the eye's place has it.
    // `passed` comes after each that was let through, and after what is within it, with what `seen` said of it.
    template <class Test, class Passed> std::vector<ChosenNode> nodes(const TerrainTree& tree, Test&& seen, Passed&& passed) const
    {
        std::vector<ChosenNode> chosen;
        if (!m_visited.empty()) collect(tree, tree.levels() - 1, {0, 0}, seen, passed, chosen);
        return chosen;
    }
    template <class Test> std::vector<ChosenNode> nodes(const TerrainTree& tree, Test&& seen) const
    {
        return nodes(tree, seen, [](bool) {});
    }

private:
    template <class Test, class Passed>
    void collect(const TerrainTree& tree, int level, glm::ivec2 node, Test& seen, Passed& passed, std::vector<ChosenNode>& out) const
    {
        const GroundNode here = tree.nodeAt(level, node);
        const auto mark = seen(here);
        if (!mark) return;
        if (!split(tree, level, node)) {
            out.push_back(finished(tree, here, node));
            return passed(mark);
        }
        const glm::dvec2 middle = glm::dvec2{here.origin + (TERRAIN_QUADS << level) / 2} * m_eye.metresPerTexel;
        const int first = (m_eye.place.x >= middle.x ? 1 : 0) + (m_eye.place.z >= middle.y ? 2 : 0);
        for (const int turned : {0, 1, 2, 3}) {
            const int quarter = first ^ turned;
            const glm::ivec2 child = node * 2 + glm::ivec2{quarter & 1, quarter >> 1};
            if (glm::all(glm::lessThan(child, tree.nodes(level - 1)))) collect(tree, level - 1, child, seen, passed, out);
        }
        passed(mark);
    }
    struct Reach {
        float value = 0;
        std::uint32_t turn = 0; // of choose() that set it
    };
    float reach(const TerrainTree& tree, int level, glm::ivec2 node) const; // 0 where none was asked for
    bool split(const TerrainTree& tree, int level, glm::ivec2 node) const { return level > 0 && reach(tree, level, node) >= 1; }
    Reach& visit(const TerrainTree& tree, int level, glm::ivec2 node);
    void descend(const TerrainTree& tree, int level, glm::ivec2 node);
    void lift(const TerrainTree& tree, int level, glm::ivec2 node, float least);
    ChosenNode finished(const TerrainTree& tree, const GroundNode& node, glm::ivec2 place) const;

    Eye m_eye;
    float m_perError = 0, m_perSide = 0; // m away at which a node is split whose error, or side, is a metre
    std::vector<double> m_farthest; // m, of each level: no node is split into it whose far corner lies beyond
    std::uint32_t m_turn = 0;
    std::vector<std::vector<Reach>> m_reaches;      // of each level's nodes
    std::vector<std::vector<glm::ivec2>> m_visited; // those of this turn
};

} // namespace renderer
