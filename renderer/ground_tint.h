// The ground's colours as seen from above, for what grows on it: in a window around the eye that wraps around. Drawn by the ground's own
// shader, and only what came into the window or looks other than it did.
#pragma once

#include "renderer/shader_library.h"
#include "renderer/terrain.h"

#include <span>

namespace renderer {

class GroundTint {
public:
    // To so many metres from the eye the colours are there until the next call. The ground's block and textures are bound.
    void update(GpuFrame& gpu, ShaderLibrary& shaders, Terrain& terrain, const glm::dvec3& eye, double distance);

    const gl::Texture& texture() const { return m_texture; } // square roots of linear colours
    float scale() const { return 1 / float(m_step * m_texture.size().x); } // from texels of the ground to the texture's 0..1, and on

private:
    bool draw(GpuFrame& gpu, ShaderLibrary& shaders, const Terrain& terrain, std::span<const io::TexelRect> parts);

    gl::Texture m_texture;
    gl::VertexArray m_bare; // has no vertices
    int m_step = 1;         // texels of the ground in one of its own, along a side
    io::TexelRect m_window; // its own texels that are there
};

} // namespace renderer
