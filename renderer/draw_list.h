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
    bool swaying = false;          // moved by the wind
    std::size_t commandOffset = 0; // bytes into the command buffer
    std::uint32_t commands = 0;
    std::uint64_t triangles = 0;
    float distance = 0;            // of what blends: of its first instance
};

struct DrawList {
    const ModelLibrary* models = nullptr;
    GpuStream::Piece instances; // copies of their records, or a direct model's records themselves
    GpuStream::Piece commands;
    std::vector<DrawCommand> calls; // of the direct path, in place of `commands`: each a call of its own
    std::vector<DrawRange> opaque;  // masked too
    std::vector<DrawRange> blended; // back to front
    std::uint64_t visible = 0;      // instances
    glsl::CullCounts counts{};      // where the CPU culled
    std::array<std::uint64_t, MOST_LEVELS> trianglesOfLevel{};
};

struct DrawSource {
    const ModelLibrary& models;
    std::span<const Seen> seen;
    std::span<const glsl::Instance> instances;      // by slot
    bool blended = true;                            // blended parts too
    bool apart = false;                             // each of those in a range of its own: other lists lie between
    bool direct = false;                            // by calls of their own
    GLuint recordBuffer = 0;                        // holds `instances`, of the direct path; 0: does not
    std::span<const glsl::CullRecord> records = {}; // to sort by distance; none: drawn as they come
    glm::dvec3 eye{0};
    std::optional<glm::dvec3> towardSun;            // of parallel light: distance is counted from there
    const glsl::CullView* wind = nullptr;           // what bins that sway are moved by
};
DrawList makeDrawList(GpuStream& stream, const DrawSource& source);

// Vertices by binding 0, instances by binding 1, as objects.vert.glsl and records.glsl read them.
gl::VertexArray makeObjectVertexArray();

// Its library's buffers and materials and its instances; then its ranges, one by one.
void bindSources(gl::VertexArray& array, const DrawList& list);
void drawRange(GpuFrame& gpu, const DrawList& list, const DrawRange& range);

// Draws ranges with the program and state that `prepare(range, batch)` sets; it answers false to leave a range out.
template <class Prepare>
void drawRanges(GpuFrame& gpu, gl::VertexArray& array, const DrawList& list, std::span<const DrawRange> ranges, Prepare&& prepare)
{
    if (ranges.empty()) return;
    bindSources(array, list);
    for (const DrawRange& range : ranges)
        if (prepare(range, list.models->batches()[std::size_t(range.batch)])) drawRange(gpu, list, range);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

} // namespace renderer
