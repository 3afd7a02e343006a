// The module's one source; what it takes from the rest of Wold is compiled into it.
#include "io/files/image_bytes.h"
#include "io/files/picture_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace io {

void contractBroken(const char* condition, const char* file, int line) // the program's own is not seen from here
{
    std::fprintf(stderr, "wold: error: %s:%d: broken contract: %s (a bug in Wold; please report it)\n", file, line, condition);
    std::abort();
}

namespace {

Error refused(const std::string& where, std::string what)
{
    return {where, std::move(what)};
}

std::string reason(std::string message)
{
    while (!message.empty() && (message.back() == '\n' || message.back() == '.'))
        message.pop_back();
    return message.empty() ? "no reason given" : message;
}

// What a decoder is about to make is checked before it makes it.
Status checkHeader(const OIIO::ImageSpec& spec, const std::string& where)
{
    if (spec.get_int_attribute("tiff:RowsPerStrip", 1) < 1) // any format may carry it, and the library divides by it
        return refused(where, "its rows are damaged");
    if (spec.deep || spec.depth > 1) return refused(where, "deep or volume images are not supported; flatten it");
    return {};
}

DecodedSize decodedSize(const OIIO::ImageSpec& spec)
{
    return {{spec.width, spec.height}, spec.nchannels, spec.format.size()};
}

PixelType pixelType(const OIIO::TypeDesc& format)
{
    if (format == OIIO::TypeDesc::UINT8) return PixelType::U8;
    if (format == OIIO::TypeDesc::UINT16) return PixelType::U16;
    return PixelType::F32;
}

OIIO::TypeDesc typeOf(PixelType type)
{
    return type == PixelType::U8    ? OIIO::TypeDesc::UINT8
           : type == PixelType::U16 ? OIIO::TypeDesc::UINT16
                                    : OIIO::TypeDesc::FLOAT;
}

// Integers that become float keep their values: `read` is given their own type and room for them.
template <class Native, class Read> bool readUnscaled(std::size_t count, OIIO::TypeDesc type, void* pixels, const Read& read)
{
    std::vector<Native> values(count);
    if (!read(type, values.data())) return false;
    std::copy(values.begin(), values.end(), static_cast<float*>(pixels));
    return true;
}

// `count` samples of a picture of that format by read(type, where to).
template <class Read> bool readSamples(OIIO::TypeDesc format, std::size_t count, void* pixels, const Read& read)
{
    if (format == OIIO::TypeDesc::INT16) return readUnscaled<std::int16_t>(count, format, pixels, read);
    if (format == OIIO::TypeDesc::INT32) return readUnscaled<std::int32_t>(count, format, pixels, read);
    if (format == OIIO::TypeDesc::UINT32) return readUnscaled<std::uint32_t>(count, format, pixels, read);
    return read(typeOf(pixelType(format)), pixels);
}

bool readPixels(OIIO::ImageInput& input, Image& image, OIIO::TypeDesc format)
{
    const std::size_t count = std::size_t(image.size.x) * std::size_t(image.size.y) * std::size_t(image.channels);
    return readSamples(format, count, image.bytes.data(),
                       [&](OIIO::TypeDesc type, void* to) { return input.read_image(0, 0, 0, image.channels, type, to); });
}

// The library's own limits lie a little above ours, as a second net.
void limitLibrary()
{
    static const bool once = OIIO::attribute("threads", 1) && OIIO::attribute("limits:imagesize_MB", 1280);
    (void)once;
}

// Of `memory`, which is to live as long; the error without its place.
Result<std::unique_ptr<OIIO::ImageInput>> openInput(const std::string& format, OIIO::Filesystem::IOProxy& memory, OIIO::ImageSpec& spec)
{
    limitLibrary();
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    config.attribute("oiio:RawColor", 1);
    auto input = OIIO::ImageInput::create(format);
    input->set_ioproxy(&memory);
    if (!input->open("image." + format, spec, config)) return refused({}, "not a readable " + format + " image: " + reason(input->geterror()));
    return input;
}

Result<Image> decodePixels(const std::string& format, std::string_view bytes, const std::string& where, const ImageLimits& limits)
{
    OIIO::Filesystem::IOMemReader memory{bytes.data(), bytes.size()};
    OIIO::ImageSpec spec;
    const auto input = openInput(format, memory, spec);
    if (!input) return refused(where, input.error().what);
    if (Status sound = checkHeader(spec, where); !sound) return sound.error();
    if (Status size = checkSize(decodedSize(spec), limits, where); !size) return size.error();

    Image image;
    image.size = {spec.width, spec.height};
    image.channels = std::min(spec.nchannels, 4);
    image.type = pixelType(spec.format);
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    if (!readPixels(**input, image, spec.format)) return refused(where, "damaged: " + reason((*input)->geterror()));
    return image;
}

Result<Image> decode(const std::string& format, std::string_view bytes, const std::string& where, const ImageLimits& limits)
{
    try {
        return decodePixels(format, bytes, where, limits);
    } catch (const std::exception& error) {
        return refused(where, std::string{"cannot be decoded: "} + error.what());
    }
}

class OiioRows final : public ImageRows {
public:
    OiioRows(const std::string& file) : m_where{file}, m_file{file, OIIO::Filesystem::IOProxy::Read} {}

    Status open(const std::string& format, std::uint64_t bytes, int largestSide)
    {
        if (!m_file.opened()) return refused(m_where, "cannot be opened");
        auto input = openInput(format, m_file, m_spec);
        if (!input) return refused(m_where, input.error().what);
        m_input = std::move(*input);
        if (Status sound = checkHeader(m_spec, m_where); !sound) return sound;
        if (Status fits = checkRows(decodedSize(m_spec), {.side = largestSide}, m_where); !fits) return fits;
        m_layout = {{m_spec.width, m_spec.height}, std::min(m_spec.nchannels, 4), pixelType(m_spec.format)};
        if (m_spec.tile_width == 0) {
            const int strip = m_spec.get_int_attribute("tiff:RowsPerStrip", kScanlines);
            m_step = std::uint64_t(strip) * m_layout.rowBytes() <= kLargestStrip ? std::min(strip, m_spec.height) : 1;
            return {};
        }
        m_step = m_spec.tile_height;
        const std::uint64_t needed = std::uint64_t(m_step) * std::uint64_t(m_spec.width) * std::uint64_t(m_spec.nchannels) * m_spec.format.size();
        if (needed > ImageLimits{}.bytes) return refused(m_where, "a row of its tiles takes more than 512 MiB; make them smaller");
        if (needed > kLargestStrip && needed / kMostPacked > bytes) return refused(m_where, "too small for the tiles that it says it holds");
        return {};
    }
    Status next(int count, std::byte* rows) override
    {
        const int first = m_spec.y + m_row, last = first + count;
        const auto read = [&](OIIO::TypeDesc type, void* to) {
            if (m_spec.tile_width == 0) return m_input->read_scanlines(0, 0, first, last, m_spec.z, 0, m_layout.channels, type, to);
            return m_input->read_tiles(0, 0, m_spec.x, m_spec.x + m_spec.width, first, last, m_spec.z, m_spec.z + 1, 0, m_layout.channels, type, to);
        };
        m_row += count;
        try {
            const std::size_t samples = std::size_t(m_layout.size.x) * std::size_t(count) * std::size_t(m_layout.channels);
            if (!readSamples(m_spec.format, samples, rows, read)) return refused(m_where, "damaged: " + reason(m_input->geterror()));
        } catch (const std::exception& error) {
            return refused(m_where, std::string{"cannot be decoded: "} + error.what());
        }
        return {};
    }

private:
    static constexpr int kScanlines = 64;                           // where the format says nothing; of EXR's blocks a multiple
    static constexpr std::uint64_t kLargestStrip = 64 << 20;        // bytes
    static constexpr std::uint64_t kMostPacked = 4096;              // times; no coder of these formats comes near

    std::string m_where;
    OIIO::Filesystem::IOFile m_file;
    OIIO::ImageSpec m_spec;
    std::unique_ptr<OIIO::ImageInput> m_input;
    int m_row = 0;
};

Result<std::unique_ptr<ImageRows>> openRows(const std::string& format, const std::string& file, std::uint64_t bytes, int largestSide)
{
    try {
        auto rows = std::make_unique<OiioRows>(file);
        if (Status opened = rows->open(format, bytes, largestSide); !opened) return opened.error();
        return std::unique_ptr<ImageRows>{std::move(rows)};
    } catch (const std::exception& error) {
        return refused(file, std::string{"cannot be decoded: "} + error.what());
    }
}

class StringOutput final : public OIIO::Filesystem::IOProxy { // the library's own gives no bytes away without copying them
public:
    StringOutput() : IOProxy{"", Write} {}
    const char* proxytype() const override { return "string"; }
    std::size_t write(const void* from, std::size_t size) override
    {
        const std::size_t written = pwrite(from, size, m_pos);
        m_pos += std::int64_t(written);
        return written;
    }
    std::size_t pwrite(const void* from, std::size_t size, std::int64_t at) override
    {
        if (m_bytes.size() < std::size_t(at) + size) m_bytes.resize(std::size_t(at) + size);
        std::copy_n(static_cast<const char*>(from), size, m_bytes.begin() + at);
        return size;
    }
    std::size_t size() const override { return m_bytes.size(); }
    std::string& bytes() { return m_bytes; }

private:
    std::string m_bytes;
};

Result<std::string> encodeRows(const std::string& format, const ImageLayout& layout, const RowSource& source)
{
    constexpr int kBand = 64; // a multiple of what both formats pack together
    OIIO::ImageSpec spec{layout.size.x, layout.size.y, layout.channels, typeOf(layout.type)};
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("compression", "zip");
    const std::string name = "image." + format;
    StringOutput memory;
    const auto output = OIIO::ImageOutput::create(name);
    if (!output) return Error{name, "no writer for this format"};
    output->set_ioproxy(&memory);
    const auto failed = [&] { return Error{name, "cannot be written: " + reason(output->geterror())}; };
    if (!output->open(name, spec)) return failed();
    std::vector<std::byte> rows(layout.rowBytes() * std::size_t(std::min(kBand, layout.size.y)));
    for (int y = 0; y < layout.size.y; y += kBand) {
        const int count = std::min(kBand, layout.size.y - y);
        source(y, count, rows.data());
        if (!output->write_scanlines(y, y + count, 0, typeOf(layout.type), rows.data())) return failed();
    }
    if (!output->close()) return failed();
    return std::move(memory.bytes());
}

Result<std::string> encode(const std::string& format, const ImageLayout& layout, const RowSource& source)
{
    try {
        return encodeRows(format, layout, source);
    } catch (const std::exception& error) {
        return Error{format, std::string{"cannot be encoded: "} + error.what()};
    }
}

} // namespace
} // namespace io

extern "C" io::PictureModule woldPictures()
{
    return {.decode = io::decode, .openRows = io::openRows, .encode = io::encode};
}
