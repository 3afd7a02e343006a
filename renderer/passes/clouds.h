// Clouds: their shadows around the eye, and the clouds that the sky does not draw itself, as volumes or seen from above.
#pragma once

#include "renderer/cloud_noise.h"
#include "renderer/passes/lighting.h"
#include "renderer/shaders/shared/clouds.h"

#include <optional>

namespace renderer {

class CloudPass {
public:
    explicit CloudPass(ShaderLibrary& shaders);

    // Before whatever is lit: binds the block, the noise and the map of shadows.
    // `exact`: its shadows are not kept while the clouds drift a little.
    void update(GpuFrame& gpu, const glsl::Clouds& clouds, CloudKind kind, bool exact = false);
    // Whether the layer is for the sky to draw: it lies behind all surfaces.
    bool areInSky() const { return m_clouds.on > 0 && m_kind == CloudKind::Layer && m_clouds.base > 0; }
    // Whether the eye looks down on them: over water too then.
    bool areBelow() const { return m_clouds.on > 0 && m_clouds.base <= 0; }
    // Over the finished sky and surfaces.
    void render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const Settings& settings);

private:
    void drawMap(GpuFrame& gpu);
    void resize(glm::ivec2 size);

    ShaderLibrary& m_shaders;
    CloudNoise m_noise;
    glsl::Clouds m_clouds{};
    CloudKind m_kind = CloudKind::Layer;
    struct Drawn { // what the map shows
        glsl::Clouds clouds;
        glm::ivec2 middle; // texels of the field
        CloudKind kind;
    };
    static bool sameShadows(const Drawn& a, const Drawn& b);
    std::optional<Drawn> m_drawn;
    gl::Texture m_map, m_image, m_distances;
    gl::Framebuffer m_mapTarget, m_imageTarget;
};

} // namespace renderer
