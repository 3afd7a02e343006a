#include "renderer/gl/debug.h"

#include "io/base/log.h"

#include <epoxy/gl.h>

namespace renderer::gl {
namespace {

void GLAPIENTRY onMessage(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                          const void* errors)
{
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return; // the shader library reports those by file and line
    const std::string_view message{text, std::size_t(length)};
    if (type == GL_DEBUG_TYPE_ERROR) {
        ++*static_cast<std::uint64_t*>(const_cast<void*>(errors));
        io::log::error("OpenGL: {}", message);
    } else if (severity == GL_DEBUG_SEVERITY_HIGH) {
        io::log::warning("OpenGL: {}", message);
    } else {
        io::log::debug("OpenGL: {}", message);
    }
}

} // namespace

DebugOutput::DebugOutput(bool synchronous)
{
    glEnable(GL_DEBUG_OUTPUT);
    if (synchronous) glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    // Our own groups come back as messages; they are for debuggers, not for the log.
    glDebugMessageControl(GL_DEBUG_SOURCE_APPLICATION, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
    glDebugMessageCallback(onMessage, &m_errors);
}

DebugOutput::~DebugOutput()
{
    glDebugMessageCallback(nullptr, nullptr);
}

} // namespace renderer::gl
