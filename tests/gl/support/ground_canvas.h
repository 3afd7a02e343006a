// The ground alone, in one colour before another: what shows of the other is a crack.
#pragma once

#include "renderer/gpu_frame.h"
#include "renderer/terrain.h"

namespace test {

class GroundCanvas {
public:
    explicit GroundCanvas(glm::ivec2 size, renderer::TerrainLimits limits = {});
    void load(std::shared_ptr<const io::HeightMap> map);
    renderer::Terrain& terrain() { return m_terrain; }
    bool compiles(renderer::GroundStages stages, const std::string& fragment, std::vector<std::string> defines)
    {
        return bool(m_shaders.program(m_terrain.program("ground", stages, fragment, std::move(defines))));
    }

    bool culled = true;     // or all of it is drawn, seen or not
    std::uint64_t triangles = 0; // of the last draw
    double errorPixels = 1; // more of them bring level upon level close to the eye

    // Pixels without ground, at the levels that an eye needs (usually the same); places of all pixels where they are asked for: texel
    // x and z, height, and 1, or kNothing.
    static constexpr glm::vec4 kNothing{-1};
    int holes(const renderer::Eye& eye, const renderer::Eye& levelsFor, renderer::GroundStages stages, std::vector<glm::vec4>* places = nullptr);
    // The same seen by the sun, over `width` m around `middle`, at the level of detail of a cascade with texels of `texel` m.
    int holesForSun(const glm::dvec3& towardSun, const glm::dvec3& middle, double width, double texel);

private:
    enum class By { Camera, Sun };
    template <class Draw> int draw(const renderer::Eye& eye, const renderer::Eye& levelsFor, By by, Draw&& draws, std::vector<glm::vec4>& places);

    glm::ivec2 m_size;
    renderer::ShaderLibrary m_shaders;
    renderer::GpuStream m_stream;
    renderer::PassTimers m_timers;
    renderer::FrameStats m_stats;
    renderer::gl::VertexArray m_empty;
    renderer::gl::Texture m_colour, m_depth;
    renderer::gl::Framebuffer m_target;
    renderer::Terrain m_terrain;
};

} // namespace test
