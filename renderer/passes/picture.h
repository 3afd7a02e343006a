// The picture that is shown, and one buffer of the frame in its place.
#pragma once

#include "renderer/passes/lighting.h"

namespace renderer {

struct PictureTarget { // RGBA8, sRGB-encoded values
    gl::Texture texture;
    gl::Framebuffer framebuffer;
    void resize(std::string_view label, glm::ivec2 size);
};

class ShowPass {
public:
    explicit ShowPass(ShaderLibrary& shaders);
    void render(GpuFrame& gpu, PictureTarget& canvas, Show show, const Radiance& radiance, const GBuffer& surfaces,
                Scenery& scenery, const Viewpoint& viewpoint, const GeometryPass::Drawn& drawn, const Settings& settings);

private:
    void drawAgain(GpuFrame& gpu, Scenery& scenery, const GeometryPass::Drawn& drawn, const gl::DrawState& state, bool levels);
    void drawGround(GpuFrame& gpu, Scenery& scenery, const Terrain::Draws& ground, gl::DrawState state, const char* fragment,
                    const std::vector<std::string>& defines);

    ShaderLibrary& m_shaders;
    ObjectPrograms m_flatObjects, m_objectLevels;
    gl::VertexArray m_objects;
    gl::Framebuffer m_withDepth; // the canvas and the GBuffer's depth
    GLuint m_canvas = 0, m_depth = 0;
};

} // namespace renderer
