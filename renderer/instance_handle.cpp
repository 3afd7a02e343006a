#include "renderer/instance_handle.h"

#include <fmt/format.h>

namespace renderer {

const char* nameOf(io::DrawPath path)
{
    return path == io::DrawPath::Direct ? "direct" : "batched";
}

InstanceHandle InstanceHandles::give(InstancePlace place)
{
    std::uint32_t slot = std::uint32_t(m_slots.size());
    if (m_free.empty()) {
        m_slots.emplace_back();
    } else {
        slot = m_free.back();
        m_free.pop_back();
    }
    m_slots[slot].place = place;
    return {.slot = slot, .generation = m_slots[slot].generation, .direct = m_path == io::DrawPath::Direct};
}

const InstancePlace* InstanceHandles::peek(InstanceHandle handle) const
{
    const bool ours = handle.path() == m_path && handle.slot < m_slots.size();
    return ours && m_slots[handle.slot].generation == handle.generation ? &m_slots[handle.slot].place : nullptr;
}

io::Result<InstancePlace> InstanceHandles::find(InstanceHandle handle) const
{
    if (const InstancePlace* place = peek(handle)) return *place;
    const std::string where = fmt::format("instance {} of the {} path", handle.slot, nameOf(handle.path()));
    if (handle.generation == 0) return io::Error{where, "this handle was never given out; add an instance first"};
    if (handle.path() != m_path)
        return io::Error{where, fmt::format("the {} path was asked for it; ask the path that gave the handle out", nameOf(m_path))};
    return io::Error{where, "this handle is stale: what it stood for was removed"};
}

void InstanceHandles::free(std::uint32_t slot)
{
    constexpr std::uint32_t kMost = 0x7fffffffu;
    Slot& freed = m_slots[slot];
    freed.generation = freed.generation == kMost ? 1 : freed.generation + 1;
    m_free.push_back(slot);
}

} // namespace renderer
