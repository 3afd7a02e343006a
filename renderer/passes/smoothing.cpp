#include "renderer/passes/smoothing.h"

#include "renderer/shaders/shared/bindings.h"

namespace renderer {

void SmoothingPass::Target::resize(std::string_view label, glm::ivec2 size, GLenum format)
{
    if (texture.size() == size) return;
    texture = gl::Texture{{.label = label, .size = size, .format = format, .filter = GL_NEAREST, .target = true}};
    framebuffer = gl::Framebuffer{{.label = label, .colours = {&texture}}};
}

SmoothingPass::SmoothingPass(ShaderLibrary& shaders) : m_fxaa{shaders.fullScreen("fxaa")}, m_shaders{shaders} {}

PictureTarget& SmoothingPass::begin(PictureTarget& canvas, AntiAliasing kind)
{
    if (kind != AntiAliasing::Fxaa && kind != AntiAliasing::Smaa) return canvas;
    m_rough.resize("picture with rough edges", canvas.texture.size());
    glTextureParameteri(m_rough.texture.id(), GL_TEXTURE_SWIZZLE_A, GL_ALPHA); // the brightness
    return m_rough;
}

void SmoothingPass::finish(GpuFrame& gpu, PictureTarget& canvas, AntiAliasing kind)
{
    if (kind != AntiAliasing::Fxaa && kind != AntiAliasing::Smaa) return;
    const auto scope = gpu.scope("smooth edges");
    if (kind == AntiAliasing::Smaa) findEdges(gpu);

    // Most pixels lie on no edge: they are copied, and the smoothing writes the rest.
    const glm::ivec2 size = canvas.texture.size();
    glCopyImageSubData(m_rough.texture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, canvas.texture.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       size.x, size.y, 1);
    canvas.framebuffer.bind();
    if (kind == AntiAliasing::Fxaa) gpu.fullScreen(m_fxaa, {}, {{IMAGE_UNIT, &m_rough.texture}});
    else gpu.fullScreen(m_shaders.fullScreen("smaa_blend"), {}, {{IMAGE_UNIT, &m_rough.texture}, {HISTORY_UNIT, &m_weights.texture}});
}

void SmoothingPass::findEdges(GpuFrame& gpu)
{
    const glm::ivec2 size = m_rough.texture.size();
    m_edges.resize("edges", size, GL_RG8);
    m_weights.resize("weights of edges", size, GL_RGBA8);
    m_edges.framebuffer.clearColour(0, glm::vec4{0});
    m_edges.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("smaa_edges"), {}, {{HISTORY_UNIT, &m_rough.texture}});
    m_weights.framebuffer.clearColour(0, glm::vec4{0});
    m_weights.framebuffer.bind();
    gpu.fullScreen(m_shaders.fullScreen("smaa_weights"), {}, {{HISTORY_UNIT, &m_edges.texture}});
}

} // namespace renderer
