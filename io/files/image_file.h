// Images on disk. One function decodes them all, so that it can move into a worker process as it is.
#pragma once

#include "io/base/result.h"
#include "io/scene/image.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace io {

constexpr int kLargestSide = 16384;                               // pixels
constexpr std::uint64_t kLargestImage = std::uint64_t(512) << 20; // bytes once decoded

// PNG JPEG TIFF EXR HDR DDS, told apart by their first bytes. Refused from the header, before any pixel is read:
// a side or a size over the limits. 8 and 16 bits stay what they are; half, float and signed integers become
// float, the integers unscaled (a TIFF of heights holds metres). Alpha is never multiplied into the colour.
Result<Image> decodeImage(std::string_view bytes, const std::string& where);
Result<Image> readImage(const std::filesystem::path& file); // reads the file and decodes it

Status writeImage(const std::filesystem::path& file, const Image& image, int quality = 92); // by extension: png jpg exr

} // namespace io
