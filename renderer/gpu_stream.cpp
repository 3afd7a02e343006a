#include "renderer/gpu_stream.h"

#include <algorithm>

namespace renderer {
namespace {

constexpr std::size_t kAlignment = 256; // the most that GL may ask of a uniform or storage buffer's offset
constexpr std::size_t kFirstChunk = std::size_t(1) << 20;

} // namespace

GpuStream::~GpuStream()
{
    for (Frame& frame : m_frames)
        if (frame.done) glDeleteSync(frame.done);
}

GpuStream::Chunk GpuStream::makeChunk(std::size_t bytes)
{
    constexpr GLbitfield kFlags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    Chunk chunk{.buffer = gl::Buffer{"stream", bytes, kFlags}};
    chunk.memory = static_cast<std::byte*>(glMapNamedBufferRange(chunk.buffer.id(), 0, GLsizeiptr(bytes), kFlags));
    return chunk;
}

void GpuStream::beginFrame()
{
    m_current = (m_current + 1) % kFrames;
    Frame& frame = m_frames[std::size_t(m_current)];
    if (frame.done) {
        glClientWaitSync(frame.done, GL_SYNC_FLUSH_COMMANDS_BIT, GLuint64(10'000'000'000));
        glDeleteSync(std::exchange(frame.done, nullptr));
    }
    if (frame.chunks.size() > 1) { // one that would have held it all
        std::size_t bytes = 0;
        for (const Chunk& chunk : frame.chunks)
            bytes += chunk.buffer.bytes();
        frame.chunks.clear();
        frame.chunks.push_back(makeChunk(bytes));
    }
    if (frame.chunks.empty()) frame.chunks.push_back(makeChunk(kFirstChunk));
    m_used = m_taken = 0;
}

void GpuStream::endFrame()
{
    m_frames[std::size_t(m_current)].done = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

GpuStream::Piece GpuStream::take(std::size_t bytes)
{
    std::vector<Chunk>& chunks = m_frames[std::size_t(m_current)].chunks;
    if (m_used + bytes > chunks.back().buffer.bytes()) {
        chunks.push_back(makeChunk(std::max(bytes, chunks.back().buffer.bytes() * 2)));
        m_used = 0;
    }
    Chunk& chunk = chunks.back();
    const Piece piece{chunk.buffer.id(), m_used, {chunk.memory + m_used, bytes}};
    m_taken += bytes;
    m_used += (bytes + kAlignment - 1) / kAlignment * kAlignment;
    return piece;
}

} // namespace renderer
