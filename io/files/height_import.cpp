#include "io/files/height_import.h"

#include "io/files/atomic_file.h"
#include "io/files/geo_tiff.h"
#include "io/files/void_filling.h"
#include "io/files/image_file.h"
#include "io/scene/field_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t(1280) << 20; // bytes; 16385 x 16385 floats
constexpr float kHighestGround = 9000;                            // m; no ground on earth is higher
constexpr double kUsualRelief = 0.1;                              // of the ground's width

void warn(Complaints& complaints, const fs::path& file, std::string what)
{
    complaints.push_back({Severity::Warning, file.string(), std::move(what)});
}

std::string sizeText(glm::ivec2 size)
{
    return fmt::format("{} x {}", size.x, size.y);
}

template <class T> bool grey(const Image& image)
{
    for (int z = 0; z < image.size.y; ++z) {
        const T* row = image.row<T>(z);
        for (int x = 0; x < image.size.x; ++x, row += image.channels)
            if (row[0] != row[1] || row[0] != row[2]) return false;
    }
    return true;
}

bool grey(const Image& image)
{
    if (image.channels < 3) return true; // the second one is alpha
    if (image.type == PixelType::U8) return grey<std::uint8_t>(image);
    return image.type == PixelType::U16 ? grey<std::uint16_t>(image) : grey<float>(image);
}

template <class T> std::vector<float> firstChannel(const Image& image)
{
    std::vector<float> values;
    values.reserve(std::size_t(image.size.x) * std::size_t(image.size.y));
    for (int z = 0; z < image.size.y; ++z)
        for (int x = 0; x < image.size.x; ++x)
            values.push_back(float(image.row<T>(z)[std::size_t(x) * std::size_t(image.channels)]));
    return values;
}

// The first file beside it with one of these endings, as a text.
std::optional<std::string> sidecar(const fs::path& file, std::initializer_list<const char*> extensions)
{
    for (const char* extension : extensions) {
        fs::path whole = file, stem = file; // NAME.r16.hdr, NAME.hdr
        whole += extension;
        stem.replace_extension(extension);
        for (const fs::path& beside : {whole, stem}) {
            std::error_code fault;
            if (!fs::is_regular_file(beside, fault)) continue;
            if (Result<std::string> text = readFile(beside, 1 << 16)) return *std::move(text);
        }
    }
    return std::nullopt;
}

// The first line of a world file (.pgw, .tfw, .wld): the width of a pixel.
std::optional<double> worldFileMetres(const fs::path& file)
{
    const auto text = sidecar(file, {".pgw", ".tfw", ".wld"});
    double metres = 0;
    if (!text || std::from_chars(text->data(), text->data() + text->size(), metres).ec != std::errc{}) return std::nullopt;
    return std::isfinite(metres) && metres > 0 ? std::optional{metres} : std::nullopt;
}

Status fromImage(HeightSource& source, std::string_view bytes, const RawLayout& layout, std::optional<double>& nodata,
                 Complaints& complaints)
{
    const std::string where = source.file.string();
    const Result<Image> image = decodeImage(bytes, where, kGroundLimits);
    if (!image) return image.error();
    if (layout.size && *layout.size != image->size)
        return Error{where, fmt::format("has {} pixels, not {}; leave the size out, an image has its own", sizeText(image->size),
                                        sizeText(*layout.size))};
    if (!grey(*image))
        return Error{where, fmt::format("a picture of {} channels that differ is no height map; save it as grey, best with 16 bits",
                                        image->channels)};
    source.size = image->size;
    source.metres = image->type == PixelType::F32;
    source.full = image->type == PixelType::U8 ? 255 : 65535;
    source.sample = image->type == PixelType::U8 ? HeightSample::U8 : source.metres ? HeightSample::F32 : HeightSample::U16;
    source.values = source.metres        ? firstChannel<float>(*image)
                    : source.full == 255 ? firstChannel<std::uint8_t>(*image)
                                         : firstChannel<std::uint16_t>(*image);

    const GeoTiff geo = geoTiffOf(bytes);
    nodata = geo.nodata;
    source.metresPerTexel = geo.metresPerTexel;
    if (geo.stretch > 1.02 || geo.stretch < 0.98)
        warn(complaints, source.file,
             fmt::format("its pixels are not square ({:.2f} times as long from north to south as wide); the area is kept, for the "
                         "shape warp it to metres in a GIS", geo.stretch));
    if (!source.metresPerTexel && (source.metresPerTexel = worldFileMetres(source.file))) source.metresFrom = KnownFrom::Sidecar;
    return {};
}

void measureHgt(HeightSource& source, const Hgt& hgt, Complaints& complaints)
{
    source.metresFrom = hgt.latitude ? KnownFrom::Name : KnownFrom::Usual;
    const DegreeMetres degree = metresOfDegree(hgt.latitude.value_or(0));
    source.metresPerTexel = std::sqrt(degree.north * degree.east) * hgt.arcSeconds / 3600;
    if (!hgt.latitude)
        warn(complaints, source.file, "its name tells no latitude (as N46E008.hgt does); texels are measured as at the equator");
    else if (degree.north / degree.east > 1.02)
        warn(complaints, source.file,
             fmt::format("its texels are {:.1f} x {:.1f} m there; the area is kept, for the shape warp it to metres in a GIS",
                         degree.east * hgt.arcSeconds / 3600, degree.north * hgt.arcSeconds / 3600));
}

Status fromRaw(HeightSource& source, std::string_view bytes, RawLayout layout, std::optional<double>& nodata,
               Complaints& complaints)
{
    RawHeader header;
    const bool hgt = isHgt(source.file);
    if (hgt) {
        const Result<Hgt> tile = hgtOf(bytes.size(), source.file);
        if (!tile) return tile.error();
        header.layout = {.sample = HeightSample::I16, .bigEndian = true};
        measureHgt(source, *tile, complaints);
    } else if (const auto text = sidecar(source.file, {".hdr", ".HDR"})) {
        header = readRawHeader(*text);
        source.metresPerTexel = header.cellSize;
        source.metresFrom = KnownFrom::Sidecar;
        source.heights = header.heights;
        nodata = header.nodata;
    }
    source.sizeFrom = hgt                  ? KnownFrom::File
                      : layout.size        ? KnownFrom::Given
                      : header.layout.size ? KnownFrom::Sidecar
                                           : KnownFrom::Values;
    if (!layout.size) layout.size = header.layout.size;
    if (!layout.sample) layout.sample = header.layout.sample;
    if (!layout.bigEndian) layout.bigEndian = header.layout.bigEndian;
    Result<RawSamples> raw = readRawSamples(bytes, source.file, layout, complaints);
    if (!raw) return raw.error();
    source.raw = !hgt;
    source.size = raw->size;
    source.sample = raw->sample;
    source.bigEndian = raw->bigEndian;
    source.metres = raw->sample == HeightSample::I16 || raw->sample == HeightSample::F32;
    source.full = raw->sample == HeightSample::U8 ? 255 : 65535;
    source.values = std::move(raw->values);
    return {};
}

bool sharesOfOne(const HeightSource& source)
{
    return source.metres && source.sample == HeightSample::F32 && source.lowest >= 0 && source.highest <= 1;
}

// The heights of the lowest and highest value where nobody said them.
glm::dvec2 guessedHeights(const HeightSource& source, double width, const Scene& scene, KnownFrom& from)
{
    const Terrain& now = scene.terrain();
    if (scene.heights() && scene.heights()->size == source.size && scene.heights()->shares) {
        from = KnownFrom::Ground;
        return {now.minHeight, now.maxHeight};
    }
    if (source.full > 255 && source.highest < kHighestGround && source.highest > 255) {
        from = KnownFrom::Values; // whole metres, as many programs write them
        return {0, source.full};
    }
    from = KnownFrom::Usual;
    return {0, std::max(10.0, std::round(width * kUsualRelief))};
}

} // namespace

std::string_view nameOf(KnownFrom from)
{
    return enumNames(from)[std::size_t(from)];
}

Result<HeightSource> readHeightSource(const fs::path& file, const RawLayout& layout, Complaints& complaints)
{
    const std::string where = file.string();
    const Result<std::string> bytes = readFile(file, kLargestFile);
    if (!bytes) return bytes.error();
    HeightSource source{.file = file};
    std::optional<double> nodata;
    const Status read = holdsRawSamples(file) ? fromRaw(source, *bytes, layout, nodata, complaints)
                                              : fromImage(source, *bytes, layout, nodata, complaints);
    if (!read) return read.error();
    if (source.size.x < 2 || source.size.y < 2)
        return Error{where, "a height map needs at least 2 x 2 texels; this one has " + sizeText(source.size)};
    for (float& value : source.values)
        if ((source.metres && marksVoid(value)) || (nodata && value == float(*nodata))) value = kVoid;
    const auto filled = fillVoids(source.size, source.values);
    if (!filled) return Error{where, "a height map without a single height: all of its values are NaN, infinite or marks of missing data"};
    source.voids = *filled;
    if (source.voids > source.values.size() / 20 * 19)
        return Error{where, fmt::format("{} of {} heights are missing or beyond 100 km; it is no height map in metres, export it with "
                                        "16 bits or as floats", source.voids, source.values.size())};
    std::tie(source.lowest, source.highest) = std::pair{std::ranges::min(source.values), std::ranges::max(source.values)};
    if (source.voids > 0)
        warn(complaints, file, fmt::format("{} heights are missing ({:.2g} % of all); filled from their neighbours", source.voids,
                                           100.0 * double(source.voids) / double(source.values.size())));
    return source;
}

namespace {

// The limits that a scene's file has for a field of the terrain.
struct LimitsOf {
    std::string_view key;
    Hint found = {};
    void operator()(std::string_view name, auto&, const Hint& hint)
    {
        if (name == key) found = hint;
    }
};

Hint limitsOf(std::string_view key)
{
    LimitsOf visitor{key};
    Terrain terrain;
    fields(visitor, terrain);
    return visitor.found;
}

Status checkMeasures(const HeightSource& source, double metresPerTexel, const std::optional<glm::dvec2>& heights)
{
    const std::string where = source.file.string();
    const Hint metres = limitsOf("metres_per_texel"), height = limitsOf("min_height");
    if (!(metresPerTexel >= metres.min && metresPerTexel <= metres.max))
        return Error{where, fmt::format("{} metres per texel; say {} to {}", metresPerTexel, metres.min, metres.max)};
    if (heights && !(heights->x < heights->y && heights->x >= height.min && heights->y <= height.max))
        return Error{where, fmt::format("heights from {} to {} m; say the lower one first, and both within {} m", heights->x, heights->y,
                                        height.max)};
    return {};
}

// Metres of a value are offset + step * value.
struct Scale {
    double offset = 0, step = 1;
};

Scale scaleOf(const HeightSource& source, const ImportedGround& ground)
{
    if (!ground.scaled) return {};
    return {ground.scaledFrom.x, (ground.scaledFrom.y - ground.scaledFrom.x) / (source.metres ? 1.0 : double(source.full))};
}

} // namespace

Result<ImportedGround> planGround(const HeightSource& source, const HeightMeasures& measures, const Scene& scene, Complaints& complaints)
{
    ImportedGround ground;
    HeightGrid& grid = ground.grid;
    const bool there = scene.heights() != nullptr;
    grid.size = source.size;
    grid.metresPerTexel = measures.metresPerTexel.value_or(source.metresPerTexel.value_or(there ? scene.terrain().metresPerTexel : 1));
    ground.metresFrom = measures.metresPerTexel ? KnownFrom::Given
                        : source.metresPerTexel ? source.metresFrom
                        : there                 ? KnownFrom::Ground
                                                : KnownFrom::Usual;
    if (const Status sound = checkMeasures(source, grid.metresPerTexel, measures.heights); !sound) return sound.error();
    const bool inPlace = there && scene.heights()->size == source.size && scene.terrain().metresPerTexel == grid.metresPerTexel;
    grid.origin = inPlace ? scene.terrain().origin : -glm::dvec2{source.size - 1} * grid.metresPerTexel / 2.0;

    if (source.metres && measures.heights && !sharesOfOne(source))
        return Error{source.file.string(),
                     fmt::format("its values, {} to {}, are metres already; leave the heights out", source.lowest, source.highest)};
    if (source.metres && !measures.heights) {
        if (sharesOfOne(source) && source.lowest < source.highest)
            warn(complaints, source.file,
                 "all its heights lie between 0 and 1 m; if these are shares of a height, say the heights of 0 and 1");
        ground.heightsFrom = KnownFrom::File;
    } else {
        ground.heightsFrom = measures.heights ? KnownFrom::Given : KnownFrom::Sidecar;
        ground.scaled = true;
        ground.scaledFrom = measures.heights ? *measures.heights
                            : source.heights ? *source.heights
                                             : guessedHeights(source, grid.metresPerTexel * source.size.x, scene, ground.heightsFrom);
        if (const Status sound = checkMeasures(source, grid.metresPerTexel, ground.scaledFrom); !sound) return sound.error();
        ground.shares = !source.metres && ground.heightsFrom != KnownFrom::Values;
        if (source.full == 255 && !source.metres)
            warn(complaints, source.file, fmt::format("8 bits make steps of {:.3g} m; save it with 16 bits", scaleOf(source, ground).step));
    }
    const auto [offset, step] = scaleOf(source, ground);
    ground.minHeight = ground.shares ? ground.scaledFrom.x : std::floor(offset + step * source.lowest); // floats do not need them
    ground.maxHeight = ground.shares ? ground.scaledFrom.y : std::max(std::ceil(offset + step * source.highest), ground.minHeight + 1);
    return ground;
}

Result<ImportedGround> groundFrom(const HeightSource& source, const HeightMeasures& measures, const Scene& scene, Complaints& complaints)
{
    Result<ImportedGround> ground = planGround(source, measures, scene, complaints);
    if (!ground) return ground;
    const auto [offset, step] = scaleOf(source, *ground);
    ground->grid.metres.reserve(source.values.size());
    for (const float value : source.values)
        ground->grid.metres.push_back(ground->scaled ? float(offset + step * double(value)) : value);
    return ground;
}

} // namespace io
