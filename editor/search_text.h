// Finding a text while a person types part of it: letters with and without accents, large and small, are the same.
#pragma once

#include <string>
#include <string_view>

namespace editor {

std::string lowerCase(std::string_view text);                // Latin letters with Czech accents, to bare small ones
bool holds(std::string_view text, std::string_view lowered); // `lowered` as lowerCase() made it
bool holdsWords(std::string_view text, std::string_view lowered); // each of them, anywhere

} // namespace editor
