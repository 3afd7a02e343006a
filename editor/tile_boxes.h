// TileBoxes: the boxes of numbered tiles, for rays, in blocks that have a box too: of some hundred boxes a tree's steps
// cost more than looking at all of them.
#pragma once

#include "io/scene/tree_geometry.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace editor {

class TileBoxes {
public:
    void set(std::uint32_t tile, const io::WorldBox& box)
    {
        if (tile / kBlock >= m_blocks.size()) m_blocks.resize(tile / kBlock + 1);
        m_blocks[tile / kBlock].set(tile % kBlock, io::roundedOutwards(box));
    }
    void remove(std::uint32_t tile) { m_blocks[tile / kBlock].set(tile % kBlock, {}); }
    void clear() { m_blocks.clear(); }

    // Tiles whose box the ray enters within `reach` (m), in the order of where it does. `visit(tile, entry)` answers
    // how far the ray still goes.
    template <class Visit> void ray(const io::Ray& ray, double reach, Visit&& visit)
    {
        const io::SlabTest slabs{ray};
        m_entered.clear();
        for (std::size_t i = 0; i < m_blocks.size(); ++i)
            if (meets(slabs, m_blocks[i].around, reach) != io::SlabTest::kMiss) enter(i, slabs, reach);
        std::ranges::sort(m_entered, {}, &Entered::key);
        for (const Entered& entered : m_entered) {
            if (!(entered.at <= reach)) break;
            reach = std::min(reach, double(visit(entered.tile, entered.at)));
        }
    }

private:
    static constexpr std::uint32_t kBlock = 16;

    struct Block {
        std::array<io::Box, kBlock> boxes; // empty: no such tile
        io::Box around;

        void set(std::uint32_t place, const io::Box& box)
        {
            boxes[place] = box;
            around = {};
            for (const io::Box& one : boxes)
                if (!one.empty()) around.add(one);
        }
    };
    struct Entered {
        double at; // m
        std::uint32_t tile;
        auto key() const { return std::tuple{at, tile}; }
    };

    static double meets(const io::SlabTest& slabs, const io::Box& box, double reach)
    {
        if (box.empty()) return io::SlabTest::kMiss;
        const double at = slabs.entry(box);
        return at <= reach ? at : io::SlabTest::kMiss;
    }

    void enter(std::size_t block, const io::SlabTest& slabs, double reach)
    {
        for (std::uint32_t i = 0; i < kBlock; ++i) {
            const double at = meets(slabs, m_blocks[block].boxes[i], reach);
            if (at != io::SlabTest::kMiss) m_entered.push_back({at, std::uint32_t(block) * kBlock + i});
        }
    }

    std::vector<Block> m_blocks;
    std::vector<Entered> m_entered; // of the ray under way
};

} // namespace editor
