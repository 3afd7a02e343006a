#include "renderer/draw_list.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace renderer {
namespace {

// Slots sorted by bin.
struct Binned {
    std::vector<std::uint32_t> begin; // of each bin in `slots`, and one past the end
    std::vector<std::uint32_t> slots;

    std::uint32_t count(std::size_t bin) const { return begin[bin + 1] - begin[bin]; }
};

// Distance from where the light or the sight comes; only the order counts.
class Distance {
public:
    explicit Distance(const DrawSource& source) : m_spheres{source.spheres}, m_eye{source.eye}
    {
        if (source.towardSun) m_away = -glm::vec3{*source.towardSun};
        m_parallel = source.towardSun.has_value();
    }
    float operator()(std::uint32_t slot) const
    {
        if (!m_spheres) return 0;
        const glm::vec3 centre{m_spheres->x[slot], m_spheres->y[slot], m_spheres->z[slot]};
        return m_parallel ? glm::dot(centre, m_away) : glm::length(centre - m_eye);
    }

private:
    const Spheres* m_spheres;
    glm::vec3 m_eye, m_away{0};
    bool m_parallel = false;
};

// Roughly from front to back, so that near things hide far ones before those are shaded. A counting sort: the order
// within a step of distance stays.
std::vector<std::uint32_t> frontToBack(const DrawSource& source)
{
    constexpr std::size_t kSteps = 512;
    const Distance distance{source};
    std::vector<float> keys(source.visible.size());
    std::ranges::transform(source.visible, keys.begin(), distance);
    const auto [low, high] = std::ranges::minmax(keys);
    const float scale = high > low ? float(kSteps - 1) / (high - low) : 0.0f;
    const auto stepOf = [&](float key) { return std::size_t((key - low) * scale); };
    std::array<std::uint32_t, kSteps + 1> next{};
    for (const float key : keys)
        ++next[stepOf(key) + 1];
    for (std::size_t i = 1; i < next.size(); ++i)
        next[i] += next[i - 1];
    std::vector<std::uint32_t> sorted(source.visible.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        sorted[next[stepOf(keys[i])]++] = source.visible[i];
    return sorted;
}

Binned binned(const DrawSource& source)
{
    const std::vector<std::uint32_t> visible = frontToBack(source);
    Binned result;
    result.begin.assign(std::size_t(source.models.size()) * 2 + 1, 0);
    for (const std::uint32_t slot : visible)
        ++result.begin[source.bins[slot] + 1];
    for (std::size_t i = 1; i < result.begin.size(); ++i)
        result.begin[i] += result.begin[i - 1];
    result.slots.resize(visible.size());
    std::vector<std::uint32_t> next = result.begin;
    for (const std::uint32_t slot : visible)
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
    // What has no holes first: it hides most and costs least.
    std::ranges::stable_sort(parts, {}, [&](const PartInBatch& p) {
        const bool masked = models.batches()[std::size_t(p.batch)].features & kFeatureMask;
        return std::tuple{masked, p.batch, p.bin % 2};
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
