// A buffer object with immutable storage, and what reads from one: a buffer texture, a vertex array.
#pragma once

#include "renderer/gl/handle.h"
#include "renderer/gl/texture.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace renderer::gl {

struct DeleteBuffer {
    void operator()(GLuint id) const { glDeleteBuffers(1, &id); }
};
struct DeleteVertexArray {
    void operator()(GLuint id) const { glDeleteVertexArrays(1, &id); }
};

class Buffer {
public:
    Buffer() = default;
    Buffer(std::string_view label, std::size_t bytes, GLbitfield flags = GL_DYNAMIC_STORAGE_BIT);

    GLuint id() const { return m_handle.get(); }
    std::size_t bytes() const { return m_bytes; }
    void write(std::size_t offset, std::span<const std::byte> data);

private:
    Handle<DeleteBuffer> m_handle;
    Footprint m_footprint;
    std::size_t m_bytes = 0;
};

// Grows `buffer` to hold at least `bytes`, keeping the first `keep` bytes. True when it is another buffer now.
bool grow(Buffer& buffer, std::string_view label, std::size_t bytes, std::size_t keep);

// A buffer, or a part of one, that shaders read as texels.
class BufferTexture {
public:
    BufferTexture() = default;
    BufferTexture(std::string_view label, GLenum format);
    void source(GLuint buffer, std::size_t offset, std::size_t bytes);
    GLuint id() const { return m_handle.get(); }

private:
    Handle<DeleteTexture> m_handle;
    GLenum m_format = GL_R32UI;
};

class VertexArray {
public:
    VertexArray() = default;
    explicit VertexArray(std::string_view label);

    GLuint id() const { return m_handle.get(); }
    void attribute(int location, int binding, int components, GLenum type, std::size_t offset, bool normalized = false);
    void integers(int location, int binding, int components, GLenum type, std::size_t offset);
    void perInstance(int binding) { glVertexArrayBindingDivisor(id(), GLuint(binding), 1); }
    void source(int binding, GLuint buffer, std::size_t offset, std::size_t stride);
    void indices(GLuint buffer) { glVertexArrayElementBuffer(id(), buffer); }

private:
    Handle<DeleteVertexArray> m_handle;
};

} // namespace renderer::gl
