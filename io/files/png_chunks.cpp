#include "io/files/png_chunks.h"

#include "io/files/image_bytes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace io {
namespace {

constexpr std::size_t kChecksum = 4; // bytes after the data of a chunk

std::uint32_t bigEndian(const unsigned char* bytes)
{
    return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 | std::uint32_t(bytes[2]) << 8 | bytes[3];
}

int paeth(int left, int above, int corner)
{
    const int toLeft = std::abs(above - corner), toAbove = std::abs(left - corner), toCorner = std::abs(left + above - 2 * corner);
    const int other = toAbove <= toCorner ? above : corner;
    return toLeft <= std::min(toAbove, toCorner) ? left : other;
}

// predict(left, above, corner) of each byte is added to it. The pixel to the left stays in registers: through memory each
// pixel would wait for the store of the one before.
template <int kPixel, class Predict>
void addPrediction(const unsigned char* filtered, const unsigned char* above, unsigned char* row, std::size_t size, const Predict& predict)
{
    std::array<int, kPixel> left{}, corner{};
    for (std::size_t i = 0; i + kPixel <= size; i += kPixel)
        for (std::size_t byte = 0; byte < kPixel; ++byte) {
            const int up = above[i + byte];
            left[byte] = (filtered[i + byte] + predict(left[byte], up, corner[byte])) & 0xFF;
            corner[byte] = up;
            row[i + byte] = static_cast<unsigned char>(left[byte]);
        }
}

template <int kPixel>
bool unfilter(int filter, const unsigned char* filtered, const unsigned char* above, unsigned char* row, std::size_t size)
{
    switch (filter) {
    case 0: return std::copy_n(filtered, size, row), true;
    case 1: return addPrediction<kPixel>(filtered, above, row, size, [](int left, int, int) { return left; }), true;
    case 2: return std::transform(filtered, filtered + size, above, row, [](int f, int up) { return static_cast<unsigned char>(f + up); }), true;
    case 3: return addPrediction<kPixel>(filtered, above, row, size, [](int left, int up, int) { return (left + up) / 2; }), true;
    case 4: return addPrediction<kPixel>(filtered, above, row, size, paeth), true;
    default: return false;
    }
}

} // namespace

bool PngChunks::take(void* to, std::size_t size)
{
    auto* at = static_cast<unsigned char*>(to);
    while (size > 0) {
        if (m_left == 0 && !toNext()) return false;
        const std::size_t part = std::size_t(std::min<std::uint64_t>(size, m_left));
        const std::size_t header = std::min(part, m_headerLeft);
        std::memcpy(at, m_header + sizeof m_header - m_headerLeft, header);
        m_headerLeft -= header;
        if (m_file.read(at + header, part - header) != part - header) return false;
        at += part;
        size -= part;
        m_left -= part;
    }
    return true;
}

bool PngChunks::toNext()
{
    while (m_file.read(m_header, sizeof m_header) == sizeof m_header) {
        const std::uint64_t length = bigEndian(m_header);
        if (pngChunkHasPixels({reinterpret_cast<const char*>(m_header) + 4, 4})) {
            m_headerLeft = sizeof m_header;
            m_left = sizeof m_header + length + kChecksum;
            return true;
        }
        if (!m_file.skip(length + kChecksum)) return false;
    }
    return false;
}

std::size_t PngChunks::takeData(void* to, std::size_t size)
{
    while (m_left == kChecksum) { // of one after another without data too
        if (!checkSum() || !toNext()) return 0;
        if (std::memcmp(m_header + 4, "IDAT", 4) != 0) return m_left = 0;
        m_left -= std::exchange(m_headerLeft, 0);
        m_sum = crc32(0, m_header + 4, 4);
    }
    if (m_left < kChecksum) return 0;
    const std::size_t part = std::size_t(std::min<std::uint64_t>(size, m_left - kChecksum));
    const std::size_t got = m_file.read(to, part);
    if (got != part) m_fault = "the file ends early";
    m_sum = crc32(m_sum, static_cast<const Bytef*>(to), uInt(got));
    m_left -= part;
    return got == part ? part : 0;
}

bool PngChunks::checkSum()
{
    unsigned char sum[kChecksum] = {};
    m_left = 0;
    if (m_file.read(sum, sizeof sum) != sizeof sum)
        m_fault = "the file ends early";
    else if (bigEndian(sum) != m_sum)
        m_fault = "IDAT: CRC error";
    return m_fault.empty();
}

bool PngChunks::finishData()
{
    char rest[4096];
    while (m_left > kChecksum)
        if (takeData(rest, sizeof rest) == 0) return false;
    return m_left < kChecksum ? m_fault.empty() : checkSum();
}

PngInflater::PngInflater(PngChunks& chunks) : m_chunks{chunks}, m_packed(std::size_t(1) << 16, '\0')
{
    if (inflateInit(&m_stream) != Z_OK) m_fault = "there is not enough memory";
    inflateValidate(&m_stream, 0); // each chunk has its checksum: a second one of all would be a tenth of the time
}

bool PngInflater::read(void* to, std::size_t size)
{
    m_stream.next_out = static_cast<Bytef*>(to);
    m_stream.avail_out = uInt(size);
    while (m_fault.empty() && m_stream.avail_out > 0) {
        if (m_stream.avail_in == 0) {
            m_stream.next_in = reinterpret_cast<Bytef*>(m_packed.data());
            m_stream.avail_in = uInt(m_chunks.takeData(m_packed.data(), m_packed.size()));
            if (m_stream.avail_in == 0) m_fault = m_chunks.fault().empty() ? "IDAT: not enough image data" : m_chunks.fault();
        }
        const int answer = m_fault.empty() ? inflate(&m_stream, Z_NO_FLUSH) : Z_OK;
        if (answer == Z_STREAM_END && m_stream.avail_out > 0) m_fault = "IDAT: not enough image data";
        if (answer != Z_OK && answer != Z_STREAM_END && answer != Z_BUF_ERROR)
            m_fault = std::string{"IDAT: "} + (m_stream.msg ? m_stream.msg : "damaged image data");
    }
    return m_fault.empty();
}

bool unfilterPng(int filter, int pixel, const unsigned char* filtered, const unsigned char* above, unsigned char* row, std::size_t size)
{
    return pixel == 1 ? unfilter<1>(filter, filtered, above, row, size) : unfilter<2>(filter, filtered, above, row, size);
}

} // namespace io
