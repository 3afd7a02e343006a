#include "editor/river_erosion.h"

#include "io/base/contract.h"
#include "io/base/random.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace editor {
namespace {

constexpr float kDiagonal = 1.41421356f;
constexpr float kLeastFall = 1e-4f; // of a texel's width, so that water crosses what it filled

struct Neighbour {
    int x, z;
    float far; // texels
};
constexpr Neighbour kNeighbours[] = {{-1, 0, 1}, {1, 0, 1}, {0, -1, 1}, {0, 1, 1}, {-1, -1, kDiagonal}, {1, -1, kDiagonal}, {-1, 1, kDiagonal}, {1, 1, kDiagonal}};

struct Waiting {
    float metres;
    int cell;
    bool operator>(const Waiting& other) const { return metres != other.metres ? metres > other.metres : cell > other.cell; }
};

} // namespace

// From where water leaves inwards, always on from the lowest: each cell is reached over the lowest pass to it.
void RiverErosion::findWays(const std::vector<char>& outlet, std::uint32_t seed)
{
    const glm::ivec2 size = m_heights.size;
    const std::size_t count = m_heights.metres.size();
    m_order.clear();
    m_order.reserve(count);
    m_receiver.assign(count, -1);
    m_filled = m_heights.metres;
    m_known.assign(count, 0);
    std::vector<Waiting> storage;
    storage.reserve(count / 4);
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue{std::greater<>{}, std::move(storage)};
    for (int z = 0; z < size.y; ++z)
        for (int x = 0; x < size.x; ++x) {
            const int cell = z * size.x + x;
            if (x > 0 && z > 0 && x + 1 < size.x && z + 1 < size.y && !outlet[std::size_t(cell)]) continue;
            queue.push({m_filled[std::size_t(cell)], cell});
            m_receiver[std::size_t(cell)] = cell;
            m_known[std::size_t(cell)] = 1;
        }
    const float least = kLeastFall * float(m_heights.metresPerTexel);
    while (!queue.empty()) {
        const int cell = queue.top().cell;
        queue.pop();
        if (m_receiver[std::size_t(cell)] < 0) m_receiver[std::size_t(cell)] = wayOut(cell, seed);
        m_order.push_back(cell);
        m_known[std::size_t(cell)] = 2;
        const int x = cell % size.x, z = cell / size.x;
        for (const Neighbour& n : kNeighbours) {
            if (x + n.x < 0 || z + n.z < 0 || x + n.x >= size.x || z + n.z >= size.y) continue;
            const int next = cell + n.z * size.x + n.x;
            if (m_known[std::size_t(next)]) continue;
            m_known[std::size_t(next)] = 1;
            float& metres = m_filled[std::size_t(next)];
            metres = std::max(metres, m_filled[std::size_t(cell)] + least);
            queue.push({metres, next});
        }
    }
}

// The steepest of those that are in the order; not at the edge.
int RiverErosion::wayOut(int cell, std::uint32_t seed) const
{
    const int width = m_heights.size.x;
    int best = -1;
    float steepest = -1;
    for (int i = 0; i < 8; ++i) {
        const int next = cell + kNeighbours[i].z * width + kNeighbours[i].x;
        if (m_known[std::size_t(next)] != 2) continue;
        const float chance = 0.5f + io::unitOf(io::hash(std::uint32_t(cell) * 8u + std::uint32_t(i) + seed));
        const float fall = (m_filled[std::size_t(cell)] - m_filled[std::size_t(next)]) / kNeighbours[i].far * chance;
        if (fall > steepest) {
            steepest = fall;
            best = next;
        }
    }
    return best;
}

void RiverErosion::step(const Rivers& rivers, const std::vector<float>& uplift, const std::vector<float>& softness, const std::vector<char>& outlet)
{
    EXPECTS(uplift.size() == m_heights.metres.size() && softness.size() == uplift.size() && outlet.size() == uplift.size());
    findWays(outlet, rivers.seed);
    const auto texel = float(m_heights.metresPerTexel);
    m_drained.assign(m_order.size(), texel * texel);
    for (auto cell = m_order.rbegin(); cell != m_order.rend(); ++cell)
        if (const int to = m_receiver[std::size_t(*cell)]; to != *cell) m_drained[std::size_t(to)] += m_drained[std::size_t(*cell)];

    const float steepest = std::tan(glm::radians(rivers.talus)), least = kLeastFall * texel;
    const int width = m_heights.size.x;
    for (const int cell : m_order) {
        const int to = m_receiver[std::size_t(cell)];
        if (to == cell) continue;
        const int away = std::abs(cell - to);
        const float far = away == 1 || away == width ? texel : texel * kDiagonal;
        const float below = m_heights.metres[std::size_t(to)];
        float& metres = m_heights.metres[std::size_t(cell)];
        metres += uplift[std::size_t(cell)];
        // Equation 22 of Braun and Willett, with exponents 0.5 of the drained area and 1 of the slope.
        const float soft = softness[std::size_t(cell)], share = rivers.cutting * soft * std::sqrt(m_drained[std::size_t(cell)] + rivers.hillside) / far;
        metres = (metres + share * below) / (1 + share);
        metres = std::clamp(metres, below + least, below + steepest * far / soft); // hollows silt up
    }
}

} // namespace editor
