// What the editor draws over the finished picture: the outline of what is selected, and lines in the world.
#pragma once

#include "renderer/passes/picture.h"

namespace renderer {

class OverlayPass {
public:
    explicit OverlayPass(ShaderLibrary& shaders);

    // `selected`: bounds of what is selected, so that only its part of the picture is searched.
    void render(GpuFrame& gpu, PictureTarget& canvas, const GBuffer& surfaces, const Viewpoint& viewpoint,
                const io::WorldBox& selected, std::span<const Line> lines);

private:
    void drawOutline(GpuFrame& gpu, const Eye& eye, const io::WorldBox& selected);
    void drawLines(GpuFrame& gpu, const Eye& eye, std::span<const Line> lines);

    const gl::Program &m_outline, &m_line;
    gl::VertexArray m_lines;
};

} // namespace renderer
