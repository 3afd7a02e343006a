// Images on disk. One function decodes them all, so that it can move into a worker process as it is.
#pragma once

#include "io/base/result.h"
#include "io/scene/image.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace io {

// What a file may ask for. Refused from the header, before any pixel is read.
struct ImageLimits {
    int side = 16384;                               // pixels
    std::uint64_t bytes = std::uint64_t(512) << 20; // once decoded
};
constexpr ImageLimits kGroundLimits{.side = 16385, .bytes = std::uint64_t(16385) * 16385 * 4}; // a float, or a cover, a texel

// PNG JPEG TIFF EXR HDR DDS, told apart by their first bytes. 8 and 16 bits stay what they are; half, float and signed integers become
// float, the integers unscaled (a TIFF of heights holds metres). Alpha is never multiplied into the colour.
Result<Image> decodeImage(std::string_view bytes, const std::string& where, const ImageLimits& limits = {});
Result<Image> readImage(const std::filesystem::path& file, const ImageLimits& limits = {}); // reads the file and decodes it

Status writeImage(const std::filesystem::path& file, const Image& image, int quality = 92); // by extension: png jpg exr

} // namespace io
