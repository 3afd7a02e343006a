#include "editor/held_controls.h"

#include "editor/key_names.h"

#include <imgui.h>

namespace editor {

Held heldKeys()
{
    Held held;
    const ImGuiIO& io = ImGui::GetIO();
    for (int code = 0; code < IM_ARRAYSIZE(io.KeysDown); ++code)
        if (io.KeysDown[code])
            if (const std::string name = nameOfKey(code); !name.empty()) held[name] = 1;
    for (int button = 0; button < IM_ARRAYSIZE(io.MouseDown); ++button)
        if (io.MouseDown[button]) held["mouse " + std::to_string(button + 1)] = 1;
    return held;
}

} // namespace editor
