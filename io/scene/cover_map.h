// What a person painted over the ground: for each texel of the height map which two layers, how much of each, and how far that
// covers what the layers' own rules say. Two layers a texel as in Terrain3D's control map; neighbours are blended when drawn.
#pragma once

#include "io/scene/texel_tiles.h"

#include <cstdint>

namespace io {

constexpr std::uint32_t kHoleBit = 0x80;

constexpr int kMostLayers = 32;

struct Cover {
    int base = 0, over = 0;  // layers, 0..31
    float share = 0;         // of `over`, 0..1
    float painted = 0;       // 0: the rules alone, 1: nothing of them
    bool hole = false;       // the square from this texel to the next ones is missing
    bool operator==(const Cover&) const = default;
};

// 0 is a texel that nobody touched.
constexpr std::uint32_t packed(const Cover& c)
{
    const auto byte = [](float v) { return std::uint32_t(v <= 0 ? 0 : v >= 1 ? 255 : v * 255 + 0.5f); };
    const std::uint32_t hole = c.hole ? kHoleBit : 0;
    if (byte(c.painted) == 0) return hole;
    return hole | std::uint32_t(c.base & 31) | std::uint32_t(c.over & 31) << 8 | byte(c.share) << 16 | byte(c.painted) << 24;
}
constexpr Cover unpacked(std::uint32_t bits)
{
    return {int(bits & 31), int(bits >> 8 & 31), float(bits >> 16 & 255) / 255, float(bits >> 24) / 255, (bits & kHoleBit) != 0};
}

using CoverMap = TexelTiles<std::uint32_t>;

} // namespace io
