#include "renderer/gpu_frame.h"

#include <cstring>

namespace renderer {
namespace {

constexpr std::size_t kFramesKept = 6; // a driver that lags further than this has its oldest times dropped

} // namespace

Query PassTimers::take()
{
    if (!m_free.empty()) {
        Query query = std::move(m_free.back());
        m_free.pop_back();
        return query;
    }
    GLuint id = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &id);
    return Query{id};
}

void PassTimers::submit(Passes passes)
{
    m_waiting.push_back(std::move(passes));
    readFinished();
}

void PassTimers::readFinished()
{
    while (!m_waiting.empty()) {
        Passes& passes = m_waiting.front();
        GLint ready = GL_TRUE;
        if (!passes.empty()) glGetQueryObjectiv(passes.back().end.get(), GL_QUERY_RESULT_AVAILABLE, &ready);
        if (!ready && m_waiting.size() < kFramesKept) return;
        if (ready) m_read.clear();
        for (Pass& pass : passes) {
            GLuint64 begin = 0, end = 0;
            if (ready) {
                glGetQueryObjectui64v(pass.begin.get(), GL_QUERY_RESULT, &begin);
                glGetQueryObjectui64v(pass.end.get(), GL_QUERY_RESULT, &end);
                m_read.emplace_back(pass.name, double(end - begin) * 1e-6);
            }
            m_free.push_back(std::move(pass.begin));
            m_free.push_back(std::move(pass.end));
        }
        m_waiting.pop_front();
    }
}

double PassTimers::gpuMs(const char* name) const
{
    for (const auto& [known, ms] : m_read)
        if (std::strcmp(known, name) == 0) return ms;
    return 0;
}

GpuFrame::GpuFrame(GpuStream& stream, PassTimers& timers, FrameStats& stats, const gl::VertexArray& empty)
    : m_stream{stream}, m_timers{timers}, m_stats{stats}, m_empty{empty}
{
    m_stream.beginFrame();
    m_stats = {};
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); // with reversed depth, floats are fine where depth is far
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

GpuFrame::~GpuFrame()
{
    for (const PassTimers::Pass& pass : m_passes)
        m_stats.passes.push_back({.name = pass.name, .cpuMs = pass.cpuMs, .gpuMs = m_timers.gpuMs(pass.name)});
    m_timers.submit(std::move(m_passes));
    m_stream.endFrame();
    gl::restoreDefaults();
}

GpuFrame::Scope::Scope(GpuFrame& frame, const char* name)
    : m_frame{frame}, m_index{frame.m_passes.size()}, m_start{std::chrono::steady_clock::now()}
{
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
    frame.m_passes.push_back({.name = name, .begin = frame.m_timers.take(), .end = frame.m_timers.take()});
    glQueryCounter(frame.m_passes.back().begin.get(), GL_TIMESTAMP);
}

GpuFrame::Scope::~Scope()
{
    PassTimers::Pass& pass = m_frame.m_passes[m_index];
    glQueryCounter(pass.end.get(), GL_TIMESTAMP);
    glPopDebugGroup();
    pass.cpuMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_start).count();
}

bool GpuFrame::use(const gl::Program& program, std::initializer_list<TextureBinding> reads)
{
    if (!program) return false;
    glUseProgram(program.id());
    bind(reads);
    return true;
}

void GpuFrame::bind(std::initializer_list<TextureBinding> reads)
{
    for (const TextureBinding& read : reads)
        if (read.texture) glBindTextureUnit(GLuint(read.unit), read.texture->id());
}

void GpuFrame::fullScreen(const gl::Program& program, const gl::DrawState& state,
                          std::initializer_list<TextureBinding> reads)
{
    if (!use(program, reads)) return;
    gl::apply(state);
    glBindVertexArray(m_empty.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    count(1, 1);
}

void GpuFrame::count(std::uint64_t commands, std::uint64_t triangles)
{
    m_stats.drawCalls += commands;
    m_stats.trianglesSubmitted += triangles;
}

} // namespace renderer
