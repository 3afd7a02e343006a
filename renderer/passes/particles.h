// Fire, smoke and dust over the lit picture: from back to front, lit, and soft where they meet a surface.
#pragma once

#include "renderer/passes/lighting.h"

namespace renderer {

class ParticlePass {
public:
    explicit ParticlePass(ShaderLibrary& shaders);
    void render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const Scenery& scenery, const io::Wind& wind,
                const Viewpoint& viewpoint, const Settings& settings);

private:
    void makeAtlas(GpuFrame& gpu);

    ShaderLibrary& m_shaders;
    gl::Texture m_atlas; // of puffs and flames, made when first there is something to draw
    gl::VertexArray m_quads;
};

} // namespace renderer
