// libpng's decoder as a class, for those who include <png.h>.
#pragma once

#include "io/files/image_rows.h"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <string>

namespace io {

// libpng jumps out of a function that fails: nothing in those of this class needs a destructor.
class PngReader {
public:
    // take(png, to, size) calls endsEarly() where the bytes end.
    PngReader(void* source, png_rw_ptr take)
        : m_png{png_create_read_struct(PNG_LIBPNG_VER_STRING, &m_fault, failed, warned)},
          m_info{m_png ? png_create_info_struct(m_png) : nullptr}
    {
        if (m_info) png_set_read_fn(m_png, source, take);
    }
    ~PngReader() { png_destroy_read_struct(&m_png, &m_info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    bool readHeader()
    {
        if (!m_info || setjmp(png_jmpbuf(m_png))) return false;
        png_read_info(m_png, m_info);
        m_plainGrey = png_get_color_type(m_png, m_info) == PNG_COLOR_TYPE_GRAY && png_get_bit_depth(m_png, m_info) >= 8 &&
                      !png_get_valid(m_png, m_info, PNG_INFO_tRNS);
        png_set_expand(m_png);
        if constexpr (std::endian::native == std::endian::little) png_set_swap(m_png);
        png_set_interlace_handling(m_png);
        png_read_update_info(m_png, m_info);
        return true;
    }
    bool readAll(png_bytepp rows)
    {
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_read_image(m_png, rows);
        return true;
    }
    bool readNext(int count, png_bytep rows, std::size_t rowBytes) // of one that is not interlaced
    {
        if (setjmp(png_jmpbuf(m_png))) return false;
        for (int i = 0; i < count; ++i)
            png_read_row(m_png, rows + std::size_t(i) * rowBytes, nullptr);
        return true;
    }
    ImageLayout layout() const
    {
        return {.size = {int(png_get_image_width(m_png, m_info)), int(png_get_image_height(m_png, m_info))},
                .channels = png_get_channels(m_png, m_info),
                .type = png_get_bit_depth(m_png, m_info) == 16 ? PixelType::U16 : PixelType::U8};
    }
    bool plainGrey() const { return m_plainGrey; } // of 8 or 16 bits in the file
    bool interlaced() const { return png_get_interlace_type(m_png, m_info) != PNG_INTERLACE_NONE; }
    const std::string& fault() const { return m_fault; }

    [[noreturn]] static void endsEarly(png_structp png) { png_error(png, "the file ends early"); }
    [[noreturn]] static void failed(png_structp png, png_const_charp what)
    {
        *static_cast<std::string*>(png_get_error_ptr(png)) = what;
        png_longjmp(png, 1);
    }
    static void warned(png_structp, png_const_charp) {}

private:
    std::string m_fault;
    png_structp m_png;
    png_infop m_info;
    bool m_plainGrey = false;
};

} // namespace io
