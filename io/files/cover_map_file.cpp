#include "io/files/cover_map_file.h"

#include "io/files/texel_picture.h"

#include <fmt/format.h>

namespace io {

Result<CoverMap> readCoverMap(const std::filesystem::path& file, glm::ivec2 size)
{
    const Result<Texels> read = readTexels(file, "a cover map");
    if (!read) return read.error();
    if (read->size() != size)
        return Error{file.string(), fmt::format("{} x {} pixels do not fit heights of {} x {}; what was painted is not shown and not overwritten",
                                                read->size().x, read->size().y, size.x, size.y)};
    std::vector<std::uint32_t> texels = read->read(read->rect());
    for (std::uint32_t& texel : texels) // layers are 0 to 31
        texel &= texel >> 24 == 0 ? kHoleBit : 0xffff1f1fu | kHoleBit;
    return CoverMap{size, texels};
}

Result<std::string> encodeCoverMap(const CoverMap& cover)
{
    return encodeTexels(cover);
}

} // namespace io
