// InstanceIds: numbers for the instances of a scene, beyond those of objects, so that pictures of ids, rays and selections can
// hold both. A tile of a layer has a block of them, its instances in their order.
#pragma once

#include "io/scene/instances.h"

#include <optional>

namespace io {

class InstanceIds {
public:
    // The tile holds so many instances from now on. Its block stays while they fit.
    void set(const LayerTile& tile, std::size_t count);
    ObjectId first(const LayerTile& tile) const; // None: it holds nothing
    std::optional<InstanceRef> find(ObjectId id) const;

private:
    static constexpr int kSmallest = 5, kLargest = 27; // blocks of 2^n
    struct Block {
        LayerTile tile;
        int size = kSmallest; // power of two
        std::size_t count = 0;
    };
    std::uint32_t take(int size);

    std::map<std::uint32_t, Block> m_blocks; // by first id
    std::map<LayerTile, std::uint32_t> m_firstOf;
    std::array<std::vector<std::uint32_t>, kLargest + 1> m_free;
    std::uint32_t m_next = kFirstInstanceId;
};

} // namespace io
