// Grass into the GBuffer: placed by a compute shader, drawn by what that wrote, nothing read back but counts for the statistics. Kinds that
// name a template are drawn as its model; and there is the original's way, by seeds of the ground's pixels.
#pragma once

#include "renderer/gpu_readback.h"
#include "renderer/ground_tint.h"
#include "renderer/passes/geometry.h"

namespace renderer {

class GrassPass {
public:
    explicit GrassPass(ShaderLibrary& shaders);

    // The ground and all that hides grass is in the GBuffer.
    void render(GpuFrame& gpu, GeometryPass& geometry, const GeometryPass::Drawn& drawn, Scenery& scenery, const Viewpoint& viewpoint,
                const io::Environment& environment, std::span<const Presser> pressers, const Settings& settings);

    std::vector<glsl::GrassBlade> readBlades() const; // of the last frame, waits for the GPU; for tests
    std::vector<glsl::Instance> readPlants(int kind) const; // likewise, of one that grows as a model

private:
    struct Plant { // a kind that grows as a model
        int kind = 0;
        ModelRef model;
    };
    static std::vector<Plant> plantsOf(const Scenery& scenery);
    void makeRoom(std::uint32_t most, std::size_t plants, std::size_t tiles);
    glsl::GrassFrame frame(const Scenery& scenery, const Viewpoint& viewpoint, const io::Environment& environment, std::span<const Presser> pressers,
                           std::span<const Plant> plants, const Settings& settings) const;
    std::vector<std::string> groundDefines(const Scenery& scenery) const;
    bool place(GpuFrame& gpu, Scenery& scenery, std::span<const glsl::GrassTile> tiles, const gl::Texture* farthest, bool plants);
    bool seed(GpuFrame& gpu, GeometryPass& geometry, Scenery& scenery, const Terrain::Draws& ground);
    std::vector<DrawList> command(GpuFrame& gpu, std::span<const Plant> plants, bool seeds);
    void drawBlades(GpuFrame& gpu, const gl::Framebuffer& target, bool seeds);
    void countDrawn(FrameStats& stats, const Settings& settings);

    ShaderLibrary& m_shaders;
    gl::Buffer m_found, m_blades, m_counts, m_commands;
    std::uint32_t m_room = 0; // of each shape
    gl::Buffer m_plants, m_plantCommands;
    std::vector<int> m_kinds; // whose plants lie there, in that order
    gl::Buffer m_indices; // of bundles of blades
    gl::VertexArray m_strips, m_points;
    GroundTint m_tint;
    gl::Framebuffer m_depth; // the GBuffer's depth alone
    GLuint m_depthOf = 0;    // that texture
    GpuReadback<glsl::GrassCounts> m_readback;
    bool m_warned = false;
};

} // namespace renderer
