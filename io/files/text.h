// JSON's atoms as text: what every writer of ours puts between the punctuation.
#pragma once

#include <string>
#include <string_view>

namespace io {

// The shortest form that reads back to the same value: integers without ".0", zero without a sign.
void appendNumber(std::string& out, double value); // finite
void appendNumber(std::string& out, float value);
void appendString(std::string& out, std::string_view utf8); // in quotes, escaped; broken UTF-8 becomes U+FFFD

std::string repairedUtf8(std::string_view text); // broken sequences become U+FFFD

} // namespace io
