// JSON text to and from io::Value. Numbers are written in the shortest form that reads back the same.
#pragma once

#include "io/base/result.h"
#include "io/base/value.h"

#include <string>
#include <string_view>

namespace io {

enum class Duplicates { Refuse, KeepFirst }; // of a key in one object

// `where` names the text in errors, which read WHERE:LINE: what is wrong. Nesting over 64 is refused.
Result<Value> parseJson(std::string_view text, const std::string& where, Duplicates duplicates = Duplicates::Refuse);
std::string writeJson(const Value& value, int indent = -1); // -1: one line

} // namespace io
