// Heights as bare samples: .raw, .r16, .r32, .bil, .flt, with a header file beside them or none; and SRTM's .hgt.
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

enum class HeightSample { U8, U16, I16, F32 };
constexpr auto enumNames(HeightSample) { return std::array<std::string_view, 4>{"u8", "u16", "i16", "f32"}; }
constexpr int bytesOf(HeightSample sample) { return sample == HeightSample::U8 ? 1 : sample == HeightSample::F32 ? 4 : 2; }

// How bare samples lie in a file, row by row from the north-west; what is empty is not known.
struct RawLayout {
    std::optional<glm::ivec2> size; // texels
    std::optional<HeightSample> sample;
    std::optional<bool> bigEndian;
};

// The header of ESRI's .bil and .flt (a .hdr beside the file, keywords and values). HEIGHTS is Wold's own word: the heights of
// the lowest and highest value of unsigned samples, m.
struct RawHeader {
    RawLayout layout;
    std::optional<double> cellSize, nodata; // m
    std::optional<glm::dvec2> heights;      // m
};
RawHeader readRawHeader(std::string_view text);
std::string rawHeaderText(glm::ivec2 size, HeightSample sample, double metresPerTexel, glm::dvec2 origin, std::optional<glm::dvec2> heights);

bool holdsRawSamples(const std::filesystem::path& file); // by its name: .raw .r16 .r32 .bil .flt .hgt
bool isHgt(const std::filesystem::path& file);

struct RawSamples {
    glm::ivec2 size{0};
    HeightSample sample = HeightSample::U16;
    bool bigEndian = false;
    bool sizeGuessed = false;
    std::vector<float> values; // as they stand in the file
};
// The size and the kind of sample are guessed where a square number of 16-bit or 32-bit samples lets them; the byte order is
// little endian unless said otherwise. An error names the number of bytes and what would fit.
Result<RawSamples> readRawSamples(std::string_view bytes, const std::filesystem::path& file, RawLayout layout, Complaints& complaints);

// Of SRTM: 1201 or 3601 big-endian samples a side of 3 or 1 arc-seconds; N46E008.hgt names its south-west corner.
struct Hgt {
    double arcSeconds = 3;
    std::optional<double> latitude; // degrees, of its middle
};
Result<Hgt> hgtOf(std::size_t bytes, const std::filesystem::path& file);

} // namespace io
