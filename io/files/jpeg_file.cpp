#include "io/files/jpeg_file.h"

#include "io/files/image_bytes.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio> // jpeglib.h uses FILE without it
#include <cstdlib>
#include <jpeglib.h>

#include <jerror.h>

namespace io {
namespace {

constexpr int kMostScans = 500; // of a progressive picture; what has more is made to keep decoders busy

struct Faults {
    jpeg_error_mgr manager; // first, so that libjpeg's pointer to it is one to all of this
    std::jmp_buf jump;
    std::array<char, JMSG_LENGTH_MAX> what;
    bool endsEarly = false;
};

Faults& faultsOf(j_common_ptr codec)
{
    return *reinterpret_cast<Faults*>(codec->err);
}

[[noreturn]] void failed(j_common_ptr codec)
{
    Faults& faults = faultsOf(codec);
    codec->err->format_message(codec, faults.what.data());
    std::longjmp(faults.jump, 1);
}

void warned(j_common_ptr codec, int level)
{
    if (level < 0 && codec->err->msg_code == JWRN_JPEG_EOF) faultsOf(codec).endsEarly = true;
}

void countScans(j_common_ptr codec)
{
    if (codec->is_decompressor && reinterpret_cast<j_decompress_ptr>(codec)->input_scan_number > kMostScans)
        ERREXIT(codec, JERR_BAD_PROGRESSION);
}

jpeg_error_mgr* prepare(Faults& faults)
{
    jpeg_error_mgr* manager = jpeg_std_error(&faults.manager);
    manager->error_exit = failed;
    manager->emit_message = warned;
    return manager;
}

// libjpeg jumps out of a function that fails: nothing in those of these two classes needs a destructor.
class Reader {
public:
    explicit Reader(std::string_view bytes) : m_bytes{bytes} { m_codec.err = prepare(m_faults); }
    ~Reader() { jpeg_destroy_decompress(&m_codec); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    bool readHeader()
    {
        if (setjmp(m_faults.jump)) return false;
        jpeg_create_decompress(&m_codec);
        m_codec.progress = &m_progress;
        m_progress.progress_monitor = countScans;
        jpeg_mem_src(&m_codec, reinterpret_cast<const unsigned char*>(m_bytes.data()), m_bytes.size());
        jpeg_read_header(&m_codec, TRUE);
        const bool inks = m_codec.jpeg_color_space == JCS_CMYK || m_codec.jpeg_color_space == JCS_YCCK;
        m_codec.out_color_space = m_codec.num_components == 1 ? JCS_GRAYSCALE : inks ? JCS_CMYK : JCS_RGB;
        jpeg_calc_output_dimensions(&m_codec);
        return true;
    }
    bool readRows(JSAMPLE* to, std::size_t rowBytes)
    {
        if (setjmp(m_faults.jump)) return false;
        jpeg_start_decompress(&m_codec);
        while (m_codec.output_scanline < m_codec.output_height) {
            JSAMPROW row = to + rowBytes * m_codec.output_scanline;
            jpeg_read_scanlines(&m_codec, &row, 1);
        }
        jpeg_finish_decompress(&m_codec);
        return true;
    }
    Image image() const // without its pixels
    {
        return {.size = {int(m_codec.output_width), int(m_codec.output_height)},
                .channels = m_codec.output_components,
                .type = PixelType::U8};
    }
    bool inverted() const { return m_codec.saw_Adobe_marker; } // whose inks count what is left white
    bool endsEarly() const { return m_faults.endsEarly; }
    std::string fault() const { return m_faults.what.data(); }

private:
    std::string_view m_bytes;
    Faults m_faults{};
    jpeg_progress_mgr m_progress{};
    jpeg_decompress_struct m_codec{};
};

class Writer {
public:
    Writer() { m_codec.err = prepare(m_faults); }
    ~Writer()
    {
        jpeg_destroy_compress(&m_codec);
        std::free(m_bytes);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    bool write(const std::byte* rows, glm::ivec2 size, int channels, int quality)
    {
        if (setjmp(m_faults.jump)) return false;
        jpeg_create_compress(&m_codec);
        jpeg_mem_dest(&m_codec, &m_bytes, &m_size);
        m_codec.image_width = JDIMENSION(size.x);
        m_codec.image_height = JDIMENSION(size.y);
        m_codec.input_components = channels;
        m_codec.in_color_space = channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
        jpeg_set_defaults(&m_codec);
        jpeg_set_quality(&m_codec, quality, TRUE);
        jpeg_start_compress(&m_codec, TRUE);
        while (m_codec.next_scanline < m_codec.image_height) {
            const std::byte* from = rows + std::size_t(m_codec.next_scanline) * size.x * channels;
            JSAMPROW row = reinterpret_cast<JSAMPROW>(const_cast<std::byte*>(from)); // libjpeg only reads it
            jpeg_write_scanlines(&m_codec, &row, 1);
        }
        jpeg_finish_compress(&m_codec);
        return true;
    }
    std::string bytes() const { return {reinterpret_cast<const char*>(m_bytes), m_size}; }
    std::string fault() const { return m_faults.what.data(); }

private:
    Faults m_faults{};
    unsigned char* m_bytes = nullptr;
    unsigned long m_size = 0;
    jpeg_compress_struct m_codec{};
};

// What is left of white light behind each ink and black.
Image coloursOf(const Image& inks, bool inverted)
{
    Image image{.size = inks.size, .channels = 3, .type = PixelType::U8};
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    const auto* from = reinterpret_cast<const std::uint8_t*>(inks.bytes.data());
    auto* to = reinterpret_cast<std::uint8_t*>(image.bytes.data());
    for (std::size_t i = 0; i < inks.bytes.size(); i += 4, from += 4, to += 3)
        for (int c = 0; c < 3; ++c)
            to[c] = std::uint8_t((inverted ? from[c] * from[3] : (255 - from[c]) * (255 - from[3])) / 255);
    return image;
}

std::vector<std::byte> firstChannels(const Image& image, int channels)
{
    std::vector<std::byte> kept(std::size_t(image.size.x) * image.size.y * channels);
    for (std::size_t i = 0; i < kept.size(); ++i)
        kept[i] = image.bytes[i / channels * image.channels + i % channels];
    return kept;
}

} // namespace

Result<Image> decodeJpeg(std::string_view bytes, const std::string& where)
{
    Reader reader{bytes};
    if (!reader.readHeader()) return Error{where, "not a readable jpeg image: " + reader.fault()};
    Image image = reader.image();
    if (Status size = checkSize({image.size, image.channels, 1}, {}, where); !size) return size.error();

    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    if (!reader.readRows(reinterpret_cast<JSAMPLE*>(image.bytes.data()), image.rowBytes()))
        return Error{where, "damaged: " + reader.fault()};
    if (reader.endsEarly()) return Error{where, "damaged: the file ends early"};
    return image.channels == 4 ? coloursOf(image, reader.inverted()) : image;
}

Result<std::string> encodeJpeg(const Image& image, int quality)
{
    const int channels = image.channels < 3 ? 1 : 3;
    const bool whole = channels == image.channels;
    const std::vector<std::byte> kept = whole ? std::vector<std::byte>{} : firstChannels(image, channels);
    Writer writer;
    if (!writer.write(whole ? image.bytes.data() : kept.data(), image.size, channels, std::clamp(quality, 1, 100)))
        return Error{"JPEG", "cannot be written: " + writer.fault()};
    return writer.bytes();
}

} // namespace io
