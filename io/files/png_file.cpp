#include "io/files/png_file.h"

#include "io/files/image_bytes.h"
#include "io/files/png_reader.h"

#include <cstring>
#include <new>
#include <vector>
#include <zlib.h>

namespace io {
namespace {

void take(png_structp png, png_bytep to, std::size_t size)
{
    std::string_view& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > rest.size()) PngReader::endsEarly(png);
    std::memcpy(to, rest.data(), size);
    rest.remove_prefix(size);
}

void put(png_structp png, png_bytep from, std::size_t size)
{
    bool kept = true; // nothing is thrown through libpng
    try {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(from), size);
    } catch (const std::bad_alloc&) {
        kept = false;
    }
    if (!kept) png_error(png, "there is not enough memory");
}

void flush(png_structp) {}

// As of PngReader: no destructors where libpng may jump out.
class Writer {
public:
    Writer()
        : m_png{png_create_write_struct(PNG_LIBPNG_VER_STRING, &m_fault, PngReader::failed, PngReader::warned)},
          m_info{m_png ? png_create_info_struct(m_png) : nullptr}
    {
        if (m_info) png_set_write_fn(m_png, &m_bytes, put, flush);
    }
    ~Writer() { png_destroy_write_struct(&m_png, &m_info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    bool begin(const ImageLayout& layout)
    {
        constexpr int kColours[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
        if (!m_info || setjmp(png_jmpbuf(m_png))) return false;
        png_set_IHDR(m_png, m_info, png_uint_32(layout.size.x), png_uint_32(layout.size.y), bytesOf(layout.type) * 8,
                     kColours[layout.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_compression_level(m_png, 6);
        png_set_compression_strategy(m_png, Z_DEFAULT_STRATEGY); // heights come out smaller than by libpng's own choice
        png_write_info(m_png, m_info);
        if constexpr (std::endian::native == std::endian::little)
            if (layout.type == PixelType::U16) png_set_swap(m_png);
        return true;
    }
    bool write(const std::byte* row)
    {
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_write_row(m_png, reinterpret_cast<png_const_bytep>(row));
        return true;
    }
    bool end()
    {
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_write_end(m_png, nullptr);
        return true;
    }
    std::string& bytes() { return m_bytes; }
    const std::string& fault() const { return m_fault; }

private:
    std::string m_bytes, m_fault;
    png_structp m_png;
    png_infop m_info;
};

std::vector<png_bytep> rowsOf(Image& image)
{
    std::vector<png_bytep> rows;
    for (int y = 0; y < image.size.y; ++y)
        rows.push_back(reinterpret_cast<png_bytep>(image.row<std::byte>(y)));
    return rows;
}

} // namespace

Result<Image> decodePng(std::string_view bytes, const std::string& where, const ImageLimits& limits)
{
    PngReader reader{&bytes, take};
    if (!reader.readHeader()) return Error{where, "not a readable png image: " + reader.fault()};
    const ImageLayout layout = reader.layout();
    Image image{.size = layout.size, .channels = layout.channels, .type = layout.type};
    const std::size_t sample = image.type == PixelType::U16 ? 2 : 1;
    if (Status size = checkSize({image.size, image.channels, sample}, limits, where); !size) return size.error();

    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    if (!reader.readAll(rowsOf(image).data())) return Error{where, "damaged: " + reader.fault()};
    return image;
}

Result<std::string> encodePngRows(const ImageLayout& layout, const RowSource& source)
{
    if (layout.type == PixelType::F32) return Error{"PNG", "holds 8 or 16 bits a channel, not float"};
    Writer writer;
    std::vector<std::byte> row(layout.rowBytes());
    bool written = writer.begin(layout);
    for (int y = 0; written && y < layout.size.y; ++y) {
        source(y, 1, row.data());
        written = writer.write(row.data());
    }
    if (!written || !writer.end()) return Error{"PNG", "cannot be written: " + writer.fault()};
    return std::move(writer.bytes());
}

Result<std::string> encodePng(const Image& image)
{
    return encodePngRows({image.size, image.channels, image.type}, [&](int first, int count, std::byte* rows) {
        std::memcpy(rows, image.row<std::byte>(first), image.rowBytes() * std::size_t(count));
    });
}

} // namespace io
