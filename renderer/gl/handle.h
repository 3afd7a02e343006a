// Owner of one OpenGL name. Moves are written once, here; every class above it follows the rule of zero.
#pragma once

#include <array>
#include <cstdint>
#include <epoxy/gl.h>
#include <new>
#include <numeric>
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

enum class MemoryKind { Buffers, Textures, ShadowMaps, Targets }; // targets: what passes draw into

// Counts the bytes of a buffer or texture for as long as it lives.
class Footprint {
public:
    Footprint() = default;
    Footprint(MemoryKind kind, std::uint64_t bytes) : m_kind{kind}, m_bytes{bytes} { s_totals[std::size_t(kind)] += bytes; }
    Footprint(Footprint&& other) noexcept : m_kind{other.m_kind}, m_bytes{std::exchange(other.m_bytes, 0)} {}
    Footprint& operator=(Footprint other) noexcept
    {
        std::swap(m_kind, other.m_kind);
        std::swap(m_bytes, other.m_bytes);
        return *this;
    }
    ~Footprint() { s_totals[std::size_t(m_kind)] -= m_bytes; }
    static std::uint64_t total(MemoryKind kind) { return s_totals[std::size_t(kind)]; }
    static std::uint64_t total() { return std::accumulate(s_totals.begin(), s_totals.end(), std::uint64_t(0)); }

private:
    MemoryKind m_kind = MemoryKind::Buffers;
    std::uint64_t m_bytes = 0;
    inline static std::array<std::uint64_t, 4> s_totals{}; // GL lives on the main thread
};

} // namespace renderer::gl
