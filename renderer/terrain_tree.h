// A quadtree over the height map: how high its nodes reach, and how far each would stray from the map if it were drawn.
#pragma once

#include "io/scene/height_map.h"
#include "renderer/shaders/shared/terrain.h"

#include <glm/glm.hpp>
#include <vector>

namespace renderer {

// A square of TERRAIN_QUADS x TERRAIN_QUADS quads whose vertices are 2^level texels apart.
struct GroundNode {
    glm::ivec2 origin{0};    // texel
    int level = 0;
    float low = 0, high = 0; // m
};

class TerrainTree {
public:
    struct Error {
        float most = 0;   // as error()
        float square = 0; // the mean, m²
    };

    TerrainTree() = default;
    explicit TerrainTree(const io::HeightMap& heights);

    // Heights that differ from those before within `changed` only, and are as many.
    void update(const io::HeightMap& heights, const io::TexelRect& changed);

    int levels() const { return int(m_levels.size()); } // the last one is a single node
    glm::ivec2 nodes(int level) const { return m_levels[std::size_t(level)].nodes; }
    GroundNode nodeAt(int level, glm::ivec2 node) const;
    glm::vec2 rangeOf(const io::TexelRect& rect) const; // m, lowest and highest of the nodes there

    // m that the map lies within of the node's triangles, as far as the middles of their edges tell: nowhere more than twice that on
    // ground without wrinkles finer than a quad. Of no node less than of those within it.
    float error(int level, glm::ivec2 node) const { return level == 0 ? 0 : m_levels[std::size_t(level)].errors[indexOf(level, node)].most; }

    // Of one level everywhere; those that `seen(node)` lets through, each asked after its parent.
    template <class Test> std::vector<GroundNode> selectLevel(int level, Test&& seen) const
    {
        std::vector<GroundNode> nodes;
        if (levels() > 0) selectLevel(levels() - 1, {0, 0}, level, seen, nodes);
        return nodes;
    }
    int coarsestWithin(double metres) const; // the coarsest level that hardly strays farther from the map

private:
    template <class Test> void selectLevel(int level, glm::ivec2 node, int wanted, Test& seen, std::vector<GroundNode>& out) const
    {
        const GroundNode here = nodeAt(level, node);
        if (!seen(here)) return;
        if (level == wanted) return out.push_back(here);
        for (int quarter = 0; quarter < 4; ++quarter) {
            const glm::ivec2 child = node * 2 + glm::ivec2{quarter & 1, quarter >> 1};
            if (glm::all(glm::lessThan(child, nodes(level - 1)))) selectLevel(level - 1, child, wanted, seen, out);
        }
    }
    std::size_t indexOf(int level, glm::ivec2 node) const { return std::size_t(node.y) * nodes(level).x + node.x; }

    struct Level {
        glm::ivec2 nodes{0};
        std::vector<glm::vec2> lowHigh; // m
        std::vector<Error> errors; // none of the finest, which is the map
        float usual = 0; // m that all but a fiftieth stray less, of this level or of a finer one
    };
    struct Nodes {
        glm::ivec2 low, high; // the latter beyond them
    };
    class Copied;
    void measure(const io::HeightMap& heights, glm::ivec2 low, glm::ivec2 high); // nodes of the finest level, and those above them
    void measureBlock(const io::HeightMap& heights, int whole, glm::ivec2 block, const Nodes& changed);
    template <class Heights> void measureNode(const Heights& heights, int level, glm::ivec2 node); // after those within it
    void findRanges(const Copied& texels, const Nodes& finest);
    void findUsual();

    std::vector<Level> m_levels;
    glm::ivec2 m_size{0};
};

} // namespace renderer
