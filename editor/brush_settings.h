// What a person last set the brush to, for the next start of the editor. Layers are a project's and left out.
#pragma once

#include "editor/brush.h"
#include "io/base/value.h"

namespace editor {

io::Value brushSettings(const Brush& brush);
void restoreBrush(Brush& brush, const io::Value& saved); // what is missing or wrong stays; a stamp's picture is read elsewhere

} // namespace editor
