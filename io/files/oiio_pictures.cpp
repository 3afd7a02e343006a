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
Status checkHeader(const OIIO::ImageSpec& spec, const ImageLimits& limits, const std::string& where)
{
    if (spec.get_int_attribute("tiff:RowsPerStrip", 1) < 1) // any format may carry it, and the library divides by it
        return refused(where, "its rows are damaged");
    if (spec.deep || spec.depth > 1) return refused(where, "deep or volume images are not supported; flatten it");
    return checkSize({{spec.width, spec.height}, spec.nchannels, spec.format.size()}, limits, where);
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

template <class Native> bool readUnscaled(OIIO::ImageInput& input, Image& image, OIIO::TypeDesc type)
{
    std::vector<Native> values(std::size_t(image.size.x) * image.size.y * image.channels);
    if (!input.read_image(0, 0, 0, image.channels, type, values.data())) return false;
    std::copy(values.begin(), values.end(), image.row<float>(0));
    return true;
}

bool readPixels(OIIO::ImageInput& input, Image& image, OIIO::TypeDesc format)
{
    if (format == OIIO::TypeDesc::INT16) return readUnscaled<std::int16_t>(input, image, format);
    if (format == OIIO::TypeDesc::INT32) return readUnscaled<std::int32_t>(input, image, format);
    if (format == OIIO::TypeDesc::UINT32) return readUnscaled<std::uint32_t>(input, image, format);
    return input.read_image(0, 0, 0, image.channels, typeOf(image.type), image.bytes.data());
}

// The library's own limits lie a little above ours, as a second net.
void limitLibrary()
{
    static const bool once = OIIO::attribute("threads", 1) && OIIO::attribute("limits:imagesize_MB", 1280);
    (void)once;
}

Result<Image> decodePixels(const std::string& format, std::string_view bytes, const std::string& where, const ImageLimits& limits)
{
    limitLibrary();
    OIIO::Filesystem::IOMemReader memory{bytes.data(), bytes.size()};
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    config.attribute("oiio:RawColor", 1);

    const auto input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    input->set_ioproxy(&memory);
    if (!input->open("image." + format, spec, config))
        return refused(where, "not a readable " + format + " image: " + reason(input->geterror()));
    if (Status sound = checkHeader(spec, limits, where); !sound) return sound.error();

    Image image;
    image.size = {spec.width, spec.height};
    image.channels = std::min(spec.nchannels, 4);
    image.type = pixelType(spec.format);
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    if (!readPixels(*input, image, spec.format)) return refused(where, "damaged: " + reason(input->geterror()));
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

Result<std::string> encodePixels(const std::string& format, const Image& image)
{
    OIIO::ImageSpec spec{image.size.x, image.size.y, image.channels, typeOf(image.type)};
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("compression", "zip");
    const std::string name = "image." + format;
    OIIO::Filesystem::IOVecOutput memory;
    const auto output = OIIO::ImageOutput::create(name);
    if (!output) return Error{name, "no writer for this format"};
    output->set_ioproxy(&memory);
    if (!output->open(name, spec) || !output->write_image(typeOf(image.type), image.bytes.data()) || !output->close())
        return Error{name, "cannot be written: " + reason(output->geterror())};
    const auto& bytes = memory.buffer();
    return std::string{bytes.begin(), bytes.end()};
}

Result<std::string> encode(const std::string& format, const Image& image)
{
    try {
        return encodePixels(format, image);
    } catch (const std::exception& error) {
        return Error{format, std::string{"cannot be encoded: "} + error.what()};
    }
}

} // namespace
} // namespace io

extern "C" io::PictureModule woldPictures()
{
    return {.decode = io::decode, .encode = io::encode};
}
