// Where in a file something is said, for messages that name the line.
#pragma once

#include <filesystem>
#include <string>

namespace io {

// FILE:LINE of the first line that holds the text in quotes; of the first at all where none does.
std::string placeOf(const std::filesystem::path& file, const std::string& text);

} // namespace io
