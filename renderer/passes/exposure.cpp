#include "renderer/passes/exposure.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace renderer {

double adapted(double seconds, double secondsForTwoThirds)
{
    return secondsForTwoThirds > 0 ? 1 - std::exp(-std::max(seconds, 0.0) / secondsForTwoThirds) : 1;
}

ExposurePass::ExposurePass(ShaderLibrary& shaders)
    : m_program{shaders.program({.label = "exposure", .stages = {"exposure.comp.glsl"}})},
      m_buffer{"chosen exposure", sizeof(glsl::ChosenExposure)}
{
}

void ExposurePass::bind(GpuFrame& gpu, const glsl::View& view)
{
    const GpuStream::Piece piece = gpu.stream().put(std::span{&view, 1});
    if (m_chosen)
        glCopyNamedBufferSubData(m_buffer.id(), piece.buffer, offsetof(glsl::ChosenExposure, exposure),
                                 GLintptr(piece.offset + offsetof(glsl::View, exposure)), sizeof(float));
    glBindBufferRange(GL_UNIFORM_BUFFER, VIEW_BINDING, piece.buffer, GLintptr(piece.offset), sizeof(glsl::View));
}

void ExposurePass::choose(GpuFrame& gpu, const Radiance& radiance, const GBuffer& surfaces, const glsl::View& view,
                          const io::AutoExposure& wanted, std::optional<double> seconds)
{
    const auto scope = gpu.scope("exposure");
    if (!m_chosen) { // the one by hand was drawn with
        const glsl::ChosenExposure start{.exposure = view.exposure, .before = view.exposure, .ev = std::log2(view.exposure), .target = 0};
        m_buffer.write(0, std::as_bytes(std::span{&start, 1}));
    }
    const bool atOnce = !m_chosen || !seconds;
    const glsl::Metering metering{.compensation = wanted.compensation,
                                  .lowest = std::min(wanted.lowest, wanted.highest),
                                  .highest = std::max(wanted.lowest, wanted.highest),
                                  .share = atOnce ? 1.0f : float(adapted(*seconds, wanted.seconds)),
                                  .darkness = wanted.darkness};
    surfaces.bind(gpu);
    gpu.constants(PASS_BINDING, metering);
    if (!gpu.use(m_program, {{IMAGE_UNIT, &radiance.texture}})) return;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, EXPOSURE_STORAGE_BINDING, m_buffer.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT);
    m_chosen = true;
    bind(gpu, view);
    glBindBufferBase(GL_UNIFORM_BUFFER, PICTURE_BINDING, m_buffer.id());
}

double ExposurePass::read() const
{
    glsl::ChosenExposure held{};
    glGetNamedBufferSubData(m_buffer.id(), 0, sizeof held, &held);
    return held.ev;
}

} // namespace renderer
