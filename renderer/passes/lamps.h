// The lamps in view, sorted into clusters and with their shadows: what lamps.glsl reads.
#pragma once

#include "renderer/lamp_clusters.h"
#include "renderer/passes/lamp_shadows.h"

namespace renderer {

class LampPass {
public:
    explicit LampPass(ShaderLibrary& shaders) : m_shadows{shaders} {}
    void render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Settings& settings);

private:
    LampShadows m_shadows;
    gl::BufferTexture m_records{"lamps", GL_RGBA32F};
    gl::BufferTexture m_lists{"lamps of clusters", GL_R32UI};
};

} // namespace renderer
