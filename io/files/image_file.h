// Images on disk. One function reads them all, so that it can move into a worker process as it is.
#pragma once

#include "io/base/result.h"
#include "io/scene/image.h"

#include <filesystem>
#include <string_view>

namespace io {

// Refused from the header, before any pixel is read: a side over 16384, more than 512 MiB decoded.
Result<Image> readImage(const std::filesystem::path& file); // PNG JPEG TIFF EXR HDR DDS; 16 bits stay 16 bits
Result<Image> decodeImage(std::string_view bytes, const std::string& where); // as embedded in a GLB

Result<std::string> encodePng(const Image& image); // U8 or U16
Status writeImage(const std::filesystem::path& file, const Image& image, int quality = 92); // by extension: png jpg exr

} // namespace io
