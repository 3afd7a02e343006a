// Culling by compute shaders: the same answer as cull(), with what stands before other things known too. Each view has
// buffers of its own; the scene's are shared.
#pragma once

#include "renderer/draw_list.h"
#include "renderer/gpu_readback.h"
#include "renderer/shader_library.h"

#include <array>

namespace renderer {

// What all views read: kept up to date by the world.
struct GpuCullScene {
    GLuint instances = 0, records = 0;
    std::size_t count = 0;
};

// Commands of every part of every level, in the order in which they are drawn; made anew when models come or go.
class CullTable {
public:
    void update(const ModelLibrary& models);
    std::span<const DrawRange> ranges() const { return m_ranges; } // `triangles` is 0: the GPU knows
    GLuint parts() const { return m_parts.id(); }
    GLuint models() const { return m_models.id(); }
    std::uint32_t partCount() const { return m_partCount; }
    std::uint32_t binCount() const { return m_binCount; }

private:
    gl::Buffer m_parts, m_models;
    std::vector<DrawRange> m_ranges;
    std::uint32_t m_partCount = 0, m_binCount = 0;
    std::uint64_t m_of = ~std::uint64_t(0); // revision of the library
};

// The farthest depth of what is drawn so far, in ever coarser squares.
class DepthPyramid {
public:
    explicit DepthPyramid(ShaderLibrary& shaders);
    const gl::Texture& make(GpuFrame& gpu, const gl::Texture& depth);

private:
    const gl::Program& m_program;
    gl::Texture m_levels;
};

class CulledView {
public:
    static constexpr std::size_t kMostRoom = 1u << 22; // instances in a list; 320 MB
    explicit CulledView(ShaderLibrary& shaders, std::size_t mostRoom = kMostRoom);

    // Everything at once, without occlusion.
    DrawList all(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request);
    // What the last frame saw; then, when that lies in `pyramid`, the rest of what is not hidden. The view block is bound.
    DrawList early(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request);
    DrawList late(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request,
                  const gl::Texture& pyramid);
    // What the last frame with late() saw, in this request's view and at its levels.
    DrawList kept(GpuFrame& gpu, const CullTable& table, const GpuCullScene& scene, const CullRequest& request);

    glsl::CullCounts counts() const { return m_counts; } // of a frame a little earlier, so that reading never waits

private:
    struct Pass { // buffers of one list
        gl::Buffer bins, commands, drawn;
    };
    DrawList run(GpuFrame& gpu, const gl::Program& decide, Pass& pass, const CullTable& table, const GpuCullScene& scene,
                 const CullRequest& request);
    void readCounts();

    const gl::Program &m_all, &m_early, &m_late, &m_kept, &m_copy, &m_commands;
    std::array<Pass, 2> m_passes;
    gl::Buffer m_decided, m_seen, m_countsBuffer;
    std::size_t m_mostRoom;      // what is more in view than this is left out, and said
    std::size_t m_room;          // instances in a list
    std::size_t m_slots = 0;     // that m_seen knows
    bool m_warned = false;

    std::unique_ptr<GpuReadback<glsl::CullCounts>> m_readback;
    glsl::CullCounts m_counts{};
};

} // namespace renderer
