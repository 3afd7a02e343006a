// Grass into the GBuffer: placed by a compute shader, drawn by what that wrote, nothing read back but counts for the statistics.
#pragma once

#include "renderer/gpu_readback.h"
#include "renderer/passes/geometry.h"

namespace renderer {

class GrassPass {
public:
    explicit GrassPass(ShaderLibrary& shaders);

    // The GBuffer's targets are bound; the ground and all that hides grass is in them.
    void render(GpuFrame& gpu, const gl::Framebuffer& target, Scenery& scenery, const Viewpoint& viewpoint, const io::Environment& environment,
                std::span<const Presser> pressers, const Settings& settings);

    std::vector<glsl::GrassBlade> readBlades() const; // of the last frame, waits for the GPU; for tests

private:
    bool place(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const io::Environment& environment, std::span<const Presser> pressers,
               const Settings& settings);
    void makeRoom(std::uint32_t most);
    void updateTint(GpuFrame& gpu, Scenery& scenery);

    ShaderLibrary& m_shaders;
    const gl::Program& m_commandsProgram;
    gl::Buffer m_blades, m_counts, m_commands;
    std::uint32_t m_room = 0; // of each shape
    gl::VertexArray m_strips, m_bare; // the second has no vertices
    gl::Texture m_tint;
    GpuReadback<glsl::GrassCounts> m_readback;
    bool m_warned = false;
};

} // namespace renderer
