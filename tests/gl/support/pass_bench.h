// One pass by itself: what a frame would hand to it, filled by hand.
#pragma once

#include "renderer/passes/lighting.h"
#include "tests/gl/support/shared_renderer.h"

#include <functional>
#include <memory>

namespace test {

class PassBench {
public:
    PassBench() : shaders{WOLD_SOURCE_DIR "/renderer/shaders"} { m_empty = haveContext() ? renderer::gl::VertexArray{"no vertices"} : renderer::gl::VertexArray{}; }

    // Calls `work` within a frame whose camera block is bound.
    void frame(const glsl::View& view, const std::function<void(renderer::GpuFrame&)>& work)
    {
        renderer::GpuFrame gpu{m_stream, m_timers, m_stats, m_empty};
        gpu.constants(0, view);
        work(gpu);
    }

    // Rows from the bottom.
    static std::unique_ptr<renderer::Radiance> radiance(glm::ivec2 size, const std::function<glm::vec3(int x, int y)>& at)
    {
        auto made = std::make_unique<renderer::Radiance>();
        made->texture = renderer::gl::Texture{{.label = "light", .size = size, .format = GL_RGBA32F}};
        std::vector<glm::vec4> texels;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                texels.emplace_back(at(x, y), 1);
        made->texture.upload(texels.data(), GL_RGBA, GL_FLOAT);
        return made;
    }

    // In which nothing was drawn: sky everywhere.
    static std::unique_ptr<renderer::GBuffer> bareSky(glm::ivec2 size)
    {
        auto made = std::make_unique<renderer::GBuffer>();
        const auto texture = [size](GLenum format) { return renderer::gl::Texture{{.label = "empty", .size = size, .format = format, .filter = GL_NEAREST}}; };
        made->colour = texture(GL_RGBA8);
        made->normal = texture(GL_RG16_SNORM);
        made->surface = texture(GL_RGBA8);
        made->id = texture(GL_R32UI);
        made->depth = texture(GL_DEPTH_COMPONENT32F);
        const float far = 0;
        glClearTexImage(made->depth.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, &far);
        return made;
    }

    static std::vector<glm::vec4> read(const renderer::gl::Texture& texture)
    {
        std::vector<glm::vec4> texels(std::size_t(texture.size().x) * texture.size().y);
        glGetTextureImage(texture.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(texels.size() * sizeof(glm::vec4)), texels.data());
        return texels;
    }

    renderer::ShaderLibrary shaders;

private:
    renderer::GpuStream m_stream;
    renderer::PassTimers m_timers;
    renderer::FrameStats m_stats;
    renderer::gl::VertexArray m_empty;
};

} // namespace test
