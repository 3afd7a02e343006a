#include "io/files/texel_picture.h"

#include "io/files/image_file.h"
#include "io/files/png_file.h"

#include <bit>
#include <cstring>
#include <fmt/format.h>

namespace io {

// Texels lie in memory as the bytes of a pixel.
static_assert(std::endian::native == std::endian::little);

Result<Texels> readTexels(const std::filesystem::path& file, std::string_view what)
{
    const Result<Image> image = readImage(file, kGroundLimits);
    if (!image) return image.error();
    if (image->channels != 4 || image->type != PixelType::U8)
        return Error{file.string(), fmt::format("{} is a PNG with red, green, blue and alpha of 8 bits", what)};
    std::vector<std::uint32_t> texels(std::size_t(image->size.x) * image->size.y);
    std::memcpy(texels.data(), image->bytes.data(), texels.size() * sizeof(texels[0]));
    return Texels{image->size, texels};
}

Result<std::string> encodeTexels(const Texels& texels)
{
    Image image{.size = texels.size(), .channels = 4, .type = PixelType::U8};
    const std::vector<std::uint32_t> rows = texels.read(texels.rect());
    image.bytes.resize(rows.size() * sizeof(rows[0]));
    std::memcpy(image.bytes.data(), rows.data(), image.bytes.size());
    return encodePng(image);
}

} // namespace io
