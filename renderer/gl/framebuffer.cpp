#include "renderer/gl/framebuffer.h"

#include "io/base/contract.h"

namespace renderer::gl {

Framebuffer::Framebuffer(const FramebufferDesc& desc)
{
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    m_handle = Handle<DeleteFramebuffer>{id};
    glObjectLabel(GL_FRAMEBUFFER, id, GLsizei(desc.label.size()), desc.label.data());

    std::vector<GLenum> targets;
    for (const Texture* colour : desc.colours) {
        targets.push_back(GLenum(GL_COLOR_ATTACHMENT0 + targets.size()));
        glNamedFramebufferTexture(id, targets.back(), colour->id(), 0);
        m_size = colour->size();
    }
    glNamedFramebufferDrawBuffers(id, GLsizei(targets.size()), targets.data());
    if (desc.depth) {
        m_size = desc.depth->size();
        if (desc.depth->layers()) {
            glNamedFramebufferTextureLayer(id, GL_DEPTH_ATTACHMENT, desc.depth->id(), 0, desc.depthLayer);
        } else {
            glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, desc.depth->id(), 0);
        }
    }
    EXPECTS(glCheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void Framebuffer::bind() const
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id());
    glViewport(0, 0, m_size.x, m_size.y);
}

void Framebuffer::clearDepth(float value) const
{
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(id(), GL_DEPTH, 0, &value);
}

} // namespace renderer::gl
