// What stands for one placed copy of a model, wherever its meshes live: eight bytes, checked at every use.
#pragma once

#include "io/base/result.h"
#include "io/scene/template.h"

#include <cstdint>
#include <vector>

namespace renderer {

struct InstanceHandle {
    std::uint32_t slot = 0;
    std::uint32_t generation : 31 = 0; // of the slot; 0: nobody
    std::uint32_t direct : 1 = 0;

    io::DrawPath path() const { return direct ? io::DrawPath::Direct : io::DrawPath::Batched; }
    bool operator==(const InstanceHandle&) const = default;
};
static_assert(sizeof(InstanceHandle) == 8);

struct InstancePlace {
    std::uint32_t set = 0; // of those of its path
    std::uint32_t row = 0; // in that set, another one as soon as a row before it goes
};

// The handles of one path. A slot is used again, with another generation, so that a handle of what is gone is known.
class InstanceHandles {
public:
    explicit InstanceHandles(io::DrawPath path) : m_path{path} {}

    InstanceHandle give(InstancePlace place);
    io::Result<InstancePlace> find(InstanceHandle handle) const;
    const InstancePlace* peek(InstanceHandle handle) const; // null where find() would give an error
    void moved(std::uint32_t slot, InstancePlace place) { m_slots[slot].place = place; }
    void free(std::uint32_t slot);

private:
    struct Slot {
        InstancePlace place;
        std::uint32_t generation = 1;
    };
    io::DrawPath m_path;
    std::vector<Slot> m_slots;
    std::vector<std::uint32_t> m_free;
};

const char* nameOf(io::DrawPath path);

} // namespace renderer
