// The GBuffer: what every pixel shows, before any light.
#pragma once

#include "renderer/passes/object_programs.h"
#include "renderer/scenery.h"

namespace renderer {

struct GBuffer {
    gl::Texture colour;  // base colour as square roots, occlusion
    gl::Texture normal;  // octahedral
    gl::Texture surface; // roughness, metallic, bits, emission
    gl::Texture id;      // of the object, kTerrainId, 0 for the sky
    gl::Texture depth;   // reversed
    void bind(GpuFrame& gpu) const;
};

class GeometryPass {
public:
    explicit GeometryPass(ShaderLibrary& shaders);

    struct Drawn { // the camera's lists, for passes that draw the same things again
        std::vector<DrawList> objects;
        Terrain::Draws ground;
        const gl::Texture* farthest = nullptr; // DepthPyramid of what hides things; null: none was made
    };
    void begin(const Viewpoint& viewpoint, bool ids); // empty targets; without `ids` those stay empty
    void drawObjects(GpuFrame& gpu, const DrawList& objects);
    void drawGround(GpuFrame& gpu, Scenery& scenery, const Terrain::Draws& ground, const Settings& settings);
    const GBuffer& finish();                // what later passes may read
    const GBuffer& targets() const { return m_targets; }
    bool keepsIds() const { return m_ids; }
    const gl::Framebuffer& framebuffer() const { return m_ids ? m_framebuffer : m_withoutIds; } // that is drawn into

private:
    void resize(glm::ivec2 size);

    ShaderLibrary& m_shaders;
    ObjectPrograms m_programs;
    gl::VertexArray m_objects;
    GBuffer m_targets;
    gl::Framebuffer m_framebuffer;
    gl::Framebuffer m_withoutIds; // the same targets but one
    bool m_ids = true;
};

} // namespace renderer
