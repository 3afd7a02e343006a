#include "io/files/height_map_file.h"

#include "io/base/contract.h"
#include "io/files/atomic_file.h"
#include "io/files/file_names.h"
#include "io/files/image_file.h"
#include "io/files/image_rows.h"
#include "io/files/void_filling.h"
#include "io/scene/field_words.h"
#include "io/scene/height_map_builder.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <span>

namespace io {
namespace {

// Rows of samples to metres: the first channel of each texel.
class ToMetres {
public:
    ToMetres(const ImageLayout& layout, const Terrain& terrain) : m_layout{layout}, m_low{terrain.minHeight}, m_high{terrain.maxHeight} {}
    void row(const std::byte* from, std::span<float> metres) const
    {
        if (m_layout.type == PixelType::U8) return scaled<std::uint8_t>(from, metres);
        if (m_layout.type == PixelType::U16) return scaled<std::uint16_t>(from, metres);
        const auto* values = reinterpret_cast<const float*>(from);
        for (std::size_t x = 0; x < metres.size(); ++x) {
            const float value = values[x * std::size_t(m_layout.channels)];
            metres[x] = marksVoid(value) ? kVoid : value;
        }
    }

private:
    template <class T> void scaled(const std::byte* from, std::span<float> metres) const
    {
        const auto* values = reinterpret_cast<const T*>(from);
        const double low = m_low, step = (m_high - m_low) / double(std::numeric_limits<T>::max());
        if (m_layout.channels == 1) // a loop of its own, which becomes vector instructions
            for (std::size_t x = 0; x < metres.size(); ++x)
                metres[x] = float(low + step * values[x]);
        else
            for (std::size_t x = 0; x < metres.size(); ++x)
                metres[x] = float(low + step * values[x * std::size_t(m_layout.channels)]);
    }

    ImageLayout m_layout;
    double m_low, m_high; // m
};

// Rows of about 4 MB together, whole steps of the decoder.
int bandOf(const ImageRows& rows)
{
    constexpr std::size_t kBytes = 4 << 20, kRows = 512;
    const int wanted = int(std::clamp<std::size_t>(kBytes / rows.packedRowBytes(), 1, kRows));
    return std::min(std::max(wanted / rows.step(), 1) * rows.step(), rows.layout().size.y);
}

// Unpacks one band while another thread makes heights of the one before.
Status readRows(ImageRows& rows, const Terrain& terrain, HeightMapBuilder& map, const Progress& progress, const std::filesystem::path& file)
{
    const int all = rows.layout().size.y, band = bandOf(rows);
    const ToMetres toMetres{rows.layout(), terrain};
    std::vector<float> metres(std::size_t(rows.layout().size.x));
    const auto add = [&](const std::byte* packed, int count) -> Status {
        for (int i = 0; i < count; ++i) {
            const auto pixels = rows.pixels(packed + rows.packedRowBytes() * std::size_t(i));
            if (!pixels) return pixels.error();
            toMetres.row(*pixels, metres);
            map.addRow(metres);
        }
        return {};
    };
    std::vector<std::byte> unpacked(rows.packedRowBytes() * std::size_t(band)), adding(band < all ? unpacked.size() : 0);
    std::future<Status> work; // on `adding`
    for (int row = 0; row < all; row += band) {
        if (!report(progress, float(row) / float(all), file.filename().string())) return Error{file.string(), "reading was cancelled"};
        const int count = std::min(band, all - row);
        if (Status read = rows.next(count, unpacked.data()); !read) return read;
        if (work.valid())
            if (Status added = work.get(); !added) return added;
        if (row + count == all) return add(unpacked.data(), count);
        std::swap(unpacked, adding);
        work = std::async(std::launch::async, add, adding.data(), count);
    }
    return {};
}

void complainOf(const ImageLayout& layout, const Terrain& terrain, const std::string& where, Complaints& complaints)
{
    if (layout.channels > 1)
        complaints.push_back({Severity::Warning, where, "a colour image as a height map; its first channel is used"});
    if (layout.type == PixelType::F32) return;
    if (terrain.maxHeight < terrain.minHeight)
        complaints.push_back({Severity::Warning, where, "max_height is below min_height; the ground is upside down"});
    if (layout.type == PixelType::U8)
        complaints.push_back({Severity::Warning, where,
                              "8 bits make steps of " + numberText((terrain.maxHeight - terrain.minHeight) / 255) +
                                  " m; save it with 16 bits"});
}

Result<HeightMap> read(const std::filesystem::path& file, const Terrain& terrain, Complaints& complaints, const Progress& progress)
{
    const std::string where = file.string();
    const auto rows = openImageRows(file, kGroundLimits.side);
    if (!rows) return rows.error();
    const ImageLayout layout = (*rows)->layout();
    if (layout.size.x < 2 || layout.size.y < 2) return Error{where, "a height map needs at least 2 x 2 pixels"};

    HeightMapBuilder builder{layout.size};
    if (Status whole = readRows(**rows, terrain, builder, progress, file); !whole) return whole.error();
    complainOf(layout, terrain, where, complaints);
    if (builder.voids() == std::size_t(layout.size.x) * std::size_t(layout.size.y)) return Error{where, "a height map without a single height"};
    if (!fillVoids(builder, progress, file.filename().string())) return Error{where, "reading was cancelled"};
    if (builder.voids() > 0)
        complaints.push_back({Severity::Warning, where, std::to_string(builder.voids()) + " heights are missing; filled from their neighbours"});
    HeightMap map = builder.finish(terrain.metresPerTexel, terrain.origin);
    map.shares = layout.type != PixelType::F32;
    return map;
}

std::uint16_t sample16(float metres, double minHeight, double maxHeight)
{
    return std::uint16_t(std::lround(std::clamp((double(metres) - minHeight) / (maxHeight - minHeight), 0.0, 1.0) * 65535));
}

// A PNG of 16 bits; row(z, metres) fills one.
template <class Row> Result<std::string> encoded16(glm::ivec2 size, double minHeight, double maxHeight, const Row& row)
{
    EXPECTS(maxHeight > minHeight);
    std::vector<float> metres(std::size_t(size.x));
    return encodePngRows({.size = size, .channels = 1, .type = PixelType::U16}, [&](int z, int, std::byte* to) {
        row(z, metres);
        auto* texel = reinterpret_cast<std::uint16_t*>(to);
        for (const float m : metres)
            *texel++ = sample16(m, minHeight, maxHeight);
    });
}

void copyRow(const HeightMap& heights, int z, std::span<float> metres)
{
    auto to = metres.begin();
    heights.field().eachRun({{0, z}, {heights.size.x, z + 1}}, [&](const float* run, std::size_t count) { to = std::copy_n(run, count, to); });
}

} // namespace

Result<HeightMap> readHeightMap(const std::filesystem::path& file, const Terrain& terrain, Complaints& complaints, const Progress& progress)
{
    try {
        return read(file, terrain, complaints, progress);
    } catch (const std::exception& error) { // there is not enough memory
        return Error{file.string(), std::string{"cannot be decoded: "} + error.what()};
    }
}

Status writeHeightMap16(const std::filesystem::path& file, const HeightGrid& heights, double minHeight, double maxHeight)
{
    const Result<std::string> png = encoded16(heights.size, minHeight, maxHeight, [&](int z, std::span<float> metres) {
        std::copy_n(heights.metres.begin() + std::ptrdiff_t(metres.size()) * z, metres.size(), metres.begin());
    });
    if (!png) return Error{file.string(), png.error().what};
    return writeFile(file, *png);
}

bool holdsHeights(const std::filesystem::path& file)
{
    const std::string extension = lowerExtension(file);
    return extension == ".png" || extension == ".exr" || extension == ".tif" || extension == ".tiff";
}

std::vector<std::uint16_t> samples16(const HeightGrid& heights, double minHeight, double maxHeight)
{
    EXPECTS(maxHeight > minHeight);
    std::vector<std::uint16_t> samples;
    samples.reserve(heights.metres.size());
    for (const float metres : heights.metres)
        samples.push_back(sample16(metres, minHeight, maxHeight));
    return samples;
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
    const std::string extension = lowerExtension(terrain.heightMap);
    if (extension == ".png") {
        makeRoom(heights, terrain);
        return encoded16(heights.size, terrain.minHeight, terrain.maxHeight, [&](int z, std::span<float> metres) { copyRow(heights, z, metres); });
    }
    const auto source = [&](int first, int count, std::byte* rows) {
        for (int i = 0; i < count; ++i)
            copyRow(heights, first + i, {reinterpret_cast<float*>(rows) + std::size_t(i) * std::size_t(heights.size.x), std::size_t(heights.size.x)});
    };
    return encodeFloatRows(extension, {.size = heights.size, .channels = 1, .type = PixelType::F32}, source);
}

} // namespace io
