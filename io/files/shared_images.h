// Images in memory once: models that hold the same file share what was decoded of it, as long as one of them lives.
#pragma once

#include "io/base/result.h"
#include "io/scene/image.h"

#include <memory>
#include <string>
#include <string_view>

namespace io {

// decodeImage() of bytes that were not decoded before or are forgotten again. From any thread; whoever comes second waits.
Result<std::shared_ptr<const Image>> decodeShared(std::string_view bytes, const std::string& where);

} // namespace io
