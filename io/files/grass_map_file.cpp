#include "io/files/grass_map_file.h"

#include "io/files/texel_picture.h"

namespace io {

Result<TexelTiles<std::uint32_t>> readGrassTexels(const std::filesystem::path& file)
{
    const Result<Texels> read = readTexels(file, "a map of grass");
    if (!read) return read.error();
    std::vector<std::uint32_t> texels = read->read(read->rect());
    for (std::uint32_t& texel : texels) // one way to say each
        texel = packed(unpackedGrass(texel));
    return Texels{read->size(), texels};
}

Result<std::string> encodeGrassMap(const GrassMap& map)
{
    return encodeTexels(map.field());
}

} // namespace io
