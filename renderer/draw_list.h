// What one view draws of the objects: a list of instances and indirect commands, written for one frame.
#pragma once

#include "renderer/cull.h"
#include "renderer/gpu_frame.h"
#include "renderer/model_library.h"
#include "renderer/shaders/shared/instance.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace renderer {

struct DrawCommand { // as glMultiDrawElementsIndirect reads it
    std::uint32_t count = 0, instanceCount = 0, firstIndex = 0;
    std::int32_t baseVertex = 0;
    std::uint32_t baseInstance = 0;
};

struct DrawRange {
    int batch = 0;
    bool mirrored = false;
    bool fading = false;           // drawn through a pattern of holes
    std::size_t commandOffset = 0; // bytes into the command buffer
    std::uint32_t commands = 0;
    std::uint64_t triangles = 0;
};

struct DrawList {
    GpuStream::Piece instances; // copies of their records
    GpuStream::Piece commands;
    std::vector<DrawRange> opaque;  // masked too
    std::vector<DrawRange> blended; // back to front
    std::uint64_t visible = 0;      // instances
    std::array<std::uint64_t, MOST_LEVELS> trianglesOfLevel{};
};

struct DrawSource {
    const ModelLibrary& models;
    std::span<const Seen> seen;
    std::span<const glsl::Instance> instances;      // by slot
    bool blended = true;                            // blended parts too
    std::span<const glsl::CullRecord> records = {}; // to sort by distance; none: drawn as they come
    glm::dvec3 eye{0};
    std::optional<glm::dvec3> towardSun;            // of parallel light: distance is counted from there
};
DrawList makeDrawList(GpuStream& stream, const DrawSource& source);

// Vertices by binding 0, instances by binding 1, as objects.vert.glsl and records.glsl read them.
gl::VertexArray makeObjectVertexArray();

// Draws ranges with the program and state that `prepare(range)` sets; it answers false to leave a range out.
template <class Prepare>
void drawRanges(GpuFrame& gpu, gl::VertexArray& array, const ModelLibrary& models, const DrawList& list,
                std::span<const DrawRange> ranges, Prepare&& prepare)
{
    if (ranges.empty()) return;
    array.source(0, models.vertices(), 0, sizeof(PackedVertex));
    array.indices(models.indices());
    array.source(1, list.instances.buffer, list.instances.offset, sizeof(glsl::Instance));
    glBindVertexArray(array.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list.commands.buffer);
    for (const DrawRange& range : ranges) {
        if (!prepare(range)) continue;
        const auto* offset = reinterpret_cast<const void*>(list.commands.offset + range.commandOffset);
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, offset, GLsizei(range.commands), 0);
        gpu.count(range.commands, range.triangles);
    }
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

} // namespace renderer
