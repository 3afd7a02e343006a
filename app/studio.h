// Studio: a context without a window and the renderer in it, for the commands that draw into pictures.
#pragma once

#include "app/gl_context.h"
#include "app/options.h"
#include "editor/document.h"
#include "renderer/renderer.h"

#include <memory>

namespace app {

class Studio {
public:
    static io::Result<std::unique_ptr<Studio>> create(bool headless);

    renderer::Renderer& renderer() { return *m_renderer; }
    const std::string& platform() const { return m_platform; }
    void follow(editor::Document& document); // brings the renderer up to date with it

private:
    Studio(std::unique_ptr<GlContext> context, std::unique_ptr<renderer::Renderer> renderer)
        : m_context{std::move(context)}, m_platform{m_context->platform()}, m_renderer{std::move(renderer)}
    {
    }
    std::unique_ptr<GlContext> m_context; // outlives the renderer
    std::string m_platform;
    std::unique_ptr<renderer::Renderer> m_renderer;
};

io::Result<std::unique_ptr<renderer::Renderer>> makeRenderer();

} // namespace app
