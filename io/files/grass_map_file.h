// Where grass was painted, as a PNG: red two kinds of four bits, green and blue how densely each of them stands, alpha how high,
// where 128 is a kind's own height.
#pragma once

#include "io/base/result.h"
#include "io/scene/grass.h"

#include <filesystem>
#include <string>

namespace io {

Result<TexelTiles<std::uint32_t>> readGrassTexels(const std::filesystem::path& file);
Result<std::string> encodeGrassMap(const GrassMap& map);

} // namespace io
