#include "io/scene/instances.h"

#include "io/base/content_hash.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace io {
namespace {

constexpr double kStepsOfTile = kInstanceTile / kInstanceStep;
constexpr double kTurn = 360.0 / 65536; // degrees

std::int64_t stepsOf(double metres)
{
    return std::llround(metres / kInstanceStep);
}

glm::ivec2 squareOf(const Instance& instance)
{
    constexpr int kStepsOfSquare = int(1 / kInstanceStep);
    return {instance.x / kStepsOfSquare, instance.z / kStepsOfSquare};
}

} // namespace

PlacedInstance instanceAt(const Transform& transform, int species, std::uint8_t flags)
{
    const auto x = stepsOf(transform.position.x), z = stepsOf(transform.position.z);
    static_assert(kStepsOfTile == 65536);
    PlacedInstance placed{.tile = {int(x >> 16), int(z >> 16)}};
    Instance& instance = placed.instance;
    instance.x = std::uint16_t(x & 0xffff);
    instance.z = std::uint16_t(z & 0xffff);
    constexpr double kHighest = 0x7fffffff;
    instance.y = std::int32_t(std::clamp(std::round(transform.position.y / kInstanceStep), -kHighest, kHighest));
    for (std::size_t axis = 0; axis < 3; ++axis)
        instance.rotation[axis] = std::int16_t(std::llround(std::fmod(double(transform.rotation[int(axis)]), 360.0) / kTurn) & 0xffff);
    instance.species = std::uint8_t(species);
    instance.flags = flags;
    instance.scale = transform.scale.x;
    return placed;
}

Transform transformOf(glm::ivec2 tile, const Instance& instance)
{
    Transform transform;
    transform.position = {double(tile.x) * kInstanceTile + instance.x * kInstanceStep, instance.y * kInstanceStep,
                          double(tile.y) * kInstanceTile + instance.z * kInstanceStep};
    for (std::size_t axis = 0; axis < 3; ++axis)
        transform.rotation[int(axis)] = float(instance.rotation[axis] * kTurn);
    transform.scale = glm::vec3{instance.scale};
    return transform;
}

glm::ivec2 instanceTileAt(const glm::dvec3& position)
{
    return {int(stepsOf(position.x) >> 16), int(stepsOf(position.z) >> 16)};
}

bool isErased(const InstanceTile& tile, const Instance& instance)
{
    const glm::ivec2 square = squareOf(instance);
    return !tile.erased.empty() && (tile.erased[std::size_t(square.y)] >> square.x & 1) != 0;
}

void markErased(InstanceTile& tile, const Instance& instance)
{
    markErased(tile, squareOf(instance));
}

void markErased(InstanceTile& tile, glm::ivec2 square)
{
    tile.erased.resize(kInstanceTile);
    tile.erased[std::size_t(square.y)] |= std::uint64_t(1) << square.x;
}

void unmarkErased(InstanceTile& tile, glm::ivec2 square)
{
    if (tile.erased.empty()) return;
    tile.erased[std::size_t(square.y)] &= ~(std::uint64_t(1) << square.x);
    if (std::ranges::all_of(tile.erased, [](std::uint64_t row) { return row == 0; })) tile.erased.clear();
}

std::size_t instanceCount(const InstanceTiles& tiles)
{
    return std::accumulate(tiles.begin(), tiles.end(), std::size_t(0),
                           [](std::size_t sum, const auto& entry) { return sum + entry.second->instances.size(); });
}

bool sameInstances(const InstanceTiles& a, const InstanceTiles& b)
{
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) {
        return x.first == y.first && (x.second == y.second || *x.second == *y.second);
    });
}

std::uint64_t instanceHash(const InstanceTiles& tiles)
{
    ContentHash hash;
    for (const auto& [place, tile] : tiles) {
        hash.add(place.x);
        hash.add(place.y);
        hash.add(tile->instances);
        hash.add(tile->erased);
    }
    return hash.key()[0];
}

} // namespace io
