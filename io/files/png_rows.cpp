#include "io/files/png_rows.h"

#include "io/files/image_bytes.h"
#include "io/files/png_chunks.h"
#include "io/files/png_reader.h"

#include <cstring>
#include <vector>

namespace io {
namespace {

Status checkLayout(const ImageLayout& layout, const std::string& where, int largestSide)
{
    const std::size_t sample = layout.type == PixelType::U16 ? 2 : 1;
    return checkRows({layout.size, layout.channels, sample}, {.side = largestSide}, where);
}

class PngRows final : public ImageRows { // any, by libpng
public:
    PngRows(std::unique_ptr<PngChunks> chunks, std::unique_ptr<PngReader> reader, std::string where)
        : m_chunks{std::move(chunks)}, m_reader{std::move(reader)}, m_where{std::move(where)}
    {
        m_layout = m_reader->layout();
    }
    Status next(int count, std::byte* packed) override
    {
        if (!m_reader->readNext(count, reinterpret_cast<png_bytep>(packed), m_layout.rowBytes())) return Error{m_where, "damaged: " + m_reader->fault()};
        return {};
    }

private:
    std::unique_ptr<PngChunks> m_chunks; // which the reader takes from
    std::unique_ptr<PngReader> m_reader;
    std::string m_where;
};

// Grey without a palette or a transparent colour, as heights are: libpng has read its header. Unpacking takes as long as
// undoing the filters, which libpng does on one thread after the other.
class GreyPngRows final : public ImageRows {
public:
    GreyPngRows(std::unique_ptr<PngChunks> chunks, const ImageLayout& layout, std::string where)
        : m_chunks{std::move(chunks)}, m_inflater{*m_chunks}, m_where{std::move(where)}, m_above(layout.rowBytes()), m_row(layout.rowBytes()),
          m_pixels(std::size_t(layout.size.x))
    {
        m_layout = layout;
        m_packedRowBytes = layout.rowBytes() + 1;
    }
    Status next(int count, std::byte* packed) override
    {
        if (!m_inflater.read(packed, m_packedRowBytes * std::size_t(count))) return Error{m_where, "damaged: " + m_inflater.fault()};
        m_rows += count;
        if (m_rows == m_layout.size.y && !m_chunks->finishData()) return Error{m_where, "damaged: " + m_chunks->fault()};
        return {};
    }
    Result<const std::byte*> pixels(const std::byte* packed) override
    {
        std::swap(m_above, m_row);
        const auto* filtered = reinterpret_cast<const unsigned char*>(packed);
        const int pixel = bytesOf(m_layout.type);
        if (!unfilterPng(filtered[0], pixel, filtered + 1, m_above.data(), m_row.data(), m_row.size()))
            return Error{m_where, "damaged: bad adaptive filter value"};
        if (pixel == 1 || std::endian::native == std::endian::big) return reinterpret_cast<const std::byte*>(m_row.data());
        std::memcpy(m_pixels.data(), m_row.data(), m_row.size());
        for (std::uint16_t& value : m_pixels)
            value = std::uint16_t(value << 8 | value >> 8);
        return reinterpret_cast<const std::byte*>(m_pixels.data());
    }

private:
    std::unique_ptr<PngChunks> m_chunks;
    PngInflater m_inflater;
    std::string m_where;
    std::vector<unsigned char> m_above, m_row; // in the file's order of bytes, which the filters work on
    std::vector<std::uint16_t> m_pixels;
    int m_rows = 0;
};

void take(png_structp png, png_bytep to, std::size_t size)
{
    if (!static_cast<PngChunks*>(png_get_io_ptr(png))->take(to, size)) PngReader::endsEarly(png);
}

} // namespace

Result<std::unique_ptr<ImageRows>> openPngRows(FileReader file, const std::string& where, int largestSide)
{
    auto chunks = std::make_unique<PngChunks>(std::move(file));
    auto reader = std::make_unique<PngReader>(chunks.get(), take);
    if (!reader->readHeader()) return Error{where, "not a readable png image: " + reader->fault()};
    const ImageLayout layout = reader->layout();
    if (Status fits = checkLayout(layout, where, largestSide); !fits) return fits.error();
    if (reader->interlaced()) return std::unique_ptr<ImageRows>{};
    if (reader->plainGrey()) return std::unique_ptr<ImageRows>{std::make_unique<GreyPngRows>(std::move(chunks), layout, where)};
    return std::unique_ptr<ImageRows>{std::make_unique<PngRows>(std::move(chunks), std::move(reader), where)};
}

} // namespace io
