// A linked program, from the text of its stages.
#pragma once

#include "renderer/gl/handle.h"

#include <span>
#include <string>
#include <string_view>

namespace renderer::gl {

struct DeleteProgram {
    void operator()(GLuint id) const { glDeleteProgram(id); }
};
struct DeleteShader {
    void operator()(GLuint id) const { glDeleteShader(id); }
};

class Program {
public:
    Program() = default;
    explicit Program(Handle<DeleteProgram> handle) : m_handle{std::move(handle)} {}
    GLuint id() const { return m_handle.get(); }
    explicit operator bool() const { return id() != 0; }

private:
    Handle<DeleteProgram> m_handle;
};

struct StageText {
    GLenum stage = GL_VERTEX_SHADER;
    std::string text;
};

// What the compiler said, and of which stage it said it (the linker: -1).
struct BuildLog {
    int stage = -1;
    std::string text;
};

// An empty program and a filled log when a stage does not compile or the stages do not fit together.
Program link(std::string_view label, std::span<const StageText> stages, BuildLog& log);

} // namespace renderer::gl
