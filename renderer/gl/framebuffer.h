// A framebuffer: which textures a pass draws into.
#pragma once

#include "renderer/gl/texture.h"

#include <string_view>
#include <vector>

namespace renderer::gl {

struct DeleteFramebuffer {
    void operator()(GLuint id) const { glDeleteFramebuffers(1, &id); }
};

struct FramebufferDesc {
    std::string_view label;
    std::vector<const Texture*> colours;
    const Texture* depth = nullptr;
    int depthLayer = 0; // of an array
};

class Framebuffer {
public:
    Framebuffer() = default;
    explicit Framebuffer(const FramebufferDesc& desc);

    GLuint id() const { return m_handle.get(); }
    glm::ivec2 size() const { return m_size; }
    void bind() const; // draw framebuffer, and a viewport that covers it
    void clearColour(int index, const glm::vec4& value) const { glClearNamedFramebufferfv(id(), GL_COLOR, index, &value.x); }
    void clearDepth(float value) const; // turns depth writes on, as a clear needs

private:
    Handle<DeleteFramebuffer> m_handle;
    glm::ivec2 m_size{0};
};

} // namespace renderer::gl
