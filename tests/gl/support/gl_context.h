// An OpenGL context without a window, for tests: EGL's surfaceless platform, else its first device.
#pragma once

#include <string>

namespace test {

class GlContext {
public:
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    bool valid() const { return m_context != nullptr; }
    const std::string& fault() const { return m_fault; }

private:
    void* m_display = nullptr;
    void* m_context = nullptr;
    std::string m_fault;
};

} // namespace test
