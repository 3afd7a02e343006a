#include "io/files/png_rows.h"

#include "io/base/contract.h"
#include "io/files/image_bytes.h"
#include "io/files/png_reader.h"

#include <algorithm>
#include <cstring>

namespace io {
namespace {

// The chunks of a file that pixels depend on, one after another: as withoutMetadata() leaves a PNG.
class PixelChunks {
public:
    explicit PixelChunks(FileReader file) : m_file{std::move(file)} {}
    bool take(unsigned char* to, std::size_t size)
    {
        while (size > 0) {
            if (m_left == 0 && !toNext()) return false;
            const std::size_t part = std::size_t(std::min<std::uint64_t>(size, m_left));
            const std::size_t header = std::min(part, m_headerLeft);
            std::memcpy(to, m_header + sizeof m_header - m_headerLeft, header);
            m_headerLeft -= header;
            if (m_file.read(to + header, part - header) != part - header) return false;
            to += part;
            size -= part;
            m_left -= part;
        }
        return true;
    }

private:
    bool toNext()
    {
        constexpr std::uint64_t kChecksum = 4;
        while (m_file.read(m_header, sizeof m_header) == sizeof m_header) {
            const std::uint64_t length = std::uint64_t(m_header[0]) << 24 | m_header[1] << 16 | m_header[2] << 8 | m_header[3];
            if (pngChunkHasPixels({reinterpret_cast<const char*>(m_header) + 4, 4})) {
                m_headerLeft = sizeof m_header;
                m_left = sizeof m_header + length + kChecksum;
                return true;
            }
            if (!m_file.skip(length + kChecksum)) return false;
        }
        return false;
    }

    FileReader m_file;
    unsigned char m_header[8] = {};
    std::size_t m_headerLeft = 0;
    std::uint64_t m_left = 8; // of the chunk, or of the signature before the first
};

class PngRows final : public ImageRows {
public:
    PngRows(FileReader file, std::string where) : m_chunks{std::move(file)}, m_where{std::move(where)}, m_reader{&m_chunks, take} {}

    Result<bool> open(int largestSide) // false: interlaced
    {
        if (!m_reader.readHeader()) return Error{m_where, "not a readable png image: " + m_reader.fault()};
        m_layout = m_reader.layout();
        const std::size_t sample = m_layout.type == PixelType::U16 ? 2 : 1;
        if (Status fits = checkRows({m_layout.size, m_layout.channels, sample}, m_where, largestSide); !fits) return fits.error();
        return !m_reader.interlaced();
    }
    Status next(int count, std::byte* rows) override
    {
        m_row += count;
        EXPECTS(m_row <= m_layout.size.y);
        if (!m_reader.readNext(count, reinterpret_cast<png_bytep>(rows), m_layout.rowBytes())) return Error{m_where, "damaged: " + m_reader.fault()};
        return {};
    }

private:
    static void take(png_structp png, png_bytep to, std::size_t size)
    {
        if (!static_cast<PixelChunks*>(png_get_io_ptr(png))->take(to, size)) PngReader::endsEarly(png);
    }

    PixelChunks m_chunks;
    std::string m_where;
    PngReader m_reader;
    int m_row = 0;
};

} // namespace

Result<std::unique_ptr<ImageRows>> openPngRows(FileReader file, const std::string& where, int largestSide)
{
    auto rows = std::make_unique<PngRows>(std::move(file), where);
    const Result<bool> opened = rows->open(largestSide);
    if (!opened) return opened.error();
    return *opened ? std::unique_ptr<ImageRows>{std::move(rows)} : nullptr;
}

} // namespace io
