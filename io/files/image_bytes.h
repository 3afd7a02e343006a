// What can be told of an image from its bytes without a decoder: its format, and what of it need not be decoded.
#pragma once

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

// What a decoder would divide by zero for; empty when there is nothing.
std::string headerFault(std::string_view bytes);

// Pixels of a PNG or JPEG as its header has them, for decoders that begin their work before they tell the size.
std::optional<glm::u32vec2> declaredSize(std::string_view bytes);

} // namespace io
