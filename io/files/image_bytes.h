// What can be told of an image without a decoder: its format, what of it need not be decoded, and whether it is too large.
#pragma once

#include "io/base/result.h"
#include "io/files/image_file.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace io {

// "png", "jpeg", "tiff", "openexr", "hdr" or "dds" by the first bytes; empty when it is none of these.
std::string_view imageFormat(std::string_view bytes);

// A PNG or JPEG without its metadata (XMP, ICC, IPTC, text): no pixel depends on it, and it is where decoders
// break most often. Other formats, and files too damaged to be walked through, come back as they are.
std::string withoutMetadata(std::string_view bytes);

// Whether a chunk of these four letters has to do with the pixels of a PNG.
bool pngChunkHasPixels(std::string_view letters);

// What a decoder would divide by zero for; empty when there is nothing.
std::string headerFault(std::string_view bytes);

// Pixels of a PNG or JPEG as its header has them, for decoders that begin their work before they tell the size.
std::optional<glm::u32vec2> declaredSize(std::string_view bytes);

// A decoder may hold the whole native image: these count that as well as what comes out of it.
struct DecodedSize {
    glm::ivec2 pixels;
    int channels;
    std::size_t sampleBytes;
};
Status checkSides(std::int64_t width, std::int64_t height, const ImageLimits& limits, const std::string& where);
Status checkRows(const DecodedSize& size, const ImageLimits& limits, const std::string& where); // of what is never decoded whole
Status checkSize(const DecodedSize& size, const ImageLimits& limits, const std::string& where);

} // namespace io
