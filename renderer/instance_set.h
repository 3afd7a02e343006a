// Placed copies of the models of one library: dense rows that are culled, drawn and uploaded together, each upload at
// the price of what changed.
#pragma once

#include "io/scene/scene_tree.h"
#include "renderer/cull.h"
#include "renderer/draw_list.h"
#include "renderer/gpu_culling.h"

#include <iterator>
#include <optional>
#include <span>
#include <vector>

namespace renderer {

class InstanceSet {
public:
    std::size_t size() const { return m_records.size(); }
    const glsl::CullRecord& cullRecord(std::uint32_t row) const { return m_cullRecords[row]; }
    const glsl::Instance& record(std::uint32_t row) const { return m_records[row]; }
    std::span<const std::uint32_t> slots() const { return m_slots; } // of the handles, by row
    const InstanceTree& tree() const { return m_tree; }

    std::uint32_t add(std::uint32_t slot); // answers the row, still to be set
    void set(std::uint32_t row, const glsl::Instance& record, const glsl::CullRecord& cullRecord); // keeps the flags
    void setFlags(std::uint32_t row, std::uint32_t flags);
    std::optional<std::uint32_t> remove(std::uint32_t row); // the slot of the one that stands there now
    void clear();

    // Until settle() rows are added without being found by views: for many at once.
    void grow() { m_growing = true; }
    void settle();

    struct Wanted { // on the GPU
        bool records = false, spheres = false;
    };
    std::uint64_t upload(Wanted wanted); // what changed since the last call; answers the bytes
    GpuCullScene gpuScene() const { return {m_recordBuffer.id(), m_cullBuffer.id(), m_records.size()}; }

    struct View {
        const ModelLibrary& models;
        const CullRequest& request;
        bool blended = true; // blended parts too
        bool apart = false;  // each of them in a range of its own
        bool direct = false; // by calls of their own, from the records on the GPU where they will do
    };
    DrawList draws(GpuStream& stream, const View& view) const;

private:
    // By row, all the same length.
    std::vector<glsl::Instance> m_records;
    std::vector<glsl::CullRecord> m_cullRecords;
    std::vector<std::uint32_t> m_slots;

    InstanceTree m_tree; // of rows
    bool m_growing = false;
    std::vector<std::uint32_t> m_dirty; // rows, perhaps more than once
    gl::Buffer m_recordBuffer, m_cullBuffer;
    bool m_onGpu = false; // the buffers hold what was there at the last upload
    mutable std::vector<Seen> m_seen; // kept between frames for its memory
};

io::WorldBox boxOf(const glsl::CullRecord& record); // in any wind

} // namespace renderer
