// Fonts of the window, found through fontconfig: Inter, else DejaVu Sans, else any with Czech letters.
#pragma once

#include "editor/theme.h"

namespace app {

editor::FontFiles findFonts();

} // namespace app
