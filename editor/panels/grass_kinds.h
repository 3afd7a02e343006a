// The kinds of grass of a scene, in the Terrain panel: which the brush grows, and what each is like.
#pragma once

#include "editor/brush.h"

namespace editor {

class Editor;

void grassChoice(Editor& editor, Brush& brush); // for the brush in hand
void drawGrassKinds(Editor& editor);

} // namespace editor
