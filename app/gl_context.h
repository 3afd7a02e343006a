// An OpenGL 4.5 core context, current on the thread that made it, for as long as the object lives.
#pragma once

#include "io/base/result.h"

#include <memory>
#include <string>

namespace app {

class GlContext {
public:
    virtual ~GlContext() = default;
    virtual std::string platform() const = 0; // "EGL surfaceless", "EGL device 1", "window"
};

// The context of a command that draws into pictures: a hidden window's where there is a display and `headless` does
// not forbid it, otherwise EGL's.
io::Result<std::unique_ptr<GlContext>> makePictureContext(bool headless);

bool hasDisplay(); // DISPLAY or WAYLAND_DISPLAY is set

} // namespace app
