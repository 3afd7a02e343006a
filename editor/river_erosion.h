// Rivers that cut into ground, for whole landscapes: the stream power law, solved implicitly along the ways that water takes
// (Braun and Willett 2013, "A very efficient O(n), implicit and parallel method to solve the stream power equation"). Water finds
// its way out of hollows by a priority flood (Barnes, Lehman and Mulla 2014), as Cordonnier et al. 2016 make terrain of uplift.
#pragma once

#include "io/scene/height_grid.h"

#include <cstdint>
#include <vector>

namespace editor {

struct Rivers {
    float cutting = 0.1f; // K dt: what a slope of 1 under 1 m² of drained ground loses in one step, m
    float hillside = 1; // m²; ground that drains less of it wears as if it drained so much
    float talus = 40;     // degrees; no steeper towards where the water goes
    std::uint32_t seed = 1; // of the small chance that keeps rivers from the grid's eight directions
};

class RiverErosion {
public:
    explicit RiverErosion(io::HeightGrid& heights) : m_heights{heights} {}

    // One step. Of each point of the heights `uplift` says by how many metres it rises meanwhile, `softness` how much more than
    // others it wears, and `outlet` whether water leaves there, as it does at the edge; such points stay as they are.
    void step(const Rivers& rivers, const std::vector<float>& uplift, const std::vector<float>& softness, const std::vector<char>& outlet);

private:
    void findWays(const std::vector<char>& outlet, std::uint32_t seed);
    int wayOut(int cell, std::uint32_t seed) const;

    io::HeightGrid& m_heights;
    std::vector<int> m_order;     // cells, each after the one that its water runs to
    std::vector<int> m_receiver;  // that its water runs to; itself where it leaves
    std::vector<float> m_filled;  // heights with hollows filled, m
    std::vector<float> m_drained; // m²
    std::vector<char> m_known;    // 1: waits in the queue, 2: has its place in the order
};

} // namespace editor
