// A context without a display, through EGL: Mesa's surfaceless platform, then each EGL device (a server's GPU).
#pragma once

#include "app/gl_context.h"

namespace app {

io::Result<std::unique_ptr<GlContext>> makeHeadless();

} // namespace app
