// Light on every surface of the GBuffer through the haze before it, and the sky behind: scene-linear radiance.
#pragma once

#include "renderer/passes/geometry.h"

namespace renderer {

struct Radiance {
    gl::Texture texture;         // RGBA16F
    gl::Framebuffer framebuffer; // with the GBuffer's depth
};

class LightingPass {
public:
    explicit LightingPass(ShaderLibrary& shaders);
    Radiance& render(GpuFrame& gpu, const GBuffer& surfaces, const Viewpoint& viewpoint, const Settings& settings);
    Radiance& unlit(const GBuffer& surfaces); // whatever it holds

private:
    void resize(const GBuffer& surfaces);

    ShaderLibrary& m_shaders;
    Radiance m_radiance;
    GLuint m_depth = 0; // that the framebuffer was made with
};

// The defines that lighting.glsl asks for.
std::vector<std::string> lightingDefines(const Viewpoint& viewpoint, const Settings& settings);

class SkyPass {
public:
    explicit SkyPass(ShaderLibrary& shaders);
    void render(GpuFrame& gpu, Radiance& radiance, const Viewpoint& viewpoint, const Settings& settings, bool clouds);

private:
    void renderDome(GpuFrame& gpu, glm::ivec2 size, std::vector<std::string> defines);

    ShaderLibrary& m_shaders;
    Radiance m_dome; // the sky without sun and stars, where it is made at a lower resolution
};

} // namespace renderer
