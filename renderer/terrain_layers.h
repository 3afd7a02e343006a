// What covers the ground, on the GPU: the rules of its layers and their textures.
#pragma once

#include "io/scene/assets.h"
#include "io/scene/terrain.h"
#include "renderer/gpu_frame.h"
#include "renderer/shaders/shared/terrain.h"

namespace renderer {

class TerrainLayers {
public:
    void update(const io::Terrain& terrain, const io::Assets& assets, glsl::Terrain& block); // fills the block's layers
    bool askForFlow() const { return m_asksForFlow; } // where water gathers
    bool present() const { return bool(m_colours); }
    void bind(GpuFrame& gpu) const;

private:
    gl::Texture m_colours; // height of the cover in alpha
    gl::Texture m_normals;
    bool m_asksForFlow = false;
    std::vector<std::shared_ptr<const io::Image>> m_images; // those uploaded
};

} // namespace renderer
