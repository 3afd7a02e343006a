#include "io/scene/ground_flow.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace io {
namespace {

constexpr double kLeastArea = 100, kTenfolds = 5; // m²; up to 10 km²
constexpr int kSteps = 1 << 16;                   // of heights, to sort by

// Cells from the highest to the lowest, by counting: as fine as 16 bits tell.
std::vector<std::uint32_t> downwards(const std::vector<float>& heights, float low, float high)
{
    const float scale = high > low ? float(kSteps - 1) / (high - low) : 0;
    const auto step = [&](float height) { return std::size_t((high - height) * scale); };
    std::vector<std::uint32_t> first(kSteps + 1);
    for (const float height : heights)
        ++first[step(height) + 1];
    for (std::size_t i = 1; i < first.size(); ++i)
        first[i] += first[i - 1];
    std::vector<std::uint32_t> cells(heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
        cells[first[step(heights[i])]++] = std::uint32_t(i);
    return cells;
}

} // namespace

GroundFlow flowOf(const HeightMap& map)
{
    const int step = (std::max(map.size.x, map.size.y) - 2) / (kFlowSide - 1) + 1;
    GroundFlow flow{.size = (map.size - 1) / step + 1, .cell = map.metresPerTexel * step};
    std::vector<float> heights;
    heights.reserve(std::size_t(flow.size.x) * flow.size.y);
    for (int z = 0; z < flow.size.y; ++z)
        for (int x = 0; x < flow.size.x; ++x)
            heights.push_back(map.at(x * step, z * step));
    const auto [low, high] = std::ranges::minmax(heights);

    std::vector<double> area(heights.size(), flow.cell * flow.cell);
    for (const std::uint32_t cell : downwards(heights, low, high)) {
        const glm::ivec2 at{int(cell) % flow.size.x, int(cell) / flow.size.x};
        std::array<double, 8> shares{};
        std::array<std::size_t, 8> lower{};
        double all = 0;
        int count = 0;
        for (int dz = -1; dz <= 1; ++dz)
            for (int dx = -1; dx <= 1; ++dx) {
                const glm::ivec2 to = at + glm::ivec2{dx, dz};
                if (to.x < 0 || to.y < 0 || to.x >= flow.size.x || to.y >= flow.size.y) continue;
                const std::size_t other = std::size_t(to.y) * flow.size.x + to.x;
                const double fall = double(heights[cell] - heights[other]) * (dx && dz ? 0.7071 : 1);
                if (fall <= 0) continue;
                shares[std::size_t(count)] = fall;
                lower[std::size_t(count++)] = other;
                all += fall;
            }
        for (int i = 0; i < count; ++i)
            area[lower[std::size_t(i)]] += area[cell] * shares[std::size_t(i)] / all;
    }
    flow.values.reserve(area.size());
    for (const double own : area)
        flow.values.push_back(float(std::clamp(std::log10(own / kLeastArea) / kTenfolds, 0.0, 1.0)));
    return flow;
}

} // namespace io
