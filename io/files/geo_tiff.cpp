#include "io/files/geo_tiff.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <vector>

namespace io {
namespace {

using namespace std::string_view_literals;

// TIFF 6.0, section 2: a header, then a directory of twelve-byte entries: tag, type, count, value or where it lies.
class Tags {
public:
    explicit Tags(std::string_view bytes) : m_bytes{bytes}
    {
        m_little = bytes.starts_with("II*\0"sv);
        if (!m_little && !bytes.starts_with("MM\0*"sv)) return;
        m_directory = integer(4, 4).value_or(0);
        m_count = m_directory == 0 ? 0 : integer(m_directory, 2).value_or(0);
    }

    std::vector<double> doubles(std::uint32_t tag) const { return values<double>(tag, 12, 8, &Tags::decimal); }
    std::vector<double> shorts(std::uint32_t tag) const { return values<double>(tag, 3, 2, &Tags::small); }
    std::string_view text(std::uint32_t tag) const
    {
        const Data data = find(tag, 2, 1);
        return data.at + data.count <= m_bytes.size() ? m_bytes.substr(data.at, data.count) : ""sv;
    }

private:
    static constexpr std::size_t kMost = 4096; // values of a tag; no GeoTIFF comes near

    struct Data {
        std::size_t at = 0, count = 0;
    };

    std::optional<std::uint64_t> integer(std::size_t at, std::size_t size) const
    {
        if (at > m_bytes.size() || m_bytes.size() - at < size) return std::nullopt;
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value = value << 8 | static_cast<unsigned char>(m_bytes[at + (m_little ? size - 1 - i : i)]);
        return value;
    }
    std::optional<double> decimal(std::size_t at) const
    {
        const auto bits = integer(at, 8);
        return bits ? std::optional{std::bit_cast<double>(*bits)} : std::nullopt;
    }
    std::optional<double> small(std::size_t at) const
    {
        const auto value = integer(at, 2);
        return value ? std::optional{double(*value)} : std::nullopt;
    }
    Data find(std::uint32_t tag, std::uint32_t type, std::size_t size) const
    {
        for (std::size_t i = 0; i < m_count; ++i) {
            const std::size_t entry = m_directory + 2 + 12 * i;
            const auto key = integer(entry, 2), kind = integer(entry + 2, 2), count = integer(entry + 4, 4);
            if (!key || !kind || !count) return {};
            if (*key != tag || *kind != type || *count > kMost) continue;
            return {*count * size <= 4 ? entry + 8 : std::size_t(integer(entry + 8, 4).value_or(m_bytes.size())), std::size_t(*count)};
        }
        return {};
    }
    template <class T> std::vector<T> values(std::uint32_t tag, std::uint32_t type, std::size_t size, std::optional<T> (Tags::*read)(std::size_t) const) const
    {
        const Data data = find(tag, type, size);
        std::vector<T> all;
        for (std::size_t i = 0; i < data.count; ++i) {
            const auto value = (this->*read)(data.at + i * size);
            if (!value) return {};
            all.push_back(*value);
        }
        return all;
    }

    std::string_view m_bytes;
    bool m_little = false;
    std::size_t m_directory = 0, m_count = 0;
};

// GeoTIFF 1.1, section 7.1: rows of key, place (0: here), count, value.
std::optional<int> geoKey(const std::vector<double>& directory, int key)
{
    for (std::size_t at = 4; at + 3 < directory.size(); at += 4)
        if (directory[at] == key && directory[at + 1] == 0) return int(directory[at + 3]);
    return std::nullopt;
}

constexpr int kModelType = 1024, kGeographic = 2, kLinearUnits = 3076;
constexpr int kFoot = 9002, kSurveyFoot = 9003;

} // namespace

DegreeMetres metresOfDegree(double latitude)
{
    // The usual series of the meridian and the parallel, exact to centimetres.
    const double phi = latitude * std::numbers::pi / 180;
    return {111132.954 - 559.822 * std::cos(2 * phi) + 1.175 * std::cos(4 * phi), 111412.84 * std::cos(phi) - 93.5 * std::cos(3 * phi)};
}

GeoTiff geoTiffOf(std::string_view bytes)
{
    const Tags tags{bytes};
    GeoTiff geo;
    std::string_view mark = tags.text(42113);
    while (!mark.empty() && mark.front() == ' ')
        mark.remove_prefix(1);
    double nodata = 0;
    if (std::from_chars(mark.data(), mark.data() + mark.size(), nodata).ec == std::errc{}) geo.nodata = nodata;

    const std::vector<double> scale = tags.doubles(33550), tie = tags.doubles(33922), keys = tags.shorts(34735);
    if (scale.size() < 2 || !(std::abs(scale[0]) > 0) || !(std::abs(scale[1]) > 0)) return geo;
    double east = std::abs(scale[0]), north = std::abs(scale[1]);
    if (geoKey(keys, kModelType) == kGeographic) {
        const std::vector<double> rows = tags.shorts(257); // ImageLength; of larger files a LONG, which only moves the latitude
        const double middle = tie.size() < 5 ? 0 : tie[4] - north * ((rows.empty() ? 0 : rows[0] / 2) - tie[1]);
        const DegreeMetres degree = metresOfDegree(std::isfinite(middle) ? std::fmin(std::fmax(middle, -89), 89) : 0);
        east *= degree.east;
        north *= degree.north;
    } else if (const int unit = geoKey(keys, kLinearUnits).value_or(0); unit == kFoot || unit == kSurveyFoot) {
        const double foot = unit == kFoot ? 0.3048 : 1200.0 / 3937;
        east *= foot;
        north *= foot;
    }
    const double metres = std::sqrt(east * north); // keeps the area
    if (!std::isfinite(metres) || metres <= 0) return geo;
    geo.metresPerTexel = metres;
    geo.stretch = north / east;
    return geo;
}

} // namespace io
