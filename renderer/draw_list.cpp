#include "renderer/draw_list.h"

#include <algorithm>
#include <cstddef>

namespace renderer {
namespace {

// Slots sorted by bin, each bin in the order of the slots: the same picture whatever was culled around it.
struct Binned {
    std::vector<std::uint32_t> begin; // of each bin in `slots`, and one past the end
    std::vector<std::uint32_t> slots;

    std::uint32_t count(std::size_t bin) const { return begin[bin + 1] - begin[bin]; }
};

Binned binned(const DrawSource& source)
{
    Binned result;
    result.begin.assign(std::size_t(source.models.size()) * 2 + 1, 0);
    for (const std::uint32_t slot : source.visible)
        ++result.begin[source.bins[slot] + 1];
    for (std::size_t i = 1; i < result.begin.size(); ++i)
        result.begin[i] += result.begin[i - 1];
    result.slots.resize(source.visible.size());
    std::vector<std::uint32_t> next = result.begin;
    for (const std::uint32_t slot : source.visible)
        result.slots[next[source.bins[slot]]++] = slot;
    return result;
}

DrawCommand commandOf(const ModelPart& part, std::uint32_t instances, std::uint32_t first)
{
    return {.count = part.indexCount, .instanceCount = instances, .firstIndex = part.firstIndex, .baseInstance = first};
}

// Appends commands range by range; neighbours of one batch and one handedness share a range.
class Writer {
public:
    explicit Writer(std::vector<DrawCommand>& commands) : m_commands{commands} {}
    void add(std::vector<DrawRange>& ranges, int batch, bool mirrored, const DrawCommand& command)
    {
        if (ranges.empty() || ranges.back().batch != batch || ranges.back().mirrored != mirrored)
            ranges.push_back({.batch = batch, .mirrored = mirrored, .commandOffset = m_commands.size() * sizeof(DrawCommand)});
        m_commands.push_back(command);
        ++ranges.back().commands;
        ranges.back().triangles += std::uint64_t(command.count / 3) * command.instanceCount;
    }

private:
    std::vector<DrawCommand>& m_commands;
};

struct PartInBatch {
    int batch = 0;
    std::uint32_t bin = 0;
    const ModelPart* part = nullptr;
};

// The opaque parts of models that are seen at all, grouped by batch.
std::vector<PartInBatch> opaqueParts(const ModelLibrary& models, const Binned& bins)
{
    std::vector<PartInBatch> parts;
    for (std::uint32_t bin = 0; bin + 1 < bins.begin.size(); ++bin) {
        if (bins.count(bin) == 0) continue;
        for (const ModelPart& part : models.entry(int(bin / 2)).parts)
            if (!models.batches()[std::size_t(part.batch)].blend) parts.push_back({part.batch, bin, &part});
    }
    std::ranges::stable_sort(parts, {}, [](const PartInBatch& p) { return std::pair{p.batch, p.bin % 2}; });
    return parts;
}

struct BlendedPart {
    float distance = 0; // squared
    std::uint32_t index = 0; // in the instance list
    std::uint32_t bin = 0;
    const ModelPart* part = nullptr;
};

std::vector<BlendedPart> blendedParts(const DrawSource& source, const Binned& bins)
{
    std::vector<BlendedPart> parts;
    const glm::vec3 eye{source.eye};
    const auto distance = [&](std::uint32_t slot) {
        if (!source.spheres) return 0.0f;
        const Spheres& s = *source.spheres;
        const glm::vec3 d = glm::vec3{s.x[slot], s.y[slot], s.z[slot]} - eye;
        return glm::dot(d, d);
    };
    for (std::uint32_t bin = 0; bin + 1 < bins.begin.size(); ++bin)
        for (const ModelPart& part : source.models.entry(int(bin / 2)).parts) {
            if (bins.count(bin) == 0 || !source.models.batches()[std::size_t(part.batch)].blend) continue;
            for (std::uint32_t i = bins.begin[bin]; i < bins.begin[bin + 1]; ++i)
                parts.push_back({distance(bins.slots[i]), i, bin, &part});
        }
    std::ranges::stable_sort(parts, std::greater{}, &BlendedPart::distance);
    return parts;
}

} // namespace

DrawList makeDrawList(GpuStream& stream, const DrawSource& source)
{
    DrawList list;
    list.visible = source.visible.size();
    if (source.visible.empty()) return list;
    const Binned bins = binned(source);
    std::vector<DrawCommand> commands;
    Writer writer{commands};
    for (const PartInBatch& part : opaqueParts(source.models, bins))
        writer.add(list.opaque, part.batch, part.bin % 2 != 0,
                   commandOf(*part.part, bins.count(part.bin), bins.begin[part.bin]));
    if (source.blended)
        for (const BlendedPart& part : blendedParts(source, bins))
            writer.add(list.blended, part.part->batch, part.bin % 2 != 0, commandOf(*part.part, 1, part.index));
    if (commands.empty()) return list;
    list.instances = stream.put(std::span<const std::uint32_t>{bins.slots});
    list.commands = stream.put(std::span<const DrawCommand>{commands});
    return list;
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
    array.integers(7, 1, 1, GL_UNSIGNED_INT, 0);
    array.perInstance(1);
    return array;
}

} // namespace renderer
