// TerrainRay: where a ray meets the ground: exactly the triangles of io::HeightMap, found through a pyramid of
// lowest and highest values (Tevs, Ihrke, Seidel 2008), which takes a fourteenth of the heights' memory.
#pragma once

#include "io/scene/cover_map.h"
#include "io/scene/height_map.h"
#include "io/scene/terrain.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace editor {

class TerrainRay {
public:
    TerrainRay() = default;
    explicit TerrainRay(std::shared_ptr<const io::HeightMap> heights);

    // Heights that differ from those before within `changed` only, and are as many.
    void update(std::shared_ptr<const io::HeightMap> heights, const io::TexelRect& changed);

    void setCover(std::shared_ptr<const io::CoverMap> cover) { m_cover = std::move(cover); } // rays go through its holes

    // The nearest hit on the upper side within `maxDistance`.
    std::optional<io::TerrainHit> hit(const io::Ray& ray, double maxDistance = 1e9) const;

private:
    struct Level { // one node a square of 2^level * 8 cells
        glm::ivec2 size{0};
        std::vector<glm::vec2> range; // lowest and highest, m
    };
    // Of the four leaves of 4 x 4 cells in a node of the finest level, how far they stay from its lowest and highest: as
    // 255ths of their distance, rounded outwards. As floats the leaves would be two thirds of the pyramid.
    struct Leaves {
        std::array<std::uint8_t, 4> aboveLowest, belowHighest;
        void set(std::size_t leaf, const glm::vec2& range, const glm::vec2& node);
        glm::dvec2 range(std::size_t leaf, const glm::vec2& node) const;
    };
    void build(std::size_t level, const glm::ivec2& low, const glm::ivec2& high); // those nodes of it
    static void join(const Level& below, Level& level, const glm::ivec2& low, const glm::ivec2& high);
    void buildFinest(const glm::ivec2& low, const glm::ivec2& high);
    std::vector<glm::vec2> rangesOfLeaves(int row, int low, int high) const;
    struct Query;
    void descend(Query& query, int level, glm::ivec2 node) const;
    void leaf(Query& query, glm::ivec2 node) const;

    std::shared_ptr<const io::HeightMap> m_heights;
    std::shared_ptr<const io::CoverMap> m_cover; // as large; null: no holes
    std::vector<Level> m_levels;  // finest first
    std::vector<Leaves> m_leaves; // of each node of the finest level
};

} // namespace editor
