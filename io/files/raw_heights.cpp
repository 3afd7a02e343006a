#include "io/files/raw_heights.h"

#include "io/files/file_names.h"
#include "io/files/image_file.h"
#include "io/scene/field_words.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

namespace io {
namespace fs = std::filesystem;
namespace {

std::string lower(std::string_view text)
{
    std::string result{text};
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return result;
}

std::optional<double> numberOf(std::string_view text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && std::isfinite(value) ? std::optional{value} : std::nullopt;
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t start = line.find_first_not_of(" \t\r", at);
        if (start == line.npos) break;
        at = std::min(line.find_first_of(" \t\r", start), line.size());
        words.push_back(line.substr(start, at - start));
    }
    return words;
}

// n where n * n is the count, else 0.
int sideOf(std::size_t count)
{
    const auto side = std::size_t(std::llround(std::sqrt(double(count))));
    return side * side == count && side <= std::size_t(kGroundLimits.side) ? int(side) : 0;
}

std::uint32_t swapped(std::uint32_t bits, int size)
{
    if (size == 2) return (bits >> 8 & 0xff) | (bits & 0xff) << 8;
    return bits >> 24 | (bits >> 8 & 0xff00) | (bits & 0xff00) << 8 | bits << 24;
}

float valueAt(std::string_view bytes, std::size_t index, HeightSample sample, bool bigEndian)
{
    const auto size = std::size_t(bytesOf(sample));
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes.data() + index * size, size); // the machine is little endian: io/files/cover_map_file.cpp asserts it
    if (bigEndian && size > 1) bits = swapped(bits, int(size));
    return sample == HeightSample::F32   ? std::bit_cast<float>(bits)
           : sample == HeightSample::I16 ? float(std::int16_t(bits))
                                         : float(bits);
}

// Whether the bytes make sense as floats: a file of anything else is full of numbers that no ground has.
bool looksLikeFloats(std::string_view bytes, bool bigEndian)
{
    const std::size_t count = std::min<std::size_t>(bytes.size() / 4, 4096);
    std::size_t odd = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float value = valueAt(bytes, i * (bytes.size() / 4 / count), HeightSample::F32, bigEndian);
        odd += std::isfinite(value) && value != 0 && (std::abs(value) > 1e6f || std::abs(value) < 1e-12f);
    }
    return odd * 50 < count;
}

// The sum of steps between neighbours in the middle row, which the wrong byte order makes far larger.
double roughness(std::string_view bytes, const RawSamples& raw, bool bigEndian)
{
    const std::size_t row = std::size_t(raw.size.y / 2) * std::size_t(raw.size.x);
    double sum = 0;
    for (std::size_t x = 1; x < std::size_t(raw.size.x); ++x)
        sum += std::abs(double(valueAt(bytes, row + x, raw.sample, bigEndian)) - double(valueAt(bytes, row + x - 1, raw.sample, bigEndian)));
    return sum;
}

std::optional<HeightSample> sampleByName(const fs::path& file)
{
    const std::string extension = lowerExtension(file);
    if (extension == ".r16") return HeightSample::U16;
    if (extension == ".r32" || extension == ".flt") return HeightSample::F32;
    return std::nullopt;
}

// Fills what is not known from the number of bytes; false where nothing fits.
bool guess(RawSamples& raw, const RawLayout& layout, std::string_view bytes)
{
    if (layout.size) {
        raw.size = *layout.size;
        const std::size_t count = std::size_t(raw.size.x) * std::size_t(raw.size.y);
        if (!layout.sample)
            raw.sample = bytes.size() == count * 4 ? HeightSample::F32 : bytes.size() == count ? HeightSample::U8 : HeightSample::U16;
        return count * std::size_t(bytesOf(raw.sample)) == bytes.size();
    }
    raw.sizeGuessed = true;
    for (const HeightSample sample : {HeightSample::U16, HeightSample::F32, HeightSample::I16, HeightSample::U8}) {
        if (layout.sample ? sample != *layout.sample : sample == HeightSample::I16) continue;
        const auto size = std::size_t(bytesOf(sample));
        const int side = bytes.size() % size == 0 ? sideOf(bytes.size() / size) : 0;
        if (side < 2 || (!layout.sample && sample == HeightSample::F32 && !looksLikeFloats(bytes, raw.bigEndian))) continue;
        raw.size = {side, side};
        raw.sample = sample;
        return true;
    }
    return false;
}

} // namespace

RawHeader readRawHeader(std::string_view text)
{
    RawHeader header;
    std::optional<double> rows, columns, bits;
    std::string kind;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const auto words = wordsOf(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (words.size() < 2) continue;
        const std::string key = lower(words[0]), word = lower(words[1]);
        const auto value = numberOf(words[1]);
        if (key == "nrows") rows = value;
        else if (key == "ncols") columns = value;
        else if (key == "nbits") bits = value;
        else if (key == "pixeltype") kind = word;
        else if (key == "byteorder") header.layout.bigEndian = word == "m" || word == "msbfirst";
        else if ((key == "xdim" || key == "cellsize") && value && *value > 0) header.cellSize = value;
        else if (key == "nodata" || key == "nodata_value") header.nodata = value;
        else if (key == "heights" && words.size() > 2 && value && numberOf(words[2])) header.heights = glm::dvec2{*value, *numberOf(words[2])};
    }
    const auto sound = [](const std::optional<double>& side) { return side && *side >= 1 && *side <= kGroundLimits.side; };
    if (sound(rows) && sound(columns)) header.layout.size = glm::ivec2{int(*columns), int(*rows)};
    if (kind == "float" || bits == 32.0) header.layout.sample = HeightSample::F32;
    else if (bits == 8.0) header.layout.sample = HeightSample::U8;
    else if (bits == 16.0) header.layout.sample = kind == "signedint" ? HeightSample::I16 : HeightSample::U16;
    return header;
}

std::string rawHeaderText(glm::ivec2 size, HeightSample sample, double metresPerTexel, glm::dvec2 origin, std::optional<glm::dvec2> heights)
{
    // World z grows to the south, a map's y to the north.
    const std::string heightsLine = heights ? fmt::format("HEIGHTS {} {}\n", heights->x, heights->y) : "";
    const char* type = sample == HeightSample::F32 ? "FLOAT" : sample == HeightSample::I16 ? "SIGNEDINT" : "UNSIGNEDINT";
    return fmt::format("BYTEORDER I\nLAYOUT BIL\nNROWS {}\nNCOLS {}\nNBANDS 1\nNBITS {}\nPIXELTYPE {}\nULXMAP {}\nULYMAP {}\nXDIM {}\n"
                       "YDIM {}\n{}", size.y, size.x, bytesOf(sample) * 8, type, origin.x, -origin.y, metresPerTexel, metresPerTexel,
                       heightsLine);
}

bool holdsRawSamples(const fs::path& file)
{
    const std::string extension = lowerExtension(file);
    constexpr std::string_view kRaw[] = {".raw", ".r16", ".r32", ".bil", ".flt", ".hgt"};
    return std::ranges::count(kRaw, extension) > 0;
}

bool isHgt(const fs::path& file)
{
    return lowerExtension(file) == ".hgt";
}

Result<RawSamples> readRawSamples(std::string_view bytes, const fs::path& file, RawLayout layout, Complaints& complaints)
{
    const std::string where = file.string();
    if (!layout.sample) layout.sample = sampleByName(file);
    RawSamples raw{.sample = layout.sample.value_or(HeightSample::U16), .bigEndian = layout.bigEndian.value_or(false)};
    if (layout.size && (layout.size->x < 2 || layout.size->y < 2 || layout.size->x > kGroundLimits.side || layout.size->y > kGroundLimits.side))
        return Error{where, fmt::format("{} x {} texels; a side has 2 to {}", layout.size->x, layout.size->y, kGroundLimits.side)};
    if (!guess(raw, layout, bytes)) {
        if (layout.size)
            return Error{where, fmt::format("{} bytes are not {} x {} samples of {} bits, which take {}; say another size or kind of "
                                            "sample", bytes.size(), raw.size.x, raw.size.y, bytesOf(raw.sample) * 8,
                                            std::size_t(raw.size.x) * std::size_t(raw.size.y) * std::size_t(bytesOf(raw.sample)))};
        return Error{where, fmt::format("{} bytes are no square of samples, so the size cannot be guessed; say it, as 1025x513, and the "
                                        "kind of sample", bytes.size())};
    }
    const std::size_t count = std::size_t(raw.size.x) * std::size_t(raw.size.y);
    raw.values.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        raw.values[i] = valueAt(bytes, i, raw.sample, raw.bigEndian);
    if (!layout.bigEndian && bytesOf(raw.sample) == 2 && roughness(bytes, raw, false) > 4 * roughness(bytes, raw, true))
        complaints.push_back({Severity::Warning, where,
                              "would be far smoother in the other byte order; say that it is big endian if it comes out as noise"});
    return raw;
}

Result<Hgt> hgtOf(std::size_t bytes, const fs::path& file)
{
    const int side = bytes % 2 == 0 ? sideOf(bytes / 2) : 0;
    if (side != 1201 && side != 3601)
        return Error{file.string(), fmt::format("{} bytes are no SRTM tile, which has 1201 x 1201 (2884802 bytes) or 3601 x 3601 samples "
                                                "(25934402 bytes); fetch it again, or name it .raw and say its size", bytes)};
    Hgt hgt{.arcSeconds = side == 1201 ? 3.0 : 1.0};
    const std::string stem = lower(file.stem().string());
    if (stem.size() >= 7 && (stem[0] == 'n' || stem[0] == 's') && (stem[3] == 'e' || stem[3] == 'w'))
        if (const auto corner = numberOf(std::string_view{stem}.substr(1, 2))) hgt.latitude = (stem[0] == 'n' ? *corner : -*corner) + 0.5;
    return hgt;
}

} // namespace io
