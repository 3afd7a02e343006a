// Numbers as a person reads them, in the language of the window.
#pragma once

#include <cstdint>
#include <string>

namespace editor {

std::string grouped(std::uint64_t number); // "1,081,274"
std::string byteText(std::uint64_t bytes); // "12.4 MB"

} // namespace editor
