#include "renderer/gl/state.h"

namespace renderer::gl {
namespace {

void enable(GLenum capability, bool on)
{
    on ? glEnable(capability) : glDisable(capability);
}

void applyBlend(Blend blend)
{
    glDisable(GL_BLEND);
    if (blend == Blend::None) return;
    glEnablei(GL_BLEND, 0);
    glBlendEquation(GL_FUNC_ADD);
    switch (blend) {
    case Blend::None: break;
    case Blend::Alpha: glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    case Blend::Add: glBlendFunc(GL_ONE, GL_ONE); break;
    case Blend::Over: glBlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE); break;
    }
}

} // namespace

void apply(const DrawState& state)
{
    const bool depth = state.depthTest != GL_ALWAYS || state.depthWrite;
    enable(GL_DEPTH_TEST, depth);
    glDepthFunc(state.depthTest);
    glDepthMask(state.depthWrite);
    enable(GL_CULL_FACE, state.cull != GL_NONE);
    if (state.cull != GL_NONE) glCullFace(state.cull);
    glFrontFace(state.clockwise ? GL_CW : GL_CCW);
    enable(GL_DEPTH_CLAMP, state.depthClamp);
    glPolygonMode(GL_FRONT_AND_BACK, state.lines ? GL_LINE : GL_FILL);
    const bool offset = state.depthOffset != glm::vec2{0};
    enable(GL_POLYGON_OFFSET_FILL, offset);
    enable(GL_POLYGON_OFFSET_LINE, offset);
    glPolygonOffset(state.depthOffset.x, state.depthOffset.y);
    applyBlend(state.blend);
}

void restoreDefaults()
{
    apply({});
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_SCISSOR_TEST);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
    glUseProgram(0);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace renderer::gl
