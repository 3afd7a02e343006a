// The tables of the sky, made again when the sun, the air or the eye's height changed, and the tiling noise.
#pragma once

#include "renderer/gl/buffer.h"
#include "renderer/gpu_frame.h"
#include "renderer/shader_library.h"
#include "renderer/shaders/shared/clouds.h"
#include "renderer/shaders/shared/light.h"

namespace renderer {

class SkyTables {
public:
    explicit SkyTables(ShaderLibrary& shaders);

    void update(GpuFrame& gpu, const glsl::Light& light, const glsl::Clouds& clouds); // their blocks are bound
    void bind(GpuFrame& gpu) const;                       // tables, noise, and the block of the sky's light

private:
    void makeNoise(GpuFrame& gpu);
    void drawAirTables(GpuFrame& gpu);
    void drawSkyView(GpuFrame& gpu);
    void gatherSkyLight(GpuFrame& gpu);

    struct Target {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    static Target makeTarget(std::string_view label, glm::ivec2 size);

    const gl::Program &m_transmittanceProgram, &m_multiScatterProgram, &m_skyViewProgram, &m_skyLightProgram, &m_noiseProgram;
    Target m_transmittance, m_multiScatter, m_skyView, m_noise;
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
