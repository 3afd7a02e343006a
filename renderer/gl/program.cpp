#include "renderer/gl/program.h"

#include <vector>

namespace renderer::gl {
namespace {

using Shader = Handle<DeleteShader>;

Shader compile(const StageText& stage, std::string& log)
{
    Shader shader{glCreateShader(stage.stage)};
    const char* text = stage.text.c_str();
    glShaderSource(shader.get(), 1, &text, nullptr);
    glCompileShader(shader.get());
    GLint ok = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    GLint length = 0;
    glGetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &length);
    log.resize(std::size_t(length) + 1);
    glGetShaderInfoLog(shader.get(), length + 1, &length, log.data());
    log.resize(std::size_t(length));
    return {};
}

} // namespace

Program link(std::string_view label, std::span<const StageText> stages, BuildLog& log)
{
    Handle<DeleteProgram> program{glCreateProgram()};
    std::vector<Shader> shaders;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        log.stage = int(i);
        shaders.push_back(compile(stages[i], log.text));
        if (!shaders.back().get()) return {};
        glAttachShader(program.get(), shaders.back().get());
    }
    log.stage = -1;
    glLinkProgram(program.get());
    for (const Shader& shader : shaders)
        glDetachShader(program.get(), shader.get());
    GLint ok = 0;
    glGetProgramiv(program.get(), GL_LINK_STATUS, &ok);
    if (!ok) {
        GLint length = 0;
        glGetProgramiv(program.get(), GL_INFO_LOG_LENGTH, &length);
        log.text.resize(std::size_t(length) + 1);
        glGetProgramInfoLog(program.get(), length + 1, &length, log.text.data());
        log.text.resize(std::size_t(length));
        return {};
    }
    glObjectLabel(GL_PROGRAM, program.get(), GLsizei(label.size()), label.data());
    return Program{std::move(program)};
}

} // namespace renderer::gl
