// The tables of the sky, made again when the sun, the air or the eye's height changed, and the tiling noise.
#pragma once

#include "renderer/gl/buffer.h"
#include "renderer/gpu_frame.h"
#include "renderer/shader_library.h"
#include "renderer/shaders/shared/clouds.h"
#include "renderer/shaders/shared/heavens.h"
#include "renderer/shaders/shared/light.h"

namespace renderer {

class SkyTables {
public:
    explicit SkyTables(ShaderLibrary& shaders);

    void begin(GpuFrame& gpu); // for those that come before update() in a frame: clouds are made of the noise
    // Costs nothing while sun, air, clouds and the eye's height stand. The blocks of all are bound. `exact`: they are not kept while the eye rises
    // or sinks a little.
    void update(GpuFrame& gpu, const glsl::Light& light, const glsl::Heavens& heavens, const glsl::Clouds& clouds, bool exact = false);
    void bind(GpuFrame& gpu) const; // tables, noise, and the block of the sky's light

private:
    void makeNoise(GpuFrame& gpu);
    void drawAirTables(GpuFrame& gpu);
    void drawSky(GpuFrame& gpu);
    void gatherSkyLight(GpuFrame& gpu);

    struct Target {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    static Target makeTarget(std::string_view label, glm::ivec2 size);

    const gl::Program &m_transmittanceProgram, &m_scatterOnceProgram, &m_multiScatterProgram, &m_skyViewProgram, &m_skyMirrorProgram,
        &m_aerialProgram, &m_skyLightProgram, &m_noiseProgram;
    Target m_transmittance, m_scatteredOnce, m_multiScatter, m_skyView, m_skyMirror, m_noise;
    gl::Texture m_aerial; // an array of distances
    gl::Buffer m_skyLight;
    glsl::Atmosphere m_air{};        // of the tables as they are
    glm::vec3 m_towardSun{0};
    float m_sunRadius = -1;
    struct CloudLight { // what of clouds the sky's light depends on
        glm::vec3 sun{-1};
        float cover = 0, through = 0, on = 0;
        bool operator==(const CloudLight&) const = default;
    } m_clouds;
    bool m_noiseMade = false;
};

} // namespace renderer
