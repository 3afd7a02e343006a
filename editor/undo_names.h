// Names of undo steps in the language of the window.
#pragma once

#include "editor/text.h"

#include <string>

namespace editor {

inline std::string stepName(const char* key, std::size_t count) // "Move", "Move (×12)"
{
    return count == 1 ? std::string{tr(key)} : trf("undo.many", tr(key), count);
}

} // namespace editor
