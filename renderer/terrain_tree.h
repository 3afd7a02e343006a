// The ground's levels of detail: a quadtree over the height map, and the nodes that an eye needs.
#pragma once

#include "io/scene/height_map.h"
#include "renderer/shaders/shared/terrain.h"

#include <glm/glm.hpp>
#include <vector>

namespace renderer {

// A node, or one quarter of it where its other quarters are shown finer.
struct GroundNode {
    glm::ivec2 origin{0};  // texel
    int level = 0;         // 2^level texels between vertices
    int quarter = -1;      // -1 the whole, else x + 2 z
    float low = 0, high = 0; // m
};

class TerrainTree {
public:
    TerrainTree() = default;
    explicit TerrainTree(const io::HeightMap& heights);

    // Heights that differ from those before within `changed` only, and are as many.
    void update(const io::HeightMap& heights, const io::TexelRect& changed);
    glm::vec2 rangeOf(const io::TexelRect& rect) const; // m, lowest and highest of the nodes there

    int levels() const { return int(m_levels.size()); }

    // Levels by distance along the ground: level l ends at range(l). `eyeAbove` is the height over the ground, a
    // part of every distance, so that from high up all is coarse.
    struct Eye {
        glm::dvec2 texel{0};
        double eyeAbove = 0;   // texels
        double firstRange = 0; // texels; each further level reaches twice as far
    };
    std::vector<GroundNode> select(const Eye& eye) const;

    // The finest level's range for an error of at most `pixels`, from how far each level strays from the map.
    double firstRange(double pixels, double pixelAngle, double metresPerTexel) const;

    // Of one level everywhere, whatever the eye; those that `seen(node)` lets through, each asked after its parent.
    template <class Test>
    std::vector<GroundNode> selectLevel(int level, Test&& seen) const
    {
        std::vector<GroundNode> nodes;
        if (levels() > 0) selectLevel(levels() - 1, {0, 0}, level, seen, nodes);
        return nodes;
    }
    int coarsestWithin(double metres) const; // the coarsest level that strays no farther from the map

private:
    template <class Test>
    void selectLevel(int level, glm::ivec2 node, int wanted, Test& seen, std::vector<GroundNode>& out) const
    {
        const GroundNode here = nodeAt(level, node);
        if (!seen(here)) return;
        if (level == wanted) return out.push_back(here);
        for (int quarter = 0; quarter < 4; ++quarter) {
            const glm::ivec2 child = node * 2 + glm::ivec2{quarter & 1, quarter >> 1};
            if (glm::all(glm::lessThan(child, m_levels[std::size_t(level) - 1].nodes))) selectLevel(level - 1, child, wanted, seen, out);
        }
    }
    GroundNode nodeAt(int level, glm::ivec2 node) const;

    struct Level {
        glm::ivec2 nodes{0};
        std::vector<glm::vec2> lowHigh; // m
        std::vector<float> strays;      // m, of a sparse set of places: how far its edges lie from the map
        float usual = 0;                // m, that nearly all of those stay under
        float error = 0;                // m, that of this level or of a finer one
    };
    void measureNodes(const io::HeightMap& heights, glm::ivec2 low, glm::ivec2 high);
    void measureErrors(const io::HeightMap& heights, const io::TexelRect& changed);
    bool selectNode(const Eye& eye, int level, glm::ivec2 node, std::vector<GroundNode>& out) const;
    bool touches(const Eye& eye, int level, glm::ivec2 node, double range) const;

    std::vector<Level> m_levels;
    glm::ivec2 m_size{0};
};

} // namespace renderer
