#include "io/files/png_file.h"

#include "io/files/image_bytes.h"

#include <bit>
#include <csetjmp>
#include <cstring>
#include <png.h>
#include <vector>

namespace io {
namespace {

struct Source {
    std::string_view rest;
    std::string fault;
};

[[noreturn]] void failed(png_structp png, png_const_charp what)
{
    static_cast<Source*>(png_get_error_ptr(png))->fault = what;
    png_longjmp(png, 1);
}

void warned(png_structp, png_const_charp) {}

void take(png_structp png, png_bytep to, std::size_t size)
{
    std::string_view& rest = static_cast<Source*>(png_get_io_ptr(png))->rest;
    if (size > rest.size()) png_error(png, "the file ends early");
    std::memcpy(to, rest.data(), size);
    rest.remove_prefix(size);
}

// libpng jumps out of a function that fails: nothing in these two needs a destructor.
class Reader {
public:
    explicit Reader(Source& source)
        : m_png{png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, failed, warned)},
          m_info{m_png ? png_create_info_struct(m_png) : nullptr}
    {
        if (m_info) png_set_read_fn(m_png, &source, take);
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

private:
    png_structp m_png;
    png_infop m_info;
};

} // namespace

Result<Image> decodePng(std::string_view bytes, const std::string& where)
{
    Source source{.rest = bytes};
    Reader reader{source};
    if (!reader.readHeader()) return Error{where, "not a readable png image: " + source.fault};
    Image image = reader.image();
    const std::size_t sample = image.type == PixelType::U16 ? 2 : 1;
    if (Status size = checkSize({image.size, image.channels, sample}, where); !size) return size.error();

    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    std::vector<png_bytep> rows;
    for (int y = 0; y < image.size.y; ++y)
        rows.push_back(reinterpret_cast<png_bytep>(image.bytes.data() + image.rowBytes() * std::size_t(y)));
    if (!reader.readRows(rows.data())) return Error{where, "damaged: " + source.fault};
    return image;
}

} // namespace io
