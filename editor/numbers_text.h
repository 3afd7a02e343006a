// Numbers as a person reads them, in the language of the window.
#pragma once

#include <cstdint>
#include <string>

namespace editor {

std::string grouped(std::uint64_t number); // "1,081,274"
std::string byteText(std::uint64_t bytes); // "12.4 MB"
std::string numberShown(double number, int decimals, bool bare = false); // more where less would hide three digits; bare: fewer too
std::string clockShown(double hours);                                    // "6:05", "-5:30", "24:00"

} // namespace editor
