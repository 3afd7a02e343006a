// JPEG by libjpeg-turbo itself: most textures are one, and OpenImageIO takes longer to load than they do to decode.
#pragma once

#include "io/base/result.h"
#include "io/scene/image.h"

#include <string>
#include <string_view>

namespace io {

// One channel or three; inks (CMYK, YCCK) become colours. A file that ends early is refused, lesser damage is not.
Result<Image> decodeJpeg(std::string_view bytes, const std::string& where);

Result<std::string> encodeJpeg(const Image& image, int quality); // U8, without its alpha; quality 1 to 100

} // namespace io
