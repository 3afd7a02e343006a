#include "io/files/height_map_file.h"

#include "io/base/contract.h"
#include "io/files/atomic_file.h"
#include "io/files/file_names.h"
#include "io/files/height_voids.h"
#include "io/files/image_file.h"
#include "io/files/png_file.h"
#include "io/scene/field_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace io {
namespace {

template <class T> std::vector<float> scaled(const Image& image, double low, double high)
{
    const double step = (high - low) / double(std::numeric_limits<T>::max());
    std::vector<float> metres;
    metres.reserve(std::size_t(image.size.x) * image.size.y);
    for (int z = 0; z < image.size.y; ++z)
        for (int x = 0; x < image.size.x; ++x)
            metres.push_back(float(low + step * image.row<T>(z)[std::size_t(x) * image.channels]));
    return metres;
}

std::vector<float> plain(const Image& image)
{
    std::vector<float> metres;
    metres.reserve(std::size_t(image.size.x) * image.size.y);
    for (int z = 0; z < image.size.y; ++z) {
        for (int x = 0; x < image.size.x; ++x) {
            const float value = image.row<float>(z)[std::size_t(x) * image.channels];
            metres.push_back(marksVoid(value) ? kVoid : value);
        }
    }
    return metres;
}

std::vector<float> metresOf(const Image& image, const Terrain& terrain, const std::string& where,
                            Complaints& complaints)
{
    if (image.channels > 1)
        complaints.push_back({Severity::Warning, where, "a colour image as a height map; its first channel is used"});
    if (image.type == PixelType::F32) return plain(image);
    if (terrain.maxHeight < terrain.minHeight)
        complaints.push_back({Severity::Warning, where, "max_height is below min_height; the ground is upside down"});
    if (image.type == PixelType::U16) return scaled<std::uint16_t>(image, terrain.minHeight, terrain.maxHeight);
    complaints.push_back({Severity::Warning, where,
                          "8 bits make steps of " + numberText((terrain.maxHeight - terrain.minHeight) / 255) +
                              " m; save it with 16 bits"});
    return scaled<std::uint8_t>(image, terrain.minHeight, terrain.maxHeight);
}

} // namespace

Result<HeightMap> readHeightMap(const std::filesystem::path& file, const Terrain& terrain, Complaints& complaints)
{
    const std::string where = file.string();
    const Result<Image> image = readImage(file, kGroundLimits);
    if (!image) return image.error();
    if (image->size.x < 2 || image->size.y < 2) return Error{where, "a height map needs at least 2 x 2 pixels"};

    HeightGrid grid{.size = image->size, .metresPerTexel = terrain.metresPerTexel, .origin = terrain.origin};
    grid.metres = metresOf(*image, terrain, where, complaints);
    const std::optional<std::size_t> filled = fillVoids(grid.size, grid.metres);
    if (!filled) return Error{where, "a height map without a single height"};
    if (*filled > 0)
        complaints.push_back({Severity::Warning, where, std::to_string(*filled) + " heights are missing; filled from their neighbours"});
    HeightMap map{grid};
    map.shares = image->type != PixelType::F32;
    return map;
}

std::vector<std::uint16_t> samples16(const HeightGrid& heights, double minHeight, double maxHeight)
{
    EXPECTS(maxHeight > minHeight);
    std::vector<std::uint16_t> samples;
    samples.reserve(heights.metres.size());
    for (const float metres : heights.metres)
        samples.push_back(std::uint16_t(std::lround(std::clamp((double(metres) - minHeight) / (maxHeight - minHeight), 0.0, 1.0) * 65535)));
    return samples;
}

namespace {

Result<std::string> encoded16(const HeightGrid& heights, double minHeight, double maxHeight)
{
    Image image{.size = heights.size, .channels = 1, .type = PixelType::U16};
    const std::vector<std::uint16_t> samples = samples16(heights, minHeight, maxHeight);
    const auto bytes = std::as_bytes(std::span{samples});
    image.bytes.assign(bytes.begin(), bytes.end());
    return encodePng(image);
}

} // namespace

Status writeHeightMap16(const std::filesystem::path& file, const HeightGrid& heights, double minHeight, double maxHeight)
{
    const Result<std::string> png = encoded16(heights, minHeight, maxHeight);
    if (!png) return Error{file.string(), png.error().what};
    return writeFile(file, *png);
}

bool holdsHeights(const std::filesystem::path& file)
{
    const std::string extension = lowerExtension(file);
    return extension == ".png" || extension == ".exr" || extension == ".tif" || extension == ".tiff";
}

void makeRoom(const HeightMap& heights, Terrain& terrain)
{
    const double low = std::min(terrain.minHeight, terrain.maxHeight), high = std::max(terrain.minHeight, terrain.maxHeight);
    const double halfStep = (high - low) / 65535 / 2; // what rounds back into the range does not move it
    if (heights.min < low - halfStep || heights.max > high + halfStep || high <= low) {
        terrain.minHeight = std::floor(std::min(low, double(heights.min)));
        terrain.maxHeight = std::ceil(std::max({high, double(heights.max), terrain.minHeight + 1}));
    }
    if (terrain.minHeight > terrain.maxHeight) std::swap(terrain.minHeight, terrain.maxHeight);
}

Result<std::string> encodeHeightMap(const HeightMap& heights, Terrain& terrain)
{
    const HeightGrid grid = heights.read(heights.texels());
    const std::string extension = lowerExtension(terrain.heightMap);
    if (extension == ".png") {
        makeRoom(heights, terrain);
        return encoded16(grid, terrain.minHeight, terrain.maxHeight);
    }
    Image image{.size = grid.size, .channels = 1, .type = PixelType::F32};
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    std::ranges::copy(grid.metres, image.row<float>(0));
    return encodeFloatImage(extension, image);
}

} // namespace io
