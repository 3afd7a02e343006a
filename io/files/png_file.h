// PNG by libpng itself. OpenImageIO's reader lets libpng print its own words on stderr and reads rows of interlaced
// pictures that it could not decode.
#pragma once

#include "io/base/result.h"
#include "io/files/image_file.h"

#include <string>
#include <string_view>

namespace io {

// 8 or 16 bits and one to four channels: a palette becomes colours, a transparent colour alpha, fewer bits become 8.
Result<Image> decodePng(std::string_view bytes, const std::string& where, const ImageLimits& limits = {});
Result<std::string> encodePng(const Image& image); // U8 or U16

} // namespace io
