// The pictures that OpenImageIO reads and writes. It draws in two hundred libraries, and binding those takes longer than
// most commands do, so it lives in a module of its own that is loaded with the first such picture.
#pragma once

#include "io/base/result.h"
#include "io/files/image_file.h"
#include "io/files/image_rows.h"

#include <string>
#include <string_view>

namespace io {

struct PictureModule {
    // `format` as imageFormat() has it. Sizes are checked against the limits before any pixel is read.
    Result<Image> (*decode)(const std::string& format, std::string_view bytes, const std::string& where, const ImageLimits& limits) = nullptr;
    // "tiff" or "openexr" from a file of so many bytes, of which a side may have `largestSide` pixels.
    Result<std::unique_ptr<ImageRows>> (*openRows)(const std::string& format, const std::string& file, std::uint64_t bytes, int largestSide) = nullptr;
    Result<std::string> (*encode)(const std::string& format, const ImageLayout& layout, const RowSource& source) = nullptr; // "exr" or "tiff"
};

Result<PictureModule> pictureModule(); // loaded once, kept until the end

} // namespace io
