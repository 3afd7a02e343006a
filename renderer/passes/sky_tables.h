// The tables of the sky, made again when the sun, the air or the eye's height changed, and the tiling noise.
#pragma once

#include "renderer/gl/buffer.h"
#include "renderer/gpu_frame.h"
#include "renderer/shader_library.h"
#include "renderer/shaders/shared/heavens.h"
#include "renderer/shaders/shared/light.h"

namespace renderer {

class SkyTables {
public:
    explicit SkyTables(ShaderLibrary& shaders);

    // Costs nothing while sun, air and the eye's height stand. The blocks of both are bound.
    void update(GpuFrame& gpu, const glsl::Light& light, const glsl::Heavens& heavens);
    void bind(GpuFrame& gpu) const; // tables, noise, and the block of the sky's light

private:
    void makeNoise(GpuFrame& gpu);
    void drawAirTables(GpuFrame& gpu);
    void drawSky(GpuFrame& gpu);
    void drawCloudMap(GpuFrame& gpu, const glsl::Light& light);

    struct Target {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    static Target makeTarget(std::string_view label, glm::ivec2 size);

    const gl::Program &m_transmittanceProgram, &m_scatterOnceProgram, &m_multiScatterProgram, &m_skyViewProgram, &m_skyMirrorProgram,
        &m_aerialProgram, &m_skyLightProgram, &m_noiseProgram, &m_cloudMapProgram;
    Target m_transmittance, m_scatteredOnce, m_multiScatter, m_skyView, m_skyMirror, m_noise, m_cloudMap;
    gl::Texture m_aerial; // an array of distances
    gl::Buffer m_skyLight;
    glsl::Atmosphere m_air{};        // of the tables as they are
    glm::vec3 m_towardSun{0};
    float m_sunRadius = -1;
    glm::vec4 m_clouds{-1};          // of the map: its middle, edge and width
    bool m_noiseMade = false;
};

} // namespace renderer
