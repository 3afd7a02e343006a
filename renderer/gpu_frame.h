// One frame in the making: scopes that name and time its passes, the calls that draw, and what they counted.
#pragma once

#include "renderer/gl/framebuffer.h"
#include "renderer/gl/program.h"
#include "renderer/gl/state.h"
#include "renderer/gpu_stream.h"
#include "renderer/renderer.h"

#include <chrono>
#include <deque>
#include <initializer_list>

namespace renderer {

struct DeleteQuery {
    void operator()(GLuint id) const { glDeleteQueries(1, &id); }
};
using Query = gl::Handle<DeleteQuery>;

// GPU times of frames under way. A frame's queries are read some frames later, when that cannot wait.
class PassTimers {
public:
    struct Pass {
        const char* name = "";
        double cpuMs = 0;
        Query begin, end;
    };
    using Passes = std::vector<Pass>;
    void submit(Passes passes);                        // of the frame just made
    double gpuMs(const char* name) const;              // of the newest frame that is read
    Query take();                                      // a timestamp query, used again and again

private:
    void readFinished();
    std::deque<Passes> m_waiting;
    std::vector<std::pair<const char*, double>> m_read;
    std::vector<Query> m_free;
};

struct TextureBinding {
    int unit = 0;
    const gl::Texture* texture = nullptr;
};

class GpuFrame {
public:
    GpuFrame(GpuStream& stream, PassTimers& timers, FrameStats& stats, const gl::VertexArray& empty);
    ~GpuFrame();
    GpuFrame(const GpuFrame&) = delete;
    GpuFrame& operator=(const GpuFrame&) = delete;

    class Scope { // a debug group and both timers, from birth to death
    public:
        Scope(GpuFrame& frame, const char* name);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        GpuFrame& m_frame;
        std::size_t m_index;
        std::chrono::steady_clock::time_point m_start;
    };
    [[nodiscard]] Scope scope(const char* name) { return Scope{*this, name}; }

    // False when the program never compiled: the draw is left out.
    bool use(const gl::Program& program, std::initializer_list<TextureBinding> reads = {});
    void bind(std::initializer_list<TextureBinding> reads);
    template <class T>
    void constants(GLuint binding, const T& value)
    {
        const GpuStream::Piece piece = m_stream.put(std::span{&value, 1});
        glBindBufferRange(GL_UNIFORM_BUFFER, binding, piece.buffer, GLintptr(piece.offset), sizeof(T));
    }
    void fullScreen(const gl::Program& program, const gl::DrawState& state, std::initializer_list<TextureBinding> reads);
    void count(std::uint64_t commands, std::uint64_t triangles);

    GpuStream& stream() { return m_stream; }
    FrameStats& stats() { return m_stats; }

private:
    GpuStream& m_stream;
    PassTimers& m_timers;
    FrameStats& m_stats;
    const gl::VertexArray& m_empty;
    PassTimers::Passes m_passes;
};

} // namespace renderer
