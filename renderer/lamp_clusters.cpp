#include "renderer/lamp_clusters.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr double kFirstDepth = 1; // m, end of the first slice at the least
constexpr glm::ivec2 kTiles{LAMP_TILES_X, LAMP_TILES_Y};

struct Range {
    int first = 0, last = -1;
};

// Slices grow by one factor; the first begins at the eye, the last has no end.
class Slices {
public:
    Slices(double first, double last) : m_first{first}
    {
        m_scale = (LAMP_SLICES - 2) / std::log2(std::max(last / first, 1.01));
    }
    double begin(int slice) const { return slice == 0 ? kNear : m_first * std::exp2((slice - 1) / m_scale); }
    double end(int slice, double farthest) const { return slice + 1 == LAMP_SLICES ? std::max(farthest, begin(slice)) : begin(slice + 1); }
    int of(double depth) const { return std::clamp(int(std::floor(std::log2(std::max(depth, kNear)) * scale() + bias())), 0, LAMP_SLICES - 1); }
    double scale() const { return m_scale; }
    double bias() const { return 1 - std::log2(m_first) * m_scale; }

private:
    double m_first, m_scale;
};

// Tiles along one axis that values from `low` to `high` at depths of `near` to `far` can lie in.
Range tilesOf(double low, double high, double near, double far, double tanHalf, int tiles)
{
    const double least = low / ((low < 0 ? near : far) * tanHalf);
    const double most = high / ((high > 0 ? near : far) * tanHalf);
    if (most < -1 || least > 1) return {};
    const auto tile = [&](double ndc) { return std::clamp(int(std::floor((ndc * 0.5 + 0.5) * tiles)), 0, tiles - 1); };
    return {tile(least), tile(most)};
}

// Whether a cone reaches a sphere: Wronski, "Cull that cone" (2017).
bool coneReaches(const glm::dvec3& direction, double outer, double range, const glm::dvec3& centre, double radius)
{
    const double along = glm::dot(centre, direction);
    const double across = std::sqrt(std::max(glm::dot(centre, centre) - along * along, 0.0));
    return std::cos(outer) * across - along * std::sin(outer) <= radius && along <= range + radius && along >= -radius;
}

struct Corners {
    glm::dvec3 low, high;
};

Corners clusterBox(glm::ivec2 tile, double near, double far, const glm::dvec2& tanHalf)
{
    Corners box{.low = {1e30, 1e30, near}, .high = {-1e30, -1e30, far}};
    for (const double depth : {near, far})
        for (int corner = 0; corner < 2; ++corner) {
            const glm::dvec2 at = (glm::dvec2{tile + corner} / glm::dvec2{kTiles} * 2.0 - 1.0) * tanHalf * depth;
            box.low = {glm::min(glm::dvec2{box.low}, at), near};
            box.high = {glm::max(glm::dvec2{box.high}, at), far};
        }
    return box;
}

bool reaches(const Lamp& lamp, const glm::dvec3& place, const glm::dvec3& direction, const Corners& box)
{
    const glm::dvec3 nearest = glm::clamp(place, box.low, box.high) - place;
    if (glm::dot(nearest, nearest) > double(lamp.range) * lamp.range) return false;
    if (!lamp.isSpot()) return true;
    const glm::dvec3 half = (box.high - box.low) * 0.5;
    return coneReaches(direction, lamp.outer, lamp.range, box.low + half - place, glm::length(half));
}

} // namespace

LampClusters clustersOf(std::span<const Lamp> lamps, const Eye& eye)
{
    const auto viewOf = [&](const glm::dvec3& v) {
        return glm::dvec3{glm::dot(v, eye.right), glm::dot(v, eye.up), glm::dot(v, eye.forward)};
    };
    const glm::dvec2 tanHalf{eye.tanHalfFov * eye.aspect, eye.tanHalfFov};
    double first = 1e30, last = 2 * kFirstDepth;
    for (const Lamp& lamp : lamps) {
        const double depth = viewOf(lamp.place - eye.position).z;
        first = std::min(first, depth - lamp.range);
        last = std::max(last, depth + lamp.range);
    }
    const Slices slices{std::clamp(first, kFirstDepth, last * 0.9), last};

    std::vector<std::pair<std::uint32_t, std::uint32_t>> found; // cluster, lamp
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const Lamp& lamp = lamps[i];
        const glm::dvec3 place = viewOf(lamp.place - eye.position), direction = viewOf(glm::dvec3{lamp.direction});
        const double range = lamp.range;
        for (int slice = slices.of(place.z - range); slice <= slices.of(place.z + range); ++slice) {
            const double begin = slices.begin(slice), end = slices.end(slice, last);
            const double near = std::max(begin, place.z - range), far = std::max(std::min(end, place.z + range), near);
            const double apart = std::max({begin - place.z, place.z - end, 0.0});
            const double radius = std::sqrt(std::max(range * range - apart * apart, 0.0)); // of the sphere's part in the slice
            const Range x = tilesOf(place.x - radius, place.x + radius, near, far, tanHalf.x, kTiles.x);
            const Range y = tilesOf(place.y - radius, place.y + radius, near, far, tanHalf.y, kTiles.y);
            for (int row = y.first; row <= y.last; ++row)
                for (int column = x.first; column <= x.last; ++column)
                    if (reaches(lamp, place, direction, clusterBox({column, row}, begin, end, tanHalf)))
                        found.emplace_back((slice * kTiles.y + row) * kTiles.x + column, i);
        }
    }

    LampClusters clusters{.sliceScale = float(slices.scale()), .sliceBias = float(slices.bias())};
    clusters.lists.resize(2 * LAMP_CLUSTERS + found.size());
    for (const auto& [cluster, lamp] : found)
        ++clusters.lists[2 * cluster + 1];
    std::uint32_t begin = 2 * LAMP_CLUSTERS;
    for (std::size_t cluster = 0; cluster < LAMP_CLUSTERS; ++cluster) {
        clusters.lists[2 * cluster] = begin;
        begin += clusters.lists[2 * cluster + 1];
    }
    std::vector<std::uint32_t> next(LAMP_CLUSTERS);
    for (std::size_t cluster = 0; cluster < LAMP_CLUSTERS; ++cluster)
        next[cluster] = clusters.lists[2 * cluster];
    for (const auto& [cluster, lamp] : found)
        clusters.lists[next[cluster]++] = lamp;
    return clusters;
}

} // namespace renderer
