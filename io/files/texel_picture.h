// Texels of four bytes as a PNG: their bytes, from the lowest, are red, green, blue and alpha.
#pragma once

#include "io/base/result.h"
#include "io/scene/texel_tiles.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace io {

using Texels = TexelTiles<std::uint32_t>;

// `what`: "a cover map", for the words of errors.
Result<Texels> readTexels(const std::filesystem::path& file, std::string_view what);
Result<std::string> encodeTexels(const Texels& texels);

} // namespace io
