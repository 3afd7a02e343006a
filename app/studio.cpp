#include "app/studio.h"

#include "io/base/paths.h"
#include "io/files/cache_folder.h"

namespace app {
namespace {

constexpr std::uint64_t kMostPictureBytes = std::uint64_t(256) << 20; // of impostors, on disk

} // namespace

io::Result<std::unique_ptr<renderer::Renderer>> makeRenderer()
{
#ifdef NDEBUG
    constexpr bool kDebug = false;
#else
    constexpr bool kDebug = true;
#endif
    auto kept = std::make_shared<io::CacheFolder>(io::cacheFolder() / "impostors", ".pictures", kMostPictureBytes);
    return renderer::Renderer::create(
        {.shaders = io::resource("renderer/shaders"), .debug = kDebug, .kept = std::move(kept)});
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
