#include "renderer/gl/buffer.h"

#include "io/base/contract.h"

#include <algorithm>

namespace renderer::gl {

Buffer::Buffer(std::string_view label, std::size_t bytes, GLbitfield flags) : m_footprint{MemoryKind::Buffers, bytes}, m_bytes{bytes}
{
    EXPECTS(bytes > 0);
    GLuint id = 0;
    glCreateBuffers(1, &id);
    m_handle = Handle<DeleteBuffer>{id};
    glNamedBufferStorage(id, GLsizeiptr(bytes), nullptr, flags);
    expectMemory();
    glObjectLabel(GL_BUFFER, id, GLsizei(label.size()), label.data());
}

void Buffer::write(std::size_t offset, std::span<const std::byte> data)
{
    EXPECTS(offset + data.size() <= m_bytes);
    if (!data.empty()) glNamedBufferSubData(id(), GLintptr(offset), GLsizeiptr(data.size()), data.data());
}

bool grow(Buffer& buffer, std::string_view label, std::size_t bytes, std::size_t keep)
{
    if (bytes <= buffer.bytes()) return false;
    Buffer larger{label, std::max(bytes, buffer.bytes() * 2)};
    if (keep) {
        glCopyNamedBufferSubData(buffer.id(), larger.id(), 0, 0, GLsizeiptr(keep));
        glFinish(); // NVIDIA 580 lets writes that follow overtake the copy; growing is rare
    }
    buffer = std::move(larger);
    return true;
}

BufferTexture::BufferTexture(std::string_view label, GLenum format) : m_format{format}
{
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
    m_handle = Handle<DeleteTexture>{id};
    glObjectLabel(GL_TEXTURE, id, GLsizei(label.size()), label.data());
}

void BufferTexture::source(GLuint buffer, std::size_t offset, std::size_t bytes)
{
    glTextureBufferRange(id(), m_format, buffer, GLintptr(offset), GLsizeiptr(bytes));
}

VertexArray::VertexArray(std::string_view label)
{
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    m_handle = Handle<DeleteVertexArray>{id};
    glObjectLabel(GL_VERTEX_ARRAY, id, GLsizei(label.size()), label.data());
}

void VertexArray::attribute(int location, int binding, int components, GLenum type, std::size_t offset, bool normalized)
{
    glEnableVertexArrayAttrib(id(), GLuint(location));
    glVertexArrayAttribFormat(id(), GLuint(location), components, type, normalized, GLuint(offset));
    glVertexArrayAttribBinding(id(), GLuint(location), GLuint(binding));
}

void VertexArray::integers(int location, int binding, int components, GLenum type, std::size_t offset)
{
    glEnableVertexArrayAttrib(id(), GLuint(location));
    glVertexArrayAttribIFormat(id(), GLuint(location), components, type, GLuint(offset));
    glVertexArrayAttribBinding(id(), GLuint(location), GLuint(binding));
}

void VertexArray::source(int binding, GLuint buffer, std::size_t offset, std::size_t stride)
{
    glVertexArrayVertexBuffer(id(), GLuint(binding), buffer, GLintptr(offset), GLsizei(stride));
}

} // namespace renderer::gl
