#include "io/files/image_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kPngStart = "\x89PNG\r\n\x1a\n"sv;

std::string words(std::int64_t width, std::int64_t height)
{
    return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

std::uint32_t bigEndian(std::string_view bytes, std::size_t at, int count)
{
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// PNG (ISO/IEC 15948) is a row of chunks: length, four letters, data, checksum.
std::string pngWithoutMetadata(std::string_view bytes)
{
    std::string out{kPngStart};
    std::size_t at = kPngStart.size();
    while (at + 12 <= bytes.size()) {
        const std::size_t size = std::size_t(bigEndian(bytes, at, 4)) + 12;
        const std::string_view chunk = bytes.substr(at, size); // a cut-off one is for the decoder to refuse
        if (pngChunkHasPixels(chunk.substr(4, 4))) out += chunk;
        at += chunk.size();
    }
    return out;
}

// JPEG (ITU T.81) is a row of segments up to the start of scan: FF, marker, length, data. Answers where they end.
template <class Take> std::size_t eachSegment(std::string_view bytes, Take take)
{
    std::size_t at = 2;
    while (at + 4 <= bytes.size() && bytes[at] == '\xFF') {
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        if (marker == 0xFF) { // padding
            ++at;
            continue;
        }
        const std::size_t size = std::size_t(bigEndian(bytes, at + 2, 2)) + 2;
        if (marker == 0xDA || marker < 0xC0 || size > bytes.size() - at) break;
        take(marker, bytes.substr(at, size));
        at += size;
    }
    return at;
}

// APP0 (JFIF) and APP14 (Adobe's colour transform) say how to read the pixels, the other APPn and comments do not.
std::string jpegWithoutMetadata(std::string_view bytes)
{
    std::string out{bytes.substr(0, 2)};
    const std::size_t rest = eachSegment(bytes, [&](int marker, std::string_view segment) {
        const bool application = marker >= 0xE1 && marker <= 0xEF && marker != 0xEE;
        if (!application && marker != 0xFE) out += segment;
    });
    return out.append(bytes.substr(rest));
}

std::uint32_t littleEndian(std::string_view bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + std::size_t(i)]);
    return value;
}

// The pixel format of DirectDraw surfaces: flags at 80, bits a pixel at 88, masks of red, green, blue, alpha from 92.
bool soundDds(std::string_view bytes)
{
    constexpr std::uint32_t kAlpha = 0x1, kFourCc = 0x4, kRgb = 0x40, kLuminance = 0x20000, kNormal = 0x80000000;
    constexpr std::uint32_t kKnown = kAlpha | 0x2 | kFourCc | 0x20 | kRgb | 0x200 | kLuminance | 0x80000 | kNormal;
    if (bytes.size() < 128) return false;
    const std::uint32_t flags = littleEndian(bytes, 80);
    const std::uint32_t bits = littleEndian(bytes, 88);
    const auto mask = [&](int channel) { return littleEndian(bytes, 92 + 4 * std::size_t(channel)); };
    if (flags & ~kKnown) return false;
    if (flags & kFourCc) return true;
    if (bits == 0 || bits > 32 || bits % 8 != 0) return false;
    if ((flags & kRgb) && !(mask(0) && mask(1) && mask(2))) return false;
    if ((flags & kLuminance) && !mask(0)) return false;
    return !(flags & kAlpha) || mask(3);
}

} // namespace

bool pngChunkHasPixels(std::string_view letters)
{
    constexpr std::array kKept = {"IHDR"sv, "PLTE"sv, "tRNS"sv, "IDAT"sv, "IEND"sv};
    return std::find(kKept.begin(), kKept.end(), letters) != kKept.end();
}

std::string headerFault(std::string_view bytes)
{
    return imageFormat(bytes) == "dds" && !soundDds(bytes) ? "its pixel format is damaged" : "";
}

std::optional<glm::u32vec2> declaredSize(std::string_view bytes)
{
    const std::string_view format = imageFormat(bytes);
    if (format == "png" && bytes.size() >= 24) return glm::u32vec2{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
    if (format != "jpeg") return std::nullopt;
    std::optional<glm::u32vec2> size;
    eachSegment(bytes, [&](int marker, std::string_view segment) {
        const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (frame && segment.size() >= 9) size = glm::u32vec2{bigEndian(segment, 7, 2), bigEndian(segment, 5, 2)};
    });
    return size;
}

Status checkSides(std::int64_t width, std::int64_t height, const ImageLimits& limits, const std::string& where)
{
    if (width < 1 || height < 1) return Error{where, "an image of " + words(width, height)};
    if (width > limits.side || height > limits.side)
        return Error{where, words(width, height) + "; a side may have at most " + std::to_string(limits.side)};
    return {};
}

Status checkRows(const DecodedSize& size, const ImageLimits& limits, const std::string& where)
{
    if (Status sides = checkSides(size.pixels.x, size.pixels.y, limits, where); !sides) return sides;
    if (size.channels < 1 || size.channels > 64) // further channels than four are passed over
        return Error{where, std::to_string(size.channels) + " channels; at most 4 are used"};
    return {};
}

Status checkSize(const DecodedSize& size, const ImageLimits& limits, const std::string& where)
{
    if (Status rows = checkRows(size, limits, where); !rows) return rows;
    const auto [width, height] = std::pair{std::int64_t(size.pixels.x), std::int64_t(size.pixels.y)};
    const auto sample = std::max<std::uint64_t>(size.sampleBytes, 1);
    if (std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(size.channels) * sample > limits.bytes)
        return Error{where, words(width, height) + " are more than " + std::to_string(limits.bytes >> 20) + " MiB; make it smaller"};
    return {};
}

std::string_view imageFormat(std::string_view bytes)
{
    if (bytes.starts_with(kPngStart)) return "png";
    if (bytes.starts_with("\xFF\xD8\xFF"sv)) return "jpeg";
    if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv)) return "tiff";
    if (bytes.starts_with("II+\0"sv) || bytes.starts_with("MM\0+"sv)) return "tiff"; // BigTIFF
    if (bytes.starts_with("\x76\x2f\x31\x01"sv)) return "openexr";
    if (bytes.starts_with("#?RADIANCE"sv) || bytes.starts_with("#?RGBE"sv)) return "hdr";
    if (bytes.starts_with("DDS "sv)) return "dds";
    return {};
}

std::string withoutMetadata(std::string_view bytes)
{
    const std::string_view format = imageFormat(bytes);
    if (format == "png") return pngWithoutMetadata(bytes);
    if (format == "jpeg") return jpegWithoutMetadata(bytes);
    return std::string{bytes};
}

} // namespace io
