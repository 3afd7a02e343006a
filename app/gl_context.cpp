#include "app/gl_context.h"

#include "app/headless.h"
#include "app/window.h"
#include "io/base/log.h"

#include <cstdlib>

namespace app {
namespace {

class HiddenWindow final : public GlContext {
public:
    explicit HiddenWindow(std::unique_ptr<Window> window) : m_window{std::move(window)} {}
    std::string platform() const override { return "hidden window"; }

private:
    std::unique_ptr<Window> m_window;
};

} // namespace

bool hasDisplay()
{
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value && *value;
    };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

io::Result<std::unique_ptr<GlContext>> makePictureContext(bool headless)
{
    if (headless || !hasDisplay()) return makeHeadless();
    auto window = Window::create({.size = {64, 64}, .visible = false});
    if (window) return std::unique_ptr<GlContext>{std::make_unique<HiddenWindow>(*std::move(window))};
    io::log::warning("{}; drawing without the display", window.error().text());
    return makeHeadless();
}

} // namespace app
