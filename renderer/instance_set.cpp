#include "renderer/instance_set.h"

#include <algorithm>
#include <numeric>

namespace renderer {
namespace {

constexpr std::uint32_t kGap = 64; // rows between two changed ones that go up together

// Writes what `rows` (in order, perhaps doubled) name of `values` into `buffer`; answers the bytes.
template <class T>
std::uint64_t writeRows(gl::Buffer& buffer, std::span<const T> values, std::span<const std::uint32_t> rows)
{
    std::uint64_t written = 0;
    for (std::size_t i = 0; i < rows.size();) {
        const std::uint32_t first = rows[i];
        std::uint32_t last = first;
        while (++i < rows.size() && rows[i] <= last + kGap)
            last = rows[i];
        const std::size_t end = std::min<std::size_t>(last + 1, values.size());
        if (first >= end) continue;
        const auto bytes = std::as_bytes(values.subspan(first, end - first));
        buffer.write(first * sizeof(T), bytes);
        written += bytes.size();
    }
    return written;
}

template <class T>
std::uint64_t writeInto(gl::Buffer& buffer, std::string_view label, const std::vector<T>& values,
                        std::span<const std::uint32_t> rows, bool all)
{
    gl::grow(buffer, label, std::max<std::size_t>(values.size(), 1) * sizeof(T), all ? 0 : buffer.bytes());
    return writeRows(buffer, std::span<const T>{values}, rows);
}

} // namespace

io::WorldBox boxOf(const glsl::CullRecord& record)
{
    const glm::dvec3 centre{record.centre};
    const double reach = double(record.radius + record.sway * WIND_MOST_REACH);
    return {centre - reach, centre + reach};
}

std::uint32_t InstanceSet::add(std::uint32_t slot)
{
    m_records.emplace_back();
    m_cullRecords.emplace_back();
    m_slots.push_back(slot);
    return std::uint32_t(m_slots.size() - 1);
}

void InstanceSet::set(std::uint32_t row, const glsl::Instance& record, const glsl::CullRecord& cullRecord)
{
    const std::uint32_t flags = m_records[row].drawn;
    m_records[row] = record;
    m_records[row].drawn = flags;
    m_cullRecords[row] = cullRecord;
    if (!m_growing) m_tree.set(row, boxOf(cullRecord));
    m_dirty.push_back(row);
}

void InstanceSet::setFlags(std::uint32_t row, std::uint32_t flags)
{
    if (m_records[row].drawn == flags) return;
    m_records[row].drawn = flags;
    m_dirty.push_back(row);
}

std::optional<std::uint32_t> InstanceSet::remove(std::uint32_t row)
{
    const auto last = std::uint32_t(m_records.size() - 1);
    std::optional<std::uint32_t> successor;
    m_tree.remove(last);
    if (row != last) { // the last one takes its place, so that the arrays stay dense
        m_records[row] = m_records[last];
        m_cullRecords[row] = m_cullRecords[last];
        m_slots[row] = m_slots[last];
        m_tree.set(row, boxOf(m_cullRecords[row]));
        m_dirty.push_back(row);
        successor = m_slots[row];
    }
    m_records.pop_back();
    m_cullRecords.pop_back();
    m_slots.pop_back();
    return successor;
}

void InstanceSet::clear()
{
    m_records.clear();
    m_cullRecords.clear();
    m_slots.clear();
    m_tree.clear();
    m_dirty.clear();
    m_onGpu = false;
}

void InstanceSet::settle()
{
    m_growing = false;
    std::vector<std::uint32_t> rows(m_records.size());
    std::iota(rows.begin(), rows.end(), 0u);
    m_tree.build(rows, [&](std::uint32_t row) { return boxOf(m_cullRecords[row]); });
}

std::uint64_t InstanceSet::upload(Wanted wanted)
{
    if (!wanted.records && !wanted.spheres) { // views copy what they draw
        m_dirty.clear();
        m_onGpu = false;
        return 0;
    }
    const bool all = !std::exchange(m_onGpu, true);
    if (all) {
        m_dirty.resize(m_records.size());
        std::iota(m_dirty.begin(), m_dirty.end(), 0u);
    }
    std::ranges::sort(m_dirty);
    std::uint64_t bytes = 0;
    if (wanted.records) bytes += writeInto(m_recordBuffer, "instances", m_records, m_dirty, all);
    if (wanted.spheres) bytes += writeInto(m_cullBuffer, "spheres of instances", m_cullRecords, m_dirty, all);
    m_dirty.clear();
    return bytes;
}

DrawList InstanceSet::draws(GpuStream& stream, const View& view) const
{
    const glsl::CullView wind = cullView(view.request, m_records.size());
    const CullScene scene{.records = m_cullRecords, .models = view.models.cullModels(), .tree = &m_tree};
    const glsl::CullCounts counts = cull(scene, view.request, m_seen);
    DrawList list = makeDrawList(stream, {.models = view.models,
                                          .seen = m_seen,
                                          .instances = m_records,
                                          .blended = view.blended,
                                          .apart = view.apart,
                                          .direct = view.direct,
                                          .recordBuffer = view.direct && m_onGpu ? m_recordBuffer.id() : 0,
                                          .records = m_cullRecords,
                                          .eye = view.request.sortedFor.value_or(view.request.eye),
                                          .towardSun = view.request.towardSun,
                                          .wind = &wind});
    list.counts = counts;
    return list;
}

} // namespace renderer
