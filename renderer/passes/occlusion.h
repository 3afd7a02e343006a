// Ambient occlusion from the GBuffer's depth and normals, at the picture's resolution or at half of it.
#pragma once

#include "io/scene/environment.h"
#include "renderer/passes/geometry.h"

namespace renderer {

class OcclusionPass {
public:
    explicit OcclusionPass(ShaderLibrary& shaders) : m_shaders{shaders} {}

    // Leaves its texture bound for occlusion.glsl.
    void render(GpuFrame& gpu, const GBuffer& surfaces, const Eye& eye, const io::Occlusion& occlusion, const Settings& settings);

private:
    struct Target {
        gl::Texture texture; // share of the sky that is seen, depth
        gl::Framebuffer framebuffer;
    };
    void resize(glm::ivec2 size);

    ShaderLibrary& m_shaders;
    Target m_found, m_across; // and again in m_found, blurred along both axes
};

bool occludes(const io::Occlusion& occlusion, const Settings& settings); // else there is nothing to be seen of it
std::vector<std::string> occlusionDefines(const io::Occlusion& occlusion, const Settings& settings); // that occlusion.glsl asks for

} // namespace renderer
