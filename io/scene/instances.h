// Instances of a scatter layer: copies of templates that are too many to be objects. They lie in square tiles of the world,
// which the versions of a scene have in common, so that a change costs the tiles that it touches.
#pragma once

#include "io/scene/ids.h"
#include "io/scene/transform.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace io {

constexpr int kInstanceTile = 64;            // m, a tile's side
constexpr double kInstanceStep = 1.0 / 1024; // m, in which places are held: a tile is 65536 of them
constexpr std::uint8_t kPaintedInstance = 1; // flag: put there by a person, so rules leave it alone

struct Instance {
    std::uint16_t x = 0, z = 0;            // steps from the tile's low corner
    std::int32_t y = 0;                    // steps above 0
    std::array<std::int16_t, 3> rotation{}; // about x, y, z as in io::Transform, in 65536ths of a turn
    std::uint8_t species = 0;              // of its layer's list
    std::uint8_t flags = 0;
    float scale = 1;                       // factor, along all axes
    bool operator==(const Instance&) const = default;
};
static_assert(sizeof(Instance) == 20);

struct InstanceTile {
    std::vector<Instance> instances;
    // Squares of a metre from which a person erased, so that rules plant nothing there again: bit x of row z; empty: none.
    std::vector<std::uint64_t> erased;

    bool empty() const { return instances.empty() && erased.empty(); }
    std::size_t bytes() const
    {
        return sizeof *this + instances.capacity() * sizeof(Instance) + erased.capacity() * sizeof(std::uint64_t);
    }
    bool operator==(const InstanceTile&) const = default;
};

struct TileOrder {
    bool operator()(const glm::ivec2& a, const glm::ivec2& b) const { return std::tie(a.y, a.x) < std::tie(b.y, b.x); }
};
using InstanceTiles = std::map<glm::ivec2, std::shared_ptr<const InstanceTile>, TileOrder>; // x and z; none of them empty

// A tile of a layer, and an instance in it. The index holds until the tile changes.
struct LayerTile {
    ScatterId layer = ScatterId::None;
    glm::ivec2 tile{0};
    bool operator==(const LayerTile&) const = default;
    bool operator<(const LayerTile& other) const
    {
        return std::tie(layer, tile.y, tile.x) < std::tie(other.layer, other.tile.y, other.tile.x);
    }
};
struct InstanceRef {
    LayerTile at;
    std::uint32_t index = 0;
    bool operator==(const InstanceRef&) const = default;
    bool operator<(const InstanceRef& other) const { return at == other.at ? index < other.index : at < other.at; }
};

struct PlacedInstance {
    glm::ivec2 tile{0};
    Instance instance;
};

// The nearest instance to such a transform: to half a step, a 130000th of a turn, and as large as the transform is along x.
PlacedInstance instanceAt(const Transform& transform, int species, std::uint8_t flags = 0);
Transform transformOf(glm::ivec2 tile, const Instance& instance);
glm::ivec2 instanceTileAt(const glm::dvec3& position);

bool isErased(const InstanceTile& tile, const Instance& instance);
void markErased(InstanceTile& tile, const Instance& instance); // the square that it stands in
void markErased(InstanceTile& tile, glm::ivec2 square);        // of the tile, 0..63
void unmarkErased(InstanceTile& tile, glm::ivec2 square);

std::size_t instanceCount(const InstanceTiles& tiles);
bool sameInstances(const InstanceTiles& a, const InstanceTiles& b);
std::uint64_t instanceHash(const InstanceTiles& tiles); // of all there is to know of them

} // namespace io
