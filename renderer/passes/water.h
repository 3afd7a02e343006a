// Lakes and the sea: one level in all of the world, drawn over the lit picture, and the water that an eye is in.
#pragma once

#include "renderer/passes/lighting.h"
#include "renderer/shaders/shared/water.h"

namespace renderer {

class WaterPass {
public:
    explicit WaterPass(ShaderLibrary& shaders);
    // Adds it to the picture and to the depth; ids stay those of what lies under it.
    void render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const io::Environment& environment,
                const Viewpoint& viewpoint, const Settings& settings);

private:
    void copy(const Radiance& radiance, const GBuffer& surfaces);
    void drawPatches(GpuFrame& gpu, const Viewpoint& viewpoint, glsl::Water& water, const Settings& settings);
    void makeGrid();

    ShaderLibrary& m_shaders;
    gl::Texture m_ripples;       // made when first there is water
    gl::Texture m_behind, m_behindDepth; // what is read while the picture is drawn into
    gl::Buffer m_indices;
    gl::VertexArray m_patches, m_plain;
};

} // namespace renderer
