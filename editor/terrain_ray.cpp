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
constexpr double kSlack = 1e-9; // of a cell: edges belong to both triangles, so that no ray slips between them

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
    glm::ivec2 nodes = (m_heights->size - 1 + kLeaf - 1) / kLeaf;
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
    glm::ivec2 low = glm::max(glm::ivec2{changed.low} - 1, glm::ivec2{0}) / kLeaf, high = (glm::ivec2{changed.high} - 1) / kLeaf + 1;
    for (std::size_t level = 0; level < m_levels.size(); ++level, low /= 2, high = (high + 1) / 2)
        build(level, low, glm::min(high, m_levels[level].size));
}

void TerrainRay::build(std::size_t level, const glm::ivec2& low, const glm::ivec2& high)
{
    if (level > 0) return join(m_levels[level - 1], m_levels[level], low, high);
    constexpr int kWorthAThread = 1 << 18; // leaves
    const int rows = high.y - low.y, middle = low.y + rows / 2;
    if (rows < 2 || std::int64_t(rows) * (high.x - low.x) < kWorthAThread) return buildLeaves(low, high);
    const auto upper = std::async(std::launch::async, [&] { buildLeaves(low, {high.x, middle}); });
    buildLeaves({low.x, middle}, high);
}

void TerrainRay::join(const Level& below, Level& level, const glm::ivec2& low, const glm::ivec2& high)
{
    for (int z = low.y; z < high.y; ++z)
        for (int x = low.x; x < high.x; ++x) {
            const glm::ivec2 last = glm::min(glm::ivec2{x, z} * 2 + 1, below.size - 1);
            glm::vec2 range = below.range[std::size_t(z) * 2 * below.size.x + x * 2];
            for (int row = z * 2; row <= last.y; ++row)
                for (int column = x * 2; column <= last.x; ++column) {
                    const glm::vec2 part = below.range[std::size_t(row) * below.size.x + column];
                    range = {std::min(range.x, part.x), std::max(range.y, part.y)};
                }
            level.range[std::size_t(z) * level.size.x + x] = range;
        }
}

// A row of leaves at a time: the lowest and highest of its rows of texels at each x, then of the texels of each leaf.
void TerrainRay::buildLeaves(const glm::ivec2& low, const glm::ivec2& high)
{
    Level& leaves = m_levels.front();
    const int first = low.x * kLeaf, end = std::min(high.x * kLeaf, m_heights->size.x - 1) + 1;
    std::vector<float> lowest(std::size_t(end - first)), highest = lowest;
    for (int z = low.y; z < high.y; ++z) {
        std::ranges::fill(lowest, std::numeric_limits<float>::infinity());
        std::ranges::fill(highest, -std::numeric_limits<float>::infinity());
        const int last = std::min((z + 1) * kLeaf, m_heights->size.y - 1);
        for (int row = z * kLeaf; row <= last; ++row) {
            float *l = lowest.data(), *h = highest.data();
            m_heights->field().eachRun({{first, row}, {end, row + 1}}, [&](const float* run, std::size_t count) {
                for (std::size_t i = 0; i < count; ++i) {
                    l[i] = std::min(l[i], run[i]);
                    h[i] = std::max(h[i], run[i]);
                }
                l += count;
                h += count;
            });
        }
        for (int x = low.x; x < high.x; ++x) {
            const int from = x * kLeaf - first, to = std::min(from + kLeaf, end - 1 - first);
            glm::vec2 range{lowest[std::size_t(from)], highest[std::size_t(from)]};
            for (int i = from + 1; i <= to; ++i)
                range = {std::min(range.x, lowest[std::size_t(i)]), std::max(range.y, highest[std::size_t(i)])};
            leaves.range[std::size_t(z) * leaves.size.x + x] = range;
        }
    }
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
    const glm::vec2 range = m_levels[level].range[std::size_t(node.y) * m_levels[level].size.x + node.x];
    const double side = double(kLeaf << level);
    const double slack =
        1e-6 * std::max({1.0, std::abs(query.origin.x), std::abs(query.origin.z), std::abs(query.origin.y)});
    const glm::dvec2 through = query.slab({node.x * side - slack, range.x - slack, node.y * side - slack},
                                          {(node.x + 1) * side + slack, range.y + slack, (node.y + 1) * side + slack});
    if (through.x > through.y) return;
    if (level == 0) return leaf(query, node);

    // Near children first, so that the far ones end at their box.
    const int nearX = query.direction.x < 0 ? 1 : 0;
    const int nearZ = query.direction.z < 0 ? 1 : 0;
    for (const glm::ivec2 step : {glm::ivec2{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        const glm::ivec2 child = node * 2 + (step ^ glm::ivec2{nearX, nearZ});
        if (child.x < m_levels[level - 1].size.x && child.y < m_levels[level - 1].size.y)
            descend(query, level - 1, child);
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
