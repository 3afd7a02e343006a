#include "io/scene/instance_ids.h"

#include "io/base/contract.h"

#include <algorithm>
#include <bit>

namespace io {

void InstanceIds::set(const LayerTile& tile, std::size_t count)
{
    const auto known = m_firstOf.find(tile);
    if (known != m_firstOf.end()) {
        const auto block = m_blocks.find(known->second);
        if (count > 0 && count <= std::size_t(1) << block->second.size) {
            block->second.count = count;
            return;
        }
        m_free[std::size_t(block->second.size)].push_back(block->first);
        m_blocks.erase(block);
        m_firstOf.erase(known);
    }
    if (count == 0) return;
    const int size = std::max(kSmallest, int(std::bit_width(count - 1)));
    const std::uint32_t first = take(size);
    m_blocks[first] = {tile, size, count};
    m_firstOf[tile] = first;
}

std::uint32_t InstanceIds::take(int size)
{
    EXPECTS(size <= kLargest);
    for (int larger = size; larger <= kLargest; ++larger) {
        auto& free = m_free[std::size_t(larger)];
        if (free.empty()) continue;
        const std::uint32_t first = free.back();
        free.pop_back();
        for (int half = larger - 1; half >= size; --half)
            m_free[std::size_t(half)].push_back(first + (std::uint32_t(1) << half));
        return first;
    }
    const std::uint32_t first = m_next;
    EXPECTS(kLastInstanceId - first >= std::uint32_t(1) << size);
    m_next += std::uint32_t(1) << size;
    return first;
}

ObjectId InstanceIds::first(const LayerTile& tile) const
{
    const auto known = m_firstOf.find(tile);
    return known == m_firstOf.end() ? ObjectId::None : ObjectId{known->second};
}

std::optional<InstanceRef> InstanceIds::find(ObjectId id) const
{
    auto block = m_blocks.upper_bound(number(id));
    if (block == m_blocks.begin()) return std::nullopt;
    --block;
    const std::uint32_t index = number(id) - block->first;
    if (index >= block->second.count) return std::nullopt;
    return InstanceRef{block->second.tile, index};
}

} // namespace io
