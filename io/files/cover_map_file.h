// What was painted over the ground, as a PNG: red the lower layer (128 more: a hole), green the upper one, blue how much of the upper one, alpha how
// far both cover what the layers' rules say.
#pragma once

#include "io/base/result.h"
#include "io/scene/cover_map.h"

#include <filesystem>
#include <string>

namespace io {

Result<CoverMap> readCoverMap(const std::filesystem::path& file, glm::ivec2 size); // that of the heights
Result<std::string> encodeCoverMap(const CoverMap& cover);

} // namespace io
