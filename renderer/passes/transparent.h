// Things one sees through, drawn over the lit picture: blended materials from back to front, and ghosts of what is
// being placed.
#pragma once

#include "renderer/passes/lighting.h"
#include "renderer/passes/passing_objects.h"

namespace renderer {

class TransparentPass {
public:
    explicit TransparentPass(ShaderLibrary& shaders);
    void render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, Scenery& scenery, const Viewpoint& viewpoint,
                std::span<const DrawList> objects, std::span<const Ghost> ghosts, const Settings& settings);

private:
    void resize(const Radiance& radiance, const GBuffer& surfaces);
    void drawBlended(GpuFrame& gpu, const Viewpoint& viewpoint, std::span<const DrawList> objects, const Settings& settings);
    void drawGhostList(GpuFrame& gpu, ObjectPrograms& kinds, const DrawList& list);
    void drawGhosts(GpuFrame& gpu, Radiance& radiance, Scenery& scenery, const Viewpoint& viewpoint,
                    std::span<const Ghost> ghosts, const Settings& settings);
    ObjectPrograms& programs(bool ghosts, const Viewpoint& viewpoint, const Settings& settings);

    struct Variant {
        std::vector<std::string> defines;
        ObjectPrograms programs;
    };
    ShaderLibrary& m_shaders;
    std::vector<std::unique_ptr<Variant>> m_variants;
    const gl::Program& m_depthOnly;
    gl::VertexArray m_objects;
    gl::Framebuffer m_withIds; // blended things can be pointed at
    GLuint m_radiance = 0, m_id = 0;
};


} // namespace renderer
