// Owner of one OpenGL name. Moves are written once, here; every class above it follows the rule of zero.
#pragma once

#include <cstdint>
#include <epoxy/gl.h>
#include <new>
#include <utility>

namespace renderer::gl {

template <class Delete>
class Handle { // 0 is empty
public:
    Handle() = default;
    explicit Handle(GLuint id) : m_id{id} {}
    Handle(Handle&& other) noexcept : m_id{std::exchange(other.m_id, 0)} {}
    Handle& operator=(Handle other) noexcept
    {
        std::swap(m_id, other.m_id);
        return *this;
    }
    ~Handle()
    {
        if (m_id) Delete{}(m_id);
    }
    GLuint get() const { return m_id; }

private:
    GLuint m_id = 0;
};

// Storage that the device cannot give is what memory is that the machine cannot give: main() says so in one line.
inline void expectMemory()
{
    if (glGetError() == GL_OUT_OF_MEMORY) throw std::bad_alloc{};
}

// Counts the bytes of a buffer or texture for as long as it lives.
class Footprint {
public:
    Footprint() = default;
    explicit Footprint(std::uint64_t bytes) : m_bytes{bytes} { s_total += bytes; }
    Footprint(Footprint&& other) noexcept : m_bytes{std::exchange(other.m_bytes, 0)} {}
    Footprint& operator=(Footprint other) noexcept
    {
        std::swap(m_bytes, other.m_bytes);
        return *this;
    }
    ~Footprint() { s_total -= m_bytes; }
    static std::uint64_t total() { return s_total; }

private:
    std::uint64_t m_bytes = 0;
    inline static std::uint64_t s_total = 0; // GL lives on the main thread
};

} // namespace renderer::gl
