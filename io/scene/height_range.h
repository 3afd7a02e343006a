// The lowest and the highest of many heights: x and y of a glm::vec2, m. NaN is passed over.
#pragma once

#include "io/scene/texel_tiles.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace io {

constexpr glm::vec2 kNoHeights{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};

inline glm::vec2 joined(const glm::vec2& a, const glm::vec2& b)
{
    return {std::min(a.x, b.x), std::max(a.y, b.y)};
}

// In eight lanes: one minimum that waits for the one before takes four times as long.
inline glm::vec2 rangeOf(std::span<const float> metres)
{
    constexpr std::size_t kLanes = 8;
    std::array<float, kLanes> low, high;
    low.fill(kNoHeights.x);
    high.fill(kNoHeights.y);
    const auto take = [&](std::size_t lane, float m) {
        low[lane] = m < low[lane] ? m : low[lane];
        high[lane] = m > high[lane] ? m : high[lane];
    };
    const std::size_t whole = metres.size() / kLanes * kLanes;
    for (std::size_t i = 0; i < whole; i += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            take(lane, metres[i + lane]);
    for (std::size_t i = whole; i < metres.size(); ++i)
        take(0, metres[i]);
    return {*std::ranges::min_element(low), *std::ranges::max_element(high)};
}

// Of the first `extent` texels of a tile, along each side.
inline glm::vec2 rangeOfTile(std::span<const float> tile, glm::ivec2 extent)
{
    glm::vec2 range = kNoHeights;
    for (int row = 0; row < extent.y; ++row)
        range = joined(range, rangeOf(tile.subspan(std::size_t(row) * kTileSide, std::size_t(extent.x))));
    return range;
}

} // namespace io
