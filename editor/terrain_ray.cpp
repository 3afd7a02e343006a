#include "editor/terrain_ray.h"

#include "io/base/contract.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>

namespace editor {
namespace {

constexpr int kLeaf = 4;        // cells along the side of a leaf
constexpr int kNode = 2 * kLeaf; // and of a node of the finest level
constexpr glm::vec2 kNothing{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
constexpr double kSlack = 1e-9; // of a cell: edges belong to both triangles, so that no ray slips between them

glm::vec2 joined(const glm::vec2& a, const glm::vec2& b)
{
    return {std::min(a.x, b.x), std::max(a.y, b.y)};
}

} // namespace

// A ray in texels (x, z) and metres (y), so that a cell is a unit square. The parameter stays metres along the ray.
struct TerrainRay::Query {
    glm::dvec3 origin, direction, inverse;
    double nearest;      // m, of the best hit so far
    glm::dvec3 slope{0}; // of that hit's triangle: dy/dx, -, dy/dz per texel
    bool found = false;

    // Where the ray is inside a box, as [enter, leave]; enter > leave when it misses.
    glm::dvec2 slab(const glm::dvec3& low, const glm::dvec3& high) const
    {
        double enter = 0, leave = nearest;
        for (int axis = 0; axis < 3; ++axis) {
            if (direction[axis] == 0) {
                if (origin[axis] < low[axis] || origin[axis] > high[axis]) return {1, 0};
                continue;
            }
            const double a = (low[axis] - origin[axis]) * inverse[axis];
            const double b = (high[axis] - origin[axis]) * inverse[axis];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return {enter, leave};
    }

    // Whether the ray meets the box over a square of `side` cells.
    bool meets(const glm::ivec2& square, double side, const glm::dvec2& range) const
    {
        const double slack = 1e-6 * std::max({1.0, std::abs(origin.x), std::abs(origin.z), std::abs(origin.y)});
        const glm::dvec2 through = slab({square.x * side - slack, range.x - slack, square.y * side - slack},
                                        {(square.x + 1) * side + slack, range.y + slack, (square.y + 1) * side + slack});
        return through.x <= through.y;
    }

    // The plane y = height + dx * u + dz * v over one triangle of the cell; `lower` is the one with u + v <= 1.
    void triangle(glm::ivec2 cell, bool lower, double height, double dx, double dz)
    {
        const double fall = direction.y - dx * direction.x - dz * direction.z;
        if (fall >= 0) return; // parallel, or from below
        const double u0 = origin.x - cell.x;
        const double v0 = origin.z - cell.y;
        const double t = (height + dx * u0 + dz * v0 - origin.y) / fall;
        if (!(t >= 0 && t < nearest)) return;
        const double u = u0 + t * direction.x;
        const double v = v0 + t * direction.z;
        const double slack = kSlack * std::max({1.0, std::abs(u0), std::abs(v0)});
        if (u < -slack || v < -slack || u > 1 + slack || v > 1 + slack) return;
        if (lower ? u + v > 1 + slack : u + v < 1 - slack) return;
        nearest = t;
        slope = {dx, 0, dz};
        found = true;
    }
};

TerrainRay::TerrainRay(std::shared_ptr<const io::HeightMap> heights) : m_heights{std::move(heights)}
{
    if (!m_heights || m_heights->size.x < 2 || m_heights->size.y < 2) {
        m_heights.reset();
        return;
    }
    glm::ivec2 nodes = (m_heights->size - 1 + kNode - 1) / kNode;
    m_leaves.resize(std::size_t(nodes.x) * nodes.y);
    for (;; nodes = (nodes + 1) / 2) {
        m_levels.push_back({.size = nodes, .range = std::vector<glm::vec2>(std::size_t(nodes.x) * nodes.y)});
        build(m_levels.size() - 1, {0, 0}, nodes);
        if (nodes == glm::ivec2{1}) break;
    }
}

void TerrainRay::update(std::shared_ptr<const io::HeightMap> heights, const io::TexelRect& changed)
{
    EXPECTS(m_heights && heights && heights->size == m_heights->size);
    m_heights = std::move(heights);
    // A texel is a corner of the four cells around it.
    glm::ivec2 low = glm::max(glm::ivec2{changed.low} - 1, glm::ivec2{0}) / kNode, high = (glm::ivec2{changed.high} - 1) / kNode + 1;
    for (std::size_t level = 0; level < m_levels.size(); ++level, low /= 2, high = (high + 1) / 2)
        build(level, low, glm::min(high, m_levels[level].size));
}

void TerrainRay::build(std::size_t level, const glm::ivec2& low, const glm::ivec2& high)
{
    if (level > 0) return join(m_levels[level - 1], m_levels[level], low, high);
    constexpr int kWorthAThread = 1 << 16; // nodes
    const int rows = high.y - low.y, middle = low.y + rows / 2;
    if (rows < 2 || std::int64_t(rows) * (high.x - low.x) < kWorthAThread) return buildFinest(low, high);
    const auto upper = std::async(std::launch::async, [&] { buildFinest(low, {high.x, middle}); });
    buildFinest({low.x, middle}, high);
}

void TerrainRay::join(const Level& below, Level& level, const glm::ivec2& low, const glm::ivec2& high)
{
    for (int z = low.y; z < high.y; ++z)
        for (int x = low.x; x < high.x; ++x) {
            const glm::ivec2 last = glm::min(glm::ivec2{x, z} * 2 + 1, below.size - 1);
            glm::vec2 range = kNothing;
            for (int row = z * 2; row <= last.y; ++row)
                for (int column = x * 2; column <= last.x; ++column)
                    range = joined(range, below.range[std::size_t(row) * below.size.x + column]);
            level.range[std::size_t(z) * level.size.x + x] = range;
        }
}

void TerrainRay::buildFinest(const glm::ivec2& low, const glm::ivec2& high)
{
    Level& level = m_levels.front();
    for (int z = low.y; z < high.y; ++z) {
        const std::array rows{rangesOfLeaves(z * 2, low.x * 2, high.x * 2), rangesOfLeaves(z * 2 + 1, low.x * 2, high.x * 2)};
        for (int x = low.x; x < high.x; ++x) {
            const std::size_t at = std::size_t(z) * level.size.x + x, first = std::size_t(x - low.x) * 2;
            const std::array leaves{rows[0][first], rows[0][first + 1], rows[1][first], rows[1][first + 1]};
            level.range[at] = joined(joined(leaves[0], leaves[1]), joined(leaves[2], leaves[3]));
            for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
                m_leaves[at].set(leaf, leaves[leaf], level.range[at]);
        }
    }
}

// The leaves `low` to `high` of a row of them, nothing for those beyond the map: first the lowest and highest of their rows of
// texels at each x, then of the texels of each leaf.
std::vector<glm::vec2> TerrainRay::rangesOfLeaves(int row, int low, int high) const
{
    std::vector<glm::vec2> ranges(std::size_t(high - low), kNothing);
    const glm::ivec2 size = m_heights->size;
    if (row * kLeaf >= size.y - 1) return ranges;
    const int first = low * kLeaf, end = std::min(high * kLeaf, size.x - 1) + 1;
    std::vector<float> lowest(std::size_t(end - first), kNothing.x), highest(lowest.size(), kNothing.y);
    for (int z = row * kLeaf; z <= std::min((row + 1) * kLeaf, size.y - 1); ++z) {
        float *l = lowest.data(), *h = highest.data();
        m_heights->field().eachRun({{first, z}, {end, z + 1}}, [&](const float* run, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
                l[i] = std::min(l[i], run[i]);
                h[i] = std::max(h[i], run[i]);
            }
            l += count;
            h += count;
        });
    }
    for (int x = low; x < high && x * kLeaf < size.x - 1; ++x)
        for (int i = x * kLeaf; i <= std::min((x + 1) * kLeaf, size.x - 1); ++i)
            ranges[std::size_t(x - low)] = joined(ranges[std::size_t(x - low)], {lowest[std::size_t(i - first)], highest[std::size_t(i - first)]});
    return ranges;
}

void TerrainRay::Leaves::set(std::size_t leaf, const glm::vec2& leafRange, const glm::vec2& node)
{
    const double step = (double(node.y) - node.x) / 255;
    const auto steps = [&](double metres) { return step > 0 ? std::uint8_t(std::clamp(metres / step, 0.0, 255.0)) : std::uint8_t(0); };
    aboveLowest[leaf] = steps(double(leafRange.x) - node.x);
    belowHighest[leaf] = steps(double(node.y) - leafRange.y);
    if (aboveLowest[leaf] > 0 && range(leaf, node).x > leafRange.x) --aboveLowest[leaf]; // where the quotient was rounded up
    if (belowHighest[leaf] > 0 && range(leaf, node).y < leafRange.y) --belowHighest[leaf];
}

glm::dvec2 TerrainRay::Leaves::range(std::size_t leaf, const glm::vec2& node) const
{
    const double step = (double(node.y) - node.x) / 255;
    return {node.x + aboveLowest[leaf] * step, node.y - belowHighest[leaf] * step};
}

std::optional<io::TerrainHit> TerrainRay::hit(const io::Ray& ray, double maxDistance) const
{
    if (!m_heights) return std::nullopt;
    const double texel = m_heights->metresPerTexel;
    const glm::dvec2 origin = (glm::dvec2{ray.origin.x, ray.origin.z} - m_heights->origin) / texel;
    Query query{.origin = {origin.x, ray.origin.y, origin.y},
                .direction = {ray.direction.x / texel, ray.direction.y, ray.direction.z / texel},
                .nearest = maxDistance};
    query.inverse = 1.0 / query.direction;
    if (!std::isfinite(glm::dot(query.origin, query.origin)) ||
        !std::isfinite(glm::dot(query.direction, query.direction)))
        return std::nullopt;
    descend(query, int(m_levels.size()) - 1, {0, 0});
    if (!query.found) return std::nullopt;
    return io::TerrainHit{.distance = query.nearest,
                          .position = ray.origin + ray.direction * query.nearest,
                          .normal = glm::normalize(glm::dvec3{-query.slope.x / texel, 1, -query.slope.z / texel})};
}

void TerrainRay::descend(Query& query, int level, glm::ivec2 node) const
{
    const std::size_t at = std::size_t(node.y) * m_levels[level].size.x + node.x;
    const glm::vec2 range = m_levels[level].range[at];
    if (!query.meets(node, double(kNode << level), range)) return;

    // Near children first, so that the far ones end at their box.
    const int nearX = query.direction.x < 0 ? 1 : 0;
    const int nearZ = query.direction.z < 0 ? 1 : 0;
    for (const glm::ivec2 step : {glm::ivec2{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        const glm::ivec2 own = step ^ glm::ivec2{nearX, nearZ}, child = node * 2 + own;
        if (level > 0) {
            if (child.x < m_levels[level - 1].size.x && child.y < m_levels[level - 1].size.y) descend(query, level - 1, child);
        } else if (child.x * kLeaf < m_heights->size.x - 1 && child.y * kLeaf < m_heights->size.y - 1 &&
                   query.meets(child, kLeaf, m_leaves[at].range(std::size_t(own.y * 2 + own.x), range))) {
            leaf(query, child);
        }
    }
}

void TerrainRay::leaf(Query& query, glm::ivec2 node) const
{
    const io::HeightMap& map = *m_heights;
    const glm::ivec2 last = glm::min((node + 1) * kLeaf, map.size - 1);
    for (int z = node.y * kLeaf; z < last.y; ++z) {
        for (int x = node.x * kLeaf; x < last.x; ++x) {
            if (m_cover && (m_cover->at(x, z) & io::kHoleBit)) continue;
            const double h00 = map.at(x, z), h10 = map.at(x + 1, z), h01 = map.at(x, z + 1), h11 = map.at(x + 1, z + 1);
            query.triangle({x, z}, true, h00, h10 - h00, h01 - h00);
            query.triangle({x, z}, false, h10 + h01 - h11, h11 - h01, h11 - h10);
        }
    }
}

} // namespace editor
