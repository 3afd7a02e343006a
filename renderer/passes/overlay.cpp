#include "renderer/passes/overlay.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace renderer {
namespace {

constexpr int kOutlineReach = 3; // pixels

struct LineVertex { // one record a line
    glm::vec3 from{0}; // relative to the eye
    glm::vec3 to{0};
    glm::vec4 colour{1};
    float onTop = 0;
};
static_assert(sizeof(LineVertex) == 44);

struct PixelBox {
    glm::ivec2 low{0}, size{0};
};

// The part of the picture that a box can cover; all of it when the box reaches behind the eye.
PixelBox pixelsOf(const Eye& eye, const io::WorldBox& box)
{
    glm::dvec2 low{1e30}, high{-1e30};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                           corner & 4 ? box.max.z : box.min.z};
        const glm::dvec4 clip = eye.clipFromRelative * glm::dvec4{p - eye.position, 1};
        if (clip.w < kNear) return {{0, 0}, eye.size};
        const glm::dvec2 pixel = (glm::dvec2{clip} / clip.w * 0.5 + 0.5) * glm::dvec2{eye.size};
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    const glm::dvec2 most{eye.size};
    const glm::ivec2 first{glm::clamp(glm::floor(low) - double(kOutlineReach), glm::dvec2{0}, most)};
    const glm::ivec2 last{glm::clamp(glm::ceil(high) + double(kOutlineReach), glm::dvec2{0}, most)};
    return {first, last - first};
}

// The part of a line that lies before the near plane; false when none does.
bool clipped(glm::dvec3& a, glm::dvec3& b, const glm::dvec3& forward)
{
    const double da = glm::dot(a, forward) - kNear, db = glm::dot(b, forward) - kNear;
    if (da <= 0 && db <= 0) return false;
    if (da < 0) a = glm::mix(a, b, da / (da - db));
    if (db < 0) b = glm::mix(b, a, db / (db - da));
    return true;
}

} // namespace

OverlayPass::OverlayPass(ShaderLibrary& shaders)
    : m_outline{shaders.fullScreen("outline")},
      m_line{shaders.program({.label = "lines", .stages = {"lines.vert.glsl", "lines.frag.glsl"}})}, m_lines{"lines"}
{
    m_lines.attribute(0, 0, 3, GL_FLOAT, offsetof(LineVertex, from));
    m_lines.attribute(1, 0, 3, GL_FLOAT, offsetof(LineVertex, to));
    m_lines.attribute(2, 0, 4, GL_FLOAT, offsetof(LineVertex, colour));
    m_lines.attribute(3, 0, 1, GL_FLOAT, offsetof(LineVertex, onTop));
    m_lines.perInstance(0);
}

void OverlayPass::render(GpuFrame& gpu, PictureTarget& canvas, const GBuffer& surfaces, const Viewpoint& viewpoint,
                         const io::WorldBox& selected, std::span<const Line> lines)
{
    if (selected.empty() && lines.empty()) return;
    const auto scope = gpu.scope("overlay");
    canvas.framebuffer.bind();
    surfaces.bind(gpu);
    if (!selected.empty()) drawOutline(gpu, viewpoint.eye, selected);
    if (!lines.empty()) drawLines(gpu, viewpoint.eye, lines);
}

void OverlayPass::drawOutline(GpuFrame& gpu, const Eye& eye, const io::WorldBox& selected)
{
    const PixelBox box = pixelsOf(eye, selected);
    if (box.size.x <= 0 || box.size.y <= 0) return;
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.low.x, box.low.y, box.size.x, box.size.y);
    gpu.fullScreen(m_outline, {.blend = gl::Blend::Alpha}, {});
    glDisable(GL_SCISSOR_TEST);
}

void OverlayPass::drawLines(GpuFrame& gpu, const Eye& eye, std::span<const Line> lines)
{
    std::vector<LineVertex> records;
    records.reserve(lines.size());
    for (const Line& line : lines) {
        glm::dvec3 from = line.from - eye.position, to = line.to - eye.position;
        if (clipped(from, to, eye.forward))
            records.push_back({glm::vec3{from}, glm::vec3{to}, line.colour, line.onTop ? 1.0f : 0.0f});
    }
    if (records.empty() || !gpu.use(m_line)) return;
    const GpuStream::Piece piece = gpu.stream().put(std::span<const LineVertex>{records});
    m_lines.source(0, piece.buffer, piece.offset, sizeof(LineVertex));
    gl::apply({.blend = gl::Blend::Alpha});
    glBindVertexArray(m_lines.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(records.size()));
    gpu.count(1, records.size() * 2);
}

} // namespace renderer
