// Shadow maps of the sun: one layer a cascade, of which only what is missing is drawn: what came into its window, and where
// something moved.
#pragma once

#include "renderer/choosing.h"
#include "renderer/passes/object_programs.h"
#include "renderer/scenery.h"

namespace renderer {

struct DeleteSampler {
    void operator()(GLuint id) const { glDeleteSamplers(1, &id); }
};

class ShadowPass {
public:
    explicit ShadowPass(ShaderLibrary& shaders);

    // A texture of one lit layer where there are no cascades.
    const gl::Texture& render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Settings& settings);
    void forget() // all is drawn anew
    {
        for (Layer& layer : m_layers)
            layer.window = {};
    }

private:
    struct Key { // of what all of a layer is drawn with
        double texel = 0, bottom = 0, depthRange = 0;
        glm::dvec3 towardSun{0};
        std::uint64_t world = 0, terrain = 0;
        bool culling = false;
        float lodPixels = 0; // 0: full models
        glm::vec4 wind{0};          // its means
        std::optional<double> time; // s, where something sways
        bool operator==(const Key&) const = default;
    };
    struct Layer {
        gl::Framebuffer target;
        Key key;
        io::TexelRect window; // that it holds
    };
    void resize(int resolution, int layers);
    void update(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, std::size_t index, const Settings& settings);
    bool draw(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Cascade& cascade, const Layer& layer,
              const CascadePiece& piece, const Settings& settings); // whether something in it sways
    ViewChooser& nextChooser();

    ObjectPrograms m_masked;
    const gl::Program &m_solid, &m_solidSwaying;
    gl::VertexArray m_objects;
    gl::Texture m_maps;
    gl::Texture m_lit;
    gl::Handle<DeleteSampler> m_asNumbers; // reads depths rather than comparing with them
    std::vector<Layer> m_layers;
    ShaderLibrary& m_shaders;
    std::vector<std::unique_ptr<ViewChooser>> m_choosers; // by piece of the frame, as each has buffers of its own
    std::size_t m_pieces = 0;
};

} // namespace renderer
