#include "renderer/draw_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>

namespace renderer {
namespace {

// What is seen, sorted by bin, and in each from front to back.
struct Binned {
    std::vector<std::uint32_t> begin; // of each bin in `drawn`, and one past the end
    std::vector<std::uint32_t> drawn;
    std::vector<std::uint8_t> band;   // of distance, beside `drawn`

    std::uint32_t count(std::size_t bin) const { return begin[bin + 1] - begin[bin]; }
};

// Distance from where the light or the sight comes; only the order counts.
class Distance {
public:
    explicit Distance(const DrawSource& source) : m_records{source.records}, m_eye{source.eye}
    {
        if (source.towardSun) m_away = -glm::vec3{*source.towardSun};
        m_parallel = source.towardSun.has_value();
    }
    float operator()(std::uint32_t drawn) const
    {
        if (m_records.empty()) return 0;
        const glm::vec3 centre = m_records[drawn & DRAWN_SLOT_MASK].centre;
        return m_parallel ? glm::dot(centre, m_away) : glm::length(centre - m_eye);
    }

private:
    std::span<const glsl::CullRecord> m_records;
    glm::vec3 m_eye, m_away{0};
    bool m_parallel = false;
};

constexpr std::size_t kBands = 32;  // of distance, drawn one after the other
constexpr std::size_t kSteps = 512; // of distance, by which things are sorted roughly

// Steps of distance between the nearest and the farthest thing: equal ones along parallel light, growing ones from an eye.
class Steps {
public:
    explicit Steps(const DrawSource& source) : m_distance{source}, m_growing{!source.towardSun}
    {
        for (const Seen& one : source.seen) {
            const float key = keyOf(one.drawn);
            m_low = std::min(m_low, key);
            m_high = std::max(m_high, key);
        }
        m_scale = m_high > m_low ? float(kSteps - 1) / (m_high - m_low) : 0.0f;
    }
    std::size_t operator()(std::uint32_t drawn) const { return std::size_t((keyOf(drawn) - m_low) * m_scale); }

private:
    float keyOf(std::uint32_t drawn) const
    {
        const float distance = m_distance(drawn);
        return m_growing ? std::log2(distance + 4.0f) : distance;
    }

    Distance m_distance;
    bool m_growing;
    float m_low = std::numeric_limits<float>::max(), m_high = std::numeric_limits<float>::lowest(), m_scale = 0;
};

// From front to back, so that near things hide far ones before those are shaded. Counting sorts: what is equal keeps its
// order.
Binned binned(const DrawSource& source)
{
    const Steps steps{source};
    std::vector<std::uint16_t> step(source.seen.size());
    std::ranges::transform(source.seen, step.begin(), steps, &Seen::drawn);
    std::array<std::uint32_t, kSteps + 1> nextOfStep{};
    for (const std::uint16_t one : step)
        ++nextOfStep[one + 1u];
    std::partial_sum(nextOfStep.begin(), nextOfStep.end(), nextOfStep.begin());
    std::vector<std::uint32_t> sorted(source.seen.size());
    for (std::uint32_t i = 0; i < step.size(); ++i)
        sorted[nextOfStep[step[i]]++] = i;

    Binned result;
    result.begin.assign(source.models.bins().size() + 1, 0);
    for (const Seen& one : source.seen)
        ++result.begin[one.bin + 1];
    std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
    result.drawn.resize(sorted.size());
    result.band.resize(sorted.size());
    std::vector<std::uint32_t> next = result.begin;
    for (const std::uint32_t i : sorted) {
        const std::uint32_t at = next[source.seen[i].bin]++;
        result.drawn[at] = source.seen[i].drawn;
        result.band[at] = std::uint8_t(step[i] * kBands / kSteps);
    }
    return result;
}

DrawCommand commandOf(const ModelPart& part, std::uint32_t instances, std::uint32_t first)
{
    return {.count = part.indexCount, .instanceCount = instances, .firstIndex = part.firstIndex, .baseInstance = first};
}

// Appends commands range by range; neighbours that are drawn alike share a range.
class Writer {
public:
    Writer(DrawList& list, std::vector<DrawCommand>& commands) : m_list{list}, m_commands{commands} {}
    void add(std::vector<DrawRange>& ranges, int batch, const Bin& bin, const DrawCommand& command)
    {
        if (ranges.empty() || m_apart || ranges.back().batch != batch || ranges.back().mirrored != bin.mirrored ||
            ranges.back().fading != bin.fading || ranges.back().swaying != bin.swaying)
            ranges.push_back({.batch = batch,
                              .mirrored = bin.mirrored,
                              .fading = bin.fading,
                              .swaying = bin.swaying,
                              .commandOffset = m_commands.size() * sizeof(DrawCommand)});
        m_commands.push_back(command);
        ++ranges.back().commands;
        const std::uint64_t triangles = std::uint64_t(command.count / 3) * command.instanceCount;
        ranges.back().triangles += triangles;
        m_list.trianglesOfLevel[std::size_t(bin.level)] += triangles;
    }
    void keepApart() { m_apart = true; }

private:
    DrawList& m_list;
    std::vector<DrawCommand>& m_commands;
    bool m_apart = false;
};

struct PartInBatch {
    int batch = 0;
    std::uint32_t bin = 0;
    const ModelPart* part = nullptr;
    std::uint32_t first = 0, instances = 0; // in the instance list
    int band = 0;
};

std::span<const ModelPart> partsOf(const ModelLibrary& models, std::uint32_t bin)
{
    const Bin& which = models.bins()[bin];
    return models.entry(which.model).levels[std::size_t(which.level)].parts;
}

// A part of a bin's instances, band by band of distance.
void addBands(std::vector<PartInBatch>& parts, PartInBatch part, const Binned& bins)
{
    for (std::uint32_t first = bins.begin[part.bin], i = first; i < bins.begin[part.bin + 1]; ++i) {
        if (i + 1 < bins.begin[part.bin + 1] && bins.band[i + 1] == bins.band[first]) continue;
        part.first = first;
        part.instances = i + 1 - first;
        part.band = bins.band[first];
        parts.push_back(part);
        first = i + 1;
    }
}

// Models of which some copies are seen as impostors.
std::size_t impostorsSeen(const ModelLibrary& models, const Binned& bins)
{
    std::size_t count = 0;
    for (std::uint32_t bin = 0; bin + 1 < bins.begin.size(); ++bin) {
        const ModelEntry& entry = models.entry(models.bins()[bin].model);
        count += bins.count(bin) > 0 && entry.impostor && models.bins()[bin].level + 1 == int(entry.levels.size());
    }
    return count;
}

// The opaque parts of what is seen at all, grouped by batch. What has no holes first: it hides most and costs least. What
// has some goes from front to back across all models, as each layer of leaves costs as much as the one that is seen.
std::vector<PartInBatch> opaqueParts(const ModelLibrary& models, const Binned& bins)
{
    std::vector<PartInBatch> parts;
    const bool severalImpostors = impostorsSeen(models, bins) > 1; // else one command is in order by itself
    for (std::uint32_t bin = 0; bin + 1 < bins.begin.size(); ++bin) {
        if (bins.count(bin) == 0) continue;
        for (const ModelPart& part : partsOf(models, bin)) {
            const Batch& batch = models.batches()[std::size_t(part.batch)];
            const PartInBatch whole{part.batch, bin, &part, bins.begin[bin], bins.count(bin)};
            if (batch.blend) continue;
            if (hasHoles(batch) && (!(batch.features & kFeatureImpostor) || severalImpostors)) addBands(parts, whole, bins);
            else parts.push_back(whole);
        }
    }
    std::ranges::stable_sort(parts, {}, [&](const PartInBatch& p) {
        const bool holes = hasHoles(models.batches()[std::size_t(p.batch)]);
        const Bin& bin = models.bins()[p.bin];
        return std::tuple{holes, p.band, bin.fading, bin.swaying, p.batch, bin.mirrored};
    });
    return parts;
}

struct BlendedPart {
    float distance = 0;
    std::uint32_t index = 0; // in the instance list
    std::uint32_t bin = 0;
    const ModelPart* part = nullptr;
};

std::vector<BlendedPart> blendedParts(const DrawSource& source, const Binned& bins)
{
    std::vector<BlendedPart> parts;
    const Distance distance{source};
    for (std::uint32_t bin = 0; bin + 1 < bins.begin.size(); ++bin) {
        if (bins.count(bin) == 0) continue;
        for (const ModelPart& part : partsOf(source.models, bin)) {
            if (!source.models.batches()[std::size_t(part.batch)].blend) continue;
            for (std::uint32_t i = bins.begin[bin]; i < bins.begin[bin + 1]; ++i)
                parts.push_back({distance(bins.drawn[i]), i, bin, &part});
        }
    }
    std::ranges::stable_sort(parts, std::greater{}, &BlendedPart::distance);
    return parts;
}

// One that fades is seen twice.
std::uint64_t instancesIn(std::span<const Seen> seen)
{
    return std::uint64_t(std::ranges::count_if(
        seen, [](const Seen& one) { return (one.drawn >> DRAWN_FADE_SHIFT) < DRAWN_FADE_OTHERS; }));
}

// Whether each bin's records follow one another and a view adds nothing to them, neither a level nor a share that is
// faded: an entry is then a slot.
bool standInRow(const ModelLibrary& models, const Binned& bins)
{
    for (std::uint32_t bin = 0; bin + 1 < bins.begin.size(); ++bin) {
        if (bins.count(bin) == 0) continue;
        const Bin& kind = models.bins()[bin];
        if (kind.fading || kind.swaying || kind.level > 0) return false;
        const auto [least, most] =
            std::minmax_element(bins.drawn.begin() + bins.begin[bin], bins.drawn.begin() + bins.begin[bin + 1]);
        if (*most - *least + 1 != bins.count(bin)) return false;
    }
    return true;
}

// The buffer's order, at the price of the distance's.
void orderAsTheyStand(Binned& bins)
{
    for (std::uint32_t bin = 0; bin + 1 < bins.begin.size(); ++bin)
        std::sort(bins.drawn.begin() + bins.begin[bin], bins.drawn.begin() + bins.begin[bin + 1]);
    std::ranges::fill(bins.band, std::uint8_t(0));
}

// As bend() of cull.comp.glsl does.
void bend(glsl::Instance& copy, const DrawSource& source, std::uint32_t slot)
{
    const glsl::CullView& view = *source.wind;
    const glsl::CullRecord& record = source.records[slot];
    const float shown = glsl::swayShown(record, source.models.cullModels()[record.model], view);
    const glm::vec3 high = copy.positionHigh, low = copy.positionLow;
    const glm::vec2 place = glsl::windPlace(view.wind, {high.x, high.z}, {low.x, low.z});
    const std::uint32_t phase = glsl::windPhase(copy.objectId);
    const glsl::Sway sway = glsl::windSway(view.wind, place, copy.axisX.w * shown, copy.axisY.w, phase);
    copy.drawn |= phase << DRAWN_PHASE_SHIFT | glsl::swayFlutter(sway) << DRAWN_FLUTTER_SHIFT;
    copy.axisX.w = sway.top.x;
    copy.axisY.w = sway.top.y;
}

// Software GL reads an attribute of an instance many times faster than it fetches a record for each vertex, and a view
// draws few of all instances.
GpuStream::Piece copies(GpuStream& stream, const DrawSource& source, const Binned& bins)
{
    const GpuStream::Piece piece = stream.take(bins.drawn.size() * sizeof(glsl::Instance));
    std::byte* to = piece.bytes.data();
    for (std::size_t bin = 0; bin + 1 < bins.begin.size(); ++bin)
        for (std::uint32_t i = bins.begin[bin]; i < bins.begin[bin + 1]; ++i) {
            const std::uint32_t one = bins.drawn[i], slot = one & DRAWN_SLOT_MASK;
            glsl::Instance copy = source.instances[slot];
            copy.drawn = (copy.drawn & DRAWN_FLAGS_MASK) | (one & ~DRAWN_SLOT_MASK);
            if (source.models.bins()[bin].swaying) bend(copy, source, slot);
            std::memcpy(to, &copy, sizeof copy);
            to += sizeof copy;
        }
    return piece;
}

} // namespace

DrawList makeDrawList(GpuStream& stream, const DrawSource& source)
{
    DrawList list;
    list.models = &source.models;
    list.visible = instancesIn(source.seen);
    if (source.seen.empty()) return list;
    Binned bins = binned(source);
    const bool inPlace = source.recordBuffer != 0 && standInRow(source.models, bins);
    if (inPlace) orderAsTheyStand(bins);
    const auto placeOf = [&](std::uint32_t index) { return inPlace ? bins.drawn[index] : index; };
    const std::span<const Bin> kinds = source.models.bins();
    std::vector<DrawCommand> commands;
    Writer writer{list, commands};
    for (const PartInBatch& part : opaqueParts(source.models, bins))
        writer.add(list.opaque, part.batch, kinds[part.bin],
                   commandOf(*part.part, part.instances, placeOf(part.first)));
    if (source.apart) writer.keepApart();
    if (source.blended)
        for (const BlendedPart& part : blendedParts(source, bins)) {
            const std::size_t ranges = list.blended.size();
            writer.add(list.blended, part.part->batch, kinds[part.bin], commandOf(*part.part, 1, placeOf(part.index)));
            if (list.blended.size() > ranges) list.blended.back().distance = part.distance;
        }
    if (commands.empty()) return list;
    list.instances = inPlace ? GpuStream::Piece{.buffer = source.recordBuffer} : copies(stream, source, bins);
    if (source.direct) list.calls = std::move(commands);
    else list.commands = stream.put(std::span<const DrawCommand>{commands});
    return list;
}

void bindSources(gl::VertexArray& array, const DrawList& list)
{
    array.source(0, list.models->vertices(), 0, sizeof(PackedVertex));
    array.indices(list.models->indices());
    array.source(1, list.instances.buffer, list.instances.offset, sizeof(glsl::Instance));
    list.models->bindMaterials();
    glBindVertexArray(array.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list.commands.buffer);
}

void drawRange(GpuFrame& gpu, const DrawList& list, const DrawRange& range)
{
    gpu.count(range.commands, range.triangles);
    if (list.calls.empty()) {
        const auto* offset = reinterpret_cast<const void*>(list.commands.offset + range.commandOffset);
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, offset, GLsizei(range.commands), 0);
        return;
    }
    for (const DrawCommand& call : std::span{list.calls}.subspan(range.commandOffset / sizeof(DrawCommand), range.commands)) {
        const auto* first = reinterpret_cast<const void*>(call.firstIndex * sizeof(std::uint32_t));
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, GLsizei(call.count), GL_UNSIGNED_INT, first,
                                            GLsizei(call.instanceCount), call.baseInstance);
    }
}

gl::VertexArray makeObjectVertexArray()
{
    gl::VertexArray array{"objects"};
    array.attribute(0, 0, 3, GL_FLOAT, offsetof(PackedVertex, position));
    array.attribute(1, 0, 2, GL_SHORT, offsetof(PackedVertex, normal), true);
    array.integers(2, 0, 1, GL_UNSIGNED_INT, offsetof(PackedVertex, tangent));
    array.attribute(3, 0, 4, GL_UNSIGNED_BYTE, offsetof(PackedVertex, colour), true);
    array.attribute(4, 0, 2, GL_FLOAT, offsetof(PackedVertex, uv0));
    array.attribute(5, 0, 2, GL_FLOAT, offsetof(PackedVertex, uv1));
    array.integers(6, 0, 1, GL_UNSIGNED_INT, offsetof(PackedVertex, material));
    array.integers(7, 1, 4, GL_UNSIGNED_INT, offsetof(glsl::Instance, positionHigh));
    array.integers(8, 1, 4, GL_UNSIGNED_INT, offsetof(glsl::Instance, positionLow));
    array.attribute(9, 1, 3, GL_FLOAT, offsetof(glsl::Instance, axisX));
    array.attribute(10, 1, 3, GL_FLOAT, offsetof(glsl::Instance, axisY));
    array.attribute(11, 1, 3, GL_FLOAT, offsetof(glsl::Instance, axisZ));
    array.attribute(12, 1, 1, GL_FLOAT, offsetof(glsl::Instance, axisX) + 12);
    array.attribute(13, 1, 1, GL_FLOAT, offsetof(glsl::Instance, axisY) + 12);
    array.attribute(14, 1, 1, GL_FLOAT, offsetof(glsl::Instance, axisZ) + 12);
    array.perInstance(1);
    return array;
}

} // namespace renderer
