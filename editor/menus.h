// The bar of menus along the top, the toolbar under it and the status bar along the bottom.
#pragma once

namespace editor {

class Editor;

void menuBar(Editor& editor);
float toolbar(Editor& editor, float top); // answers where it ends, pixels
float statusBar(Editor& editor);          // answers where it begins

} // namespace editor
