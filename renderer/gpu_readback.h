// Figures that the GPU counts in each frame, read some frames later, when that cannot wait.
#pragma once

#include "renderer/gl/buffer.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace renderer {

template <class T> class GpuReadback {
public:
    explicit GpuReadback(std::string_view label) : m_label{label} {}
    ~GpuReadback()
    {
        for (Read& read : m_reads)
            if (read.done) glDeleteSync(read.done);
    }
    GpuReadback(const GpuReadback&) = delete;
    GpuReadback& operator=(const GpuReadback&) = delete;

    // The newest figures that have come since the last call.
    std::optional<T> arrived()
    {
        std::optional<T> newest;
        for (Read& read : m_reads) {
            if (!read.done || glClientWaitSync(read.done, 0, 0) == GL_TIMEOUT_EXPIRED) continue;
            glDeleteSync(std::exchange(read.done, nullptr));
            newest = *read.memory;
        }
        return newest;
    }
    // Sends for what lies in `buffer` now; left out while too many are under way.
    void ask(const gl::Buffer& buffer)
    {
        constexpr GLbitfield kFlags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
        Read& next = m_reads[m_next];
        if (next.done) return;
        m_next = (m_next + 1) % m_reads.size();
        if (!next.memory) {
            next.buffer = gl::Buffer{m_label, sizeof(T), kFlags};
            next.memory = static_cast<const T*>(glMapNamedBufferRange(next.buffer.id(), 0, sizeof(T), kFlags));
        }
        glCopyNamedBufferSubData(buffer.id(), next.buffer.id(), 0, 0, sizeof(T));
        next.done = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    }

private:
    struct Read {
        gl::Buffer buffer;
        const T* memory = nullptr;
        GLsync done = nullptr;
    };
    std::string_view m_label;
    std::array<Read, 4> m_reads;
    std::size_t m_next = 0;
};

} // namespace renderer
