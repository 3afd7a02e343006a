// The files of a project that a field may name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace editor {

// "textures/bark.png", in the alphabet's order; none where there is no such folder.
std::vector<std::string> filesIn(const std::filesystem::path& project, const char* folder);

} // namespace editor
