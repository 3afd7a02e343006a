// Every word of the window by key: "menu.save" is the text `save` of the category `menu` in a language file.
// The table is swapped while the program runs; a key without a text shows itself and is logged once.
#pragma once

#include "io/base/value.h"

#include <fmt/format.h>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

// Category -> key -> text, as app/lang/en.json. Texts of the wrong type are skipped.
void setTexts(const io::Value& language);

// Valid until the next setTexts(); `key` itself when there is no text for it.
const char* tr(const char* key);
const char* tr(const std::string& key);
bool hasText(std::string_view key);

// A text with {}, {0} or {name} in it.
std::string trFormatted(const char* key, fmt::format_args arguments);
template <class... Args> std::string trf(const char* key, const Args&... args)
{
    return trFormatted(key, fmt::make_format_args(args...));
}

// Keys that were asked for and missing since the last setTexts().
std::vector<std::string> missingTexts();

} // namespace editor
