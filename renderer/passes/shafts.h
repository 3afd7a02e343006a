// Light shafts: the light that shadows take out of fog. In a volume of froxels that looks into the shadow maps, or, for
// machines that cannot bear it, from the picture's depth while the sun is in or near the view.
#pragma once

#include "renderer/gl/volume_texture.h"
#include "renderer/passes/lighting.h"
#include "renderer/shaders/shared/shafts.h"

namespace renderer {

class ShaftsPass {
public:
    explicit ShaftsPass(ShaderLibrary& shaders);

    // Finds what is missing in the fog of `radiance`, takes it away, and binds it for what is drawn over that.
    void render(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, const Viewpoint& viewpoint, const Settings& settings);

private:
    void fillVolume(GpuFrame& gpu, const Viewpoint& viewpoint, const Settings& settings);
    void lookAtScreen(GpuFrame& gpu, const GBuffer& surfaces, bool clouded);
    void apply(GpuFrame& gpu, Radiance& radiance, const GBuffer& surfaces, Shafts kind);

    ShaderLibrary& m_shaders;
    gl::VolumeTexture m_volume;
    gl::Texture m_small;
    gl::Framebuffer m_smallTarget;
    gl::Framebuffer m_colourOnly; // of the radiance, whose depth is read meanwhile
    GLuint m_radiance = 0;
};

// Which form of them a view has, and the constants for it.
void addShafts(Viewpoint& viewpoint, const io::Fog& fog, const Settings& settings);
const char* shaftsDefine(Shafts kind); // null for none
void addHaze(std::vector<std::string>& defines, const Viewpoint& viewpoint); // those that haze.glsl asks for, beside AERIAL

} // namespace renderer
