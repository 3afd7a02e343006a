// The pictures that OpenImageIO reads and writes. It draws in two hundred libraries, and binding those takes longer than
// most commands do, so it lives in a module of its own that is loaded with the first such picture.
#pragma once

#include "io/base/result.h"
#include "io/files/image_file.h"

#include <string>
#include <string_view>

namespace io {

struct PictureModule {
    // `format` as imageFormat() has it. Sizes are checked against the limits before any pixel is read.
    Result<Image> (*decode)(const std::string& format, std::string_view bytes, const std::string& where, const ImageLimits& limits) = nullptr;
    Result<std::string> (*encode)(const std::string& format, const Image& image) = nullptr; // "exr" or "tiff"
};

Result<PictureModule> pictureModule(); // loaded once, kept until the end

} // namespace io
