// Shadow maps of the sun: one layer and one draw a cascade, kept while neither light nor world nor box changed.
#pragma once

#include "renderer/choosing.h"
#include "renderer/passes/object_programs.h"
#include "renderer/scenery.h"

namespace renderer {

class ShadowPass {
public:
    explicit ShadowPass(ShaderLibrary& shaders);

    // A texture of one lit layer where there are no cascades.
    const gl::Texture& render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Settings& settings);

private:
    struct Key { // of what a layer holds
        glm::dvec3 snapped{0};
        double radius = 0;
        glm::dvec3 towardSun{0};
        std::uint64_t world = 0, terrain = 0;
        bool culling = false, lod = false;
        glm::vec4 wind{0};          // its means
        std::optional<double> time; // s, where something sways
        bool operator==(const Key&) const = default;
    };
    void resize(int resolution, int layers);
    bool renderCascade(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, std::size_t index,
                       const Settings& settings); // whether something in it sways

    ObjectPrograms m_masked;
    const gl::Program &m_solid, &m_solidSwaying, &m_ground;
    gl::VertexArray m_objects;
    gl::Texture m_maps;
    gl::Texture m_lit;
    std::vector<gl::Framebuffer> m_layers;
    std::vector<Key> m_keys;
    ShaderLibrary& m_shaders;
    std::vector<std::unique_ptr<ViewChooser>> m_choosers; // by cascade
};

} // namespace renderer
