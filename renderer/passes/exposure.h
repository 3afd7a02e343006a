// Automatic exposure. The GPU measures the picture and keeps what it chose: nothing is read back.
#pragma once

#include "renderer/gl/buffer.h"
#include "renderer/passes/lighting.h"
#include "renderer/shaders/shared/exposure.h"

namespace renderer {

class ExposurePass {
public:
    explicit ExposurePass(ShaderLibrary& shaders);

    // Binds the camera's block, with the exposure that was chosen for the frame before where there is one.
    void bind(GpuFrame& gpu, const glsl::View& view);

    // Chooses this frame's, binds the camera's block with it, and the block of what was chosen. `seconds` since the frame
    // before; none: all of the way at once, whatever came before.
    void choose(GpuFrame& gpu, const Radiance& radiance, const GBuffer& surfaces, const glsl::View& view,
                const io::AutoExposure& wanted, std::optional<double> seconds);
    void forget() { m_chosen = false; } // by hand from now on

    bool chosen() const { return m_chosen; }
    double read() const; // EV; waits for the GPU

private:
    const gl::Program& m_program;
    gl::Buffer m_buffer;
    bool m_chosen = false; // the buffer holds what the frame before was shown with
};

// Of the way from one exposure to another, after so many seconds.
double adapted(double seconds, double secondsForTwoThirds);

} // namespace renderer
