#include "io/files/height_voids.h"

#include <algorithm>

namespace io {
namespace {

constexpr int kSmoothings = 32;

struct Field {
    glm::ivec2 size;
    std::vector<float>& rows;
    float& at(int x, int z) const { return rows[std::size_t(z) * std::size_t(size.x) + std::size_t(x)]; }
};

// The mean of the neighbours that are known; NaN when there are none.
float meanAround(const Field& map, int x, int z)
{
    float sum = 0;
    int count = 0;
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
            if ((dx == 0 && dz == 0) || x + dx < 0 || z + dz < 0 || x + dx >= map.size.x || z + dz >= map.size.y)
                continue;
            const float height = map.at(x + dx, z + dz);
            if (std::isnan(height)) continue;
            sum += height;
            ++count;
        }
    }
    return count == 0 ? kVoid : sum / float(count);
}

using Texels = std::vector<glm::ivec2>;

std::vector<float> meansAround(const Field& map, const Texels& texels)
{
    std::vector<float> means;
    means.reserve(texels.size());
    for (const glm::ivec2& t : texels)
        means.push_back(meanAround(map, t.x, t.y));
    return means;
}

void set(const Field& map, const glm::ivec2& texel, float metres)
{
    map.at(texel.x, texel.y) = metres;
}

// Texels next to a void one, that are void themselves and not in line yet.
void addVoidNeighbours(const Field& map, const glm::ivec2& texel, std::vector<bool>& queued, Texels& ring)
{
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
            const glm::ivec2 t = texel + glm::ivec2{dx, dz};
            if (t.x < 0 || t.y < 0 || t.x >= map.size.x || t.y >= map.size.y || !std::isnan(map.at(t.x, t.y))) continue;
            const std::size_t index = std::size_t(t.y) * map.size.x + t.x;
            if (queued[index]) continue;
            queued[index] = true;
            ring.push_back(t);
        }
    }
}

// Grows the known ground into the voids ring by ring, then lets what was filled settle like a membrane.
std::size_t fill(const Field& map)
{
    std::vector<bool> queued(map.rows.size());
    Texels ring, filled;
    for (int z = 0; z < map.size.y; ++z)
        for (int x = 0; x < map.size.x; ++x)
            if (!std::isnan(map.at(x, z))) addVoidNeighbours(map, {x, z}, queued, ring);
    while (!ring.empty()) {
        const std::vector<float> means = meansAround(map, ring);
        for (std::size_t i = 0; i < ring.size(); ++i)
            set(map, ring[i], means[i]);
        filled.insert(filled.end(), ring.begin(), ring.end());
        Texels next;
        for (const glm::ivec2& texel : ring)
            addVoidNeighbours(map, texel, queued, next);
        ring = std::move(next);
    }
    for (int pass = 0; pass < kSmoothings; ++pass) {
        const std::vector<float> means = meansAround(map, filled);
        for (std::size_t i = 0; i < filled.size(); ++i)
            set(map, filled[i], means[i]);
    }
    return filled.size();
}

} // namespace

std::optional<std::size_t> fillVoids(glm::ivec2 size, std::vector<float>& rows)
{
    const auto isVoid = [](float height) { return std::isnan(height); };
    if (std::ranges::none_of(rows, isVoid)) return 0;
    if (std::ranges::all_of(rows, isVoid)) return std::nullopt;
    return fill({size, rows});
}

} // namespace io
