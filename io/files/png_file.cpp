#include "io/files/png_file.h"

#include "io/files/image_bytes.h"

#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>
#include <png.h>
#include <zlib.h>
#include <vector>

namespace io {
namespace {

[[noreturn]] void failed(png_structp png, png_const_charp what)
{
    *static_cast<std::string*>(png_get_error_ptr(png)) = what;
    png_longjmp(png, 1);
}

void warned(png_structp, png_const_charp) {}

void take(png_structp png, png_bytep to, std::size_t size)
{
    std::string_view& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > rest.size()) png_error(png, "the file ends early");
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

// libpng jumps out of a function that fails: nothing in those of these two classes needs a destructor.
class Reader {
public:
    explicit Reader(std::string_view bytes)
        : m_rest{bytes}, m_png{png_create_read_struct(PNG_LIBPNG_VER_STRING, &m_fault, failed, warned)},
          m_info{m_png ? png_create_info_struct(m_png) : nullptr}
    {
        if (m_info) png_set_read_fn(m_png, &m_rest, take);
    }
    ~Reader() { png_destroy_read_struct(&m_png, &m_info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    bool readHeader()
    {
        if (!m_info || setjmp(png_jmpbuf(m_png))) return false;
        png_read_info(m_png, m_info);
        png_set_expand(m_png);
        if constexpr (std::endian::native == std::endian::little) png_set_swap(m_png);
        png_set_interlace_handling(m_png);
        png_read_update_info(m_png, m_info);
        return true;
    }
    bool readRows(png_bytepp rows)
    {
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_read_image(m_png, rows);
        return true;
    }
    Image image() const // without its pixels
    {
        return {.size = {int(png_get_image_width(m_png, m_info)), int(png_get_image_height(m_png, m_info))},
                .channels = png_get_channels(m_png, m_info),
                .type = png_get_bit_depth(m_png, m_info) == 16 ? PixelType::U16 : PixelType::U8};
    }
    const std::string& fault() const { return m_fault; }

private:
    std::string_view m_rest;
    std::string m_fault;
    png_structp m_png;
    png_infop m_info;
};

class Writer {
public:
    Writer()
        : m_png{png_create_write_struct(PNG_LIBPNG_VER_STRING, &m_fault, failed, warned)},
          m_info{m_png ? png_create_info_struct(m_png) : nullptr}
    {
        if (m_info) png_set_write_fn(m_png, &m_bytes, put, flush);
    }
    ~Writer() { png_destroy_write_struct(&m_png, &m_info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    bool write(const Image& image, png_bytepp rows)
    {
        constexpr int kColours[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
        if (!m_info || setjmp(png_jmpbuf(m_png))) return false;
        png_set_IHDR(m_png, m_info, png_uint_32(image.size.x), png_uint_32(image.size.y), bytesOf(image.type) * 8,
                     kColours[image.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_compression_level(m_png, 6);
        png_set_compression_strategy(m_png, Z_DEFAULT_STRATEGY); // heights come out smaller than by libpng's own choice
        png_write_info(m_png, m_info);
        if constexpr (std::endian::native == std::endian::little)
            if (image.type == PixelType::U16) png_set_swap(m_png);
        png_write_image(m_png, rows);
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

std::vector<png_bytep> rowsOf(const Image& image)
{
    auto* const bytes = reinterpret_cast<png_bytep>(const_cast<std::byte*>(image.bytes.data())); // libpng tells no difference
    std::vector<png_bytep> rows;
    for (int y = 0; y < image.size.y; ++y)
        rows.push_back(bytes + image.rowBytes() * std::size_t(y));
    return rows;
}

} // namespace

Result<Image> decodePng(std::string_view bytes, const std::string& where, const ImageLimits& limits)
{
    Reader reader{bytes};
    if (!reader.readHeader()) return Error{where, "not a readable png image: " + reader.fault()};
    Image image = reader.image();
    const std::size_t sample = image.type == PixelType::U16 ? 2 : 1;
    if (Status size = checkSize({image.size, image.channels, sample}, limits, where); !size) return size.error();

    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    if (!reader.readRows(rowsOf(image).data())) return Error{where, "damaged: " + reader.fault()};
    return image;
}

Result<std::string> encodePng(const Image& image)
{
    if (image.type == PixelType::F32) return Error{"PNG", "holds 8 or 16 bits a channel, not float"};
    Writer writer;
    if (!writer.write(image, rowsOf(image).data())) return Error{"PNG", "cannot be written: " + writer.fault()};
    return std::move(writer.bytes());
}

} // namespace io
