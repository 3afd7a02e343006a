#include "io/files/cover_map_file.h"

#include "io/files/image_file.h"
#include "io/files/png_file.h"

#include <bit>
#include <cstring>
#include <fmt/format.h>

namespace io {

// Texels lie in memory as the bytes of a pixel.
static_assert(std::endian::native == std::endian::little);

Result<CoverMap> readCoverMap(const std::filesystem::path& file, glm::ivec2 size)
{
    const Result<Image> image = readImage(file, kGroundLimits);
    if (!image) return image.error();
    if (image->channels != 4 || image->type != PixelType::U8)
        return Error{file.string(), "a cover map is a PNG with red, green, blue and alpha of 8 bits"};
    if (image->size != size)
        return Error{file.string(), fmt::format("{} x {} pixels do not fit heights of {} x {}; what was painted is not shown and not overwritten",
                                                image->size.x, image->size.y, size.x, size.y)};
    std::vector<std::uint32_t> texels(std::size_t(size.x) * size.y);
    std::memcpy(texels.data(), image->bytes.data(), texels.size() * sizeof(texels[0]));
    for (std::uint32_t& texel : texels) // layers are 0 to 31
        texel &= texel >> 24 == 0 ? kHoleBit : 0xffff1f1fu | kHoleBit;
    return CoverMap{size, texels};
}

Result<std::string> encodeCoverMap(const CoverMap& cover)
{
    Image image{.size = cover.size(), .channels = 4, .type = PixelType::U8};
    const std::vector<std::uint32_t> texels = cover.read(cover.rect());
    image.bytes.resize(texels.size() * sizeof(texels[0]));
    std::memcpy(image.bytes.data(), texels.data(), image.bytes.size());
    return encodePng(image);
}

} // namespace io
