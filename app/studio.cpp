#include "app/studio.h"

#include "io/base/paths.h"

namespace app {

io::Result<std::unique_ptr<renderer::Renderer>> makeRenderer()
{
#ifdef NDEBUG
    constexpr bool kDebug = false;
#else
    constexpr bool kDebug = true;
#endif
    return renderer::Renderer::create({.shaders = io::resource("renderer/shaders"), .debug = kDebug});
}

io::Result<std::unique_ptr<Studio>> Studio::create(bool headless)
{
    auto context = makePictureContext(headless);
    if (!context) return context.error();
    auto renderer = makeRenderer();
    if (!renderer) return renderer.error();
    return std::unique_ptr<Studio>{new Studio{*std::move(context), *std::move(renderer)}};
}

void Studio::follow(editor::Document& document)
{
    const io::Changes changes = document.takeChanges();
    if (!changes.none()) m_renderer->update(document.scene(), document.assets(), changes);
}

} // namespace app
