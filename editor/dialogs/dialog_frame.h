// The frame that all dialogs share: in the middle of the window, over all of it, with a title.
#pragma once

namespace editor {

// ImGui::EndPopup() when true. `id` is that of a popup that is open; pixels.
bool beginDialog(const char* id, const char* title, float width);

} // namespace editor
