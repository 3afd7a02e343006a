#include "io/files/height_map_file.h"

#include "io/base/contract.h"
#include "io/files/atomic_file.h"
#include "io/files/image_file.h"
#include "io/files/png_file.h"
#include "io/scene/field_words.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace io {
namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
constexpr float kHighest = 1e5f; // m; what is beyond is no height but a mark or an error
constexpr int kSmoothings = 32;

bool isVoid(float metres)
{
    // -32768 and -9999 are the marks of SRTM and of Esri's grids, -32767 that of many GeoTIFFs.
    return !std::isfinite(metres) || std::abs(metres) > kHighest || metres == -32768 || metres == -32767 ||
           metres == -9999;
}

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
            metres.push_back(isVoid(value) ? kVoid : value);
        }
    }
    return metres;
}

// The mean of the neighbours that are known; NaN when there are none.
float meanAround(const HeightGrid& map, int x, int z)
{
    float sum = 0;
    int count = 0;
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
            if ((dx == 0 && dz == 0) || x + dx < 0 || z + dz < 0 || x + dx >= map.size.x || z + dz >= map.size.y)
                continue;
            const float height = map.at(x + dx, z + dz);
            if (std::isnan(height)) continue;
            sum += height;
            ++count;
        }
    }
    return count == 0 ? kVoid : sum / float(count);
}

using Texels = std::vector<glm::ivec2>;

std::vector<float> meansAround(const HeightGrid& map, const Texels& texels)
{
    std::vector<float> means;
    means.reserve(texels.size());
    for (const glm::ivec2& t : texels)
        means.push_back(meanAround(map, t.x, t.y));
    return means;
}

void set(HeightGrid& map, const glm::ivec2& texel, float metres)
{
    map.metres[std::size_t(texel.y) * map.size.x + texel.x] = metres;
}

// Texels next to a void one, that are void themselves and not in line yet.
void addVoidNeighbours(const HeightGrid& map, const glm::ivec2& texel, std::vector<bool>& queued, Texels& ring)
{
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
            const glm::ivec2 t = texel + glm::ivec2{dx, dz};
            if (t.x < 0 || t.y < 0 || t.x >= map.size.x || t.y >= map.size.y || !std::isnan(map.at(t.x, t.y))) continue;
            const std::size_t index = std::size_t(t.y) * map.size.x + t.x;
            if (queued[index]) continue;
            queued[index] = true;
            ring.push_back(t);
        }
    }
}

// Grows the known ground into the voids ring by ring, then lets what was filled settle like a membrane.
std::size_t fillVoids(HeightGrid& map)
{
    std::vector<bool> queued(map.metres.size());
    Texels ring, filled;
    for (int z = 0; z < map.size.y; ++z)
        for (int x = 0; x < map.size.x; ++x)
            if (!std::isnan(map.at(x, z))) addVoidNeighbours(map, {x, z}, queued, ring);
    while (!ring.empty()) {
        const std::vector<float> means = meansAround(map, ring);
        for (std::size_t i = 0; i < ring.size(); ++i)
            set(map, ring[i], means[i]);
        filled.insert(filled.end(), ring.begin(), ring.end());
        Texels next;
        for (const glm::ivec2& texel : ring)
            addVoidNeighbours(map, texel, queued, next);
        ring = std::move(next);
    }
    for (int pass = 0; pass < kSmoothings; ++pass) {
        const std::vector<float> means = meansAround(map, filled);
        for (std::size_t i = 0; i < filled.size(); ++i)
            set(map, filled[i], means[i]);
    }
    return filled.size();
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
    const Result<Image> image = readImage(file);
    if (!image) return image.error();
    if (image->size.x < 2 || image->size.y < 2) return Error{where, "a height map needs at least 2 x 2 pixels"};

    HeightGrid grid{.size = image->size, .metresPerTexel = terrain.metresPerTexel, .origin = terrain.origin};
    grid.metres = metresOf(*image, terrain, where, complaints);
    const bool voids = std::any_of(grid.metres.begin(), grid.metres.end(), [](float m) { return std::isnan(m); });
    if (voids && std::all_of(grid.metres.begin(), grid.metres.end(), [](float m) { return std::isnan(m); }))
        return Error{where, "a height map without a single height"};
    if (voids)
        complaints.push_back({Severity::Warning, where,
                              std::to_string(fillVoids(grid)) + " heights are missing; filled from their neighbours"});
    HeightMap map{grid};
    map.shares = image->type != PixelType::F32;
    return map;
}

namespace {

Result<std::string> encoded16(const HeightGrid& heights, double minHeight, double maxHeight)
{
    EXPECTS(maxHeight > minHeight);
    Image image{.size = heights.size, .channels = 1, .type = PixelType::U16};
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    auto* texel = image.row<std::uint16_t>(0);
    for (const float metres : heights.metres) {
        const double share = std::clamp((double(metres) - minHeight) / (maxHeight - minHeight), 0.0, 1.0);
        *texel++ = std::uint16_t(std::lround(share * 65535));
    }
    return encodePng(image);
}

} // namespace

Status writeHeightMap16(const std::filesystem::path& file, const HeightGrid& heights, double minHeight, double maxHeight)
{
    const Result<std::string> png = encoded16(heights, minHeight, maxHeight);
    if (!png) return Error{file.string(), png.error().what};
    return writeFile(file, *png);
}

namespace {

std::string extensionOf(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) { return char(std::tolower(c)); });
    return extension;
}

} // namespace

bool holdsHeights(const std::filesystem::path& file)
{
    const std::string extension = extensionOf(file);
    return extension == ".png" || extension == ".exr" || extension == ".tif" || extension == ".tiff";
}

Result<std::string> encodeHeightMap(const HeightMap& heights, Terrain& terrain)
{
    const HeightGrid grid = heights.read(heights.texels());
    const std::string extension = extensionOf(terrain.heightMap);
    if (extension == ".png") {
        const double low = std::min(terrain.minHeight, terrain.maxHeight), high = std::max(terrain.minHeight, terrain.maxHeight);
        const double halfStep = (high - low) / 65535 / 2; // what rounds back into the range does not move it
        if (heights.min < low - halfStep || heights.max > high + halfStep || high <= low) {
            terrain.minHeight = std::floor(std::min(low, double(heights.min)));
            terrain.maxHeight = std::ceil(std::max({high, double(heights.max), terrain.minHeight + 1}));
        }
        if (terrain.minHeight > terrain.maxHeight) std::swap(terrain.minHeight, terrain.maxHeight); // an upside-down file is put right
        return encoded16(grid, terrain.minHeight, terrain.maxHeight);
    }
    Image image{.size = grid.size, .channels = 1, .type = PixelType::F32};
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    std::ranges::copy(grid.metres, image.row<float>(0));
    return encodeFloatImage(extension, image);
}

} // namespace io
