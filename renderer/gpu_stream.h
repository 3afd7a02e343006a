// Memory that the CPU fills and the GPU reads within one frame: mapped for good, written without waiting.
#pragma once

#include "renderer/gl/buffer.h"

#include <array>
#include <cstring>
#include <vector>

namespace renderer {

struct DeleteSync {
    void operator()(GLsync sync) const { glDeleteSync(sync); }
};

class GpuStream {
public:
    struct Piece {
        GLuint buffer = 0;
        std::size_t offset = 0;
        std::span<std::byte> bytes; // write only, front to back
    };
    GpuStream() = default;
    ~GpuStream();
    GpuStream(const GpuStream&) = delete;
    GpuStream& operator=(const GpuStream&) = delete;

    void beginFrame(); // waits until the GPU has read what was written kFrames ago
    void endFrame();
    Piece take(std::size_t bytes);
    std::size_t taken() const { return m_taken; } // bytes, of this frame

    template <class T>
    Piece put(std::span<const T> values)
    {
        const Piece piece = take(values.size_bytes());
        std::memcpy(piece.bytes.data(), values.data(), values.size_bytes());
        return piece;
    }

private:
    static constexpr int kFrames = 3;
    struct Chunk {
        gl::Buffer buffer;
        std::byte* memory = nullptr;
    };
    struct Frame {
        std::vector<Chunk> chunks; // usually one; more when a frame needed more than those before
        GLsync done = nullptr;
    };
    static Chunk makeChunk(std::size_t bytes);

    std::array<Frame, kFrames> m_frames;
    int m_current = 0;
    std::size_t m_used = 0; // of the last chunk
    std::size_t m_taken = 0;
};

} // namespace renderer
