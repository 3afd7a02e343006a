#include "io/files/image_file.h"

#include "io/files/atomic_file.h"
#include "io/files/image_bytes.h"
#include "io/files/png_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace io {
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
    return checkSize({{spec.width, spec.height}, spec.nchannels, spec.format.size()}, where);
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
    static const bool once = OIIO::attribute("threads", 1) && OIIO::attribute("limits:imagesize_MB", 1024);
    (void)once;
}

Result<Image> decode(std::string_view bytes, const std::string& where)
{
    limitLibrary();
    const std::string format{imageFormat(bytes)};
    if (format.empty()) return refused(where, "not an image that Wold reads (PNG, JPEG, TIFF, EXR, HDR, DDS)");
    if (const std::string fault = headerFault(bytes); !fault.empty()) return refused(where, fault);
    if (const auto size = declaredSize(bytes))
        if (Status sides = checkSides(size->x, size->y, where); !sides) return sides.error();
    const std::string clean = withoutMetadata(bytes);
    if (format == "png") return decodePng(clean, where);
    OIIO::Filesystem::IOMemReader memory{clean.data(), clean.size()};
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    config.attribute("oiio:RawColor", 1);

    const auto input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    input->set_ioproxy(&memory);
    if (!input->open("image." + format, spec, config))
        return refused(where, "not a readable " + format + " image: " + reason(input->geterror()));
    if (Status sound = checkHeader(spec, where); !sound) return sound.error();

    Image image;
    image.size = {spec.width, spec.height};
    image.channels = std::min(spec.nchannels, 4);
    image.type = pixelType(spec.format);
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    if (!readPixels(*input, image, spec.format)) return refused(where, "damaged: " + reason(input->geterror()));
    return image;
}

OIIO::ImageSpec specOf(const Image& image)
{
    OIIO::ImageSpec spec{image.size.x, image.size.y, image.channels, typeOf(image.type)};
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

Result<std::string> encode(const std::string& format, const Image& image, const OIIO::ImageSpec& spec)
{
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

Error unfit(const std::filesystem::path& file, const char* what)
{
    return {file.string(), what};
}

} // namespace

Result<Image> decodeImage(std::string_view bytes, const std::string& where)
{
    try {
        return decode(bytes, where);
    } catch (const std::exception& error) {
        return refused(where, std::string{"cannot be decoded: "} + error.what());
    }
}

Result<Image> readImage(const std::filesystem::path& file)
{
    const Result<std::string> bytes = readFile(file);
    if (!bytes) return bytes.error();
    return decodeImage(*bytes, file.string());
}

Result<std::string> encodePng(const Image& image)
{
    if (image.type == PixelType::F32) return Error{"PNG", "holds 8 or 16 bits a channel, not float"};
    try {
        return encode("png", image, specOf(image));
    } catch (const std::exception& error) {
        return Error{"PNG", std::string{"cannot be encoded: "} + error.what()};
    }
}

Status writeImage(const std::filesystem::path& file, const Image& image, int quality)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) { return char(std::tolower(c)); });
    OIIO::ImageSpec spec = specOf(image);
    if (extension == ".jpeg") extension = ".jpg";
    if (extension == ".jpg")
        spec.attribute("Compression", "jpeg:" + std::to_string(std::clamp(quality, 1, 100)));
    else if (extension == ".exr")
        spec.attribute("compression", "zip");
    else if (extension != ".png")
        return unfit(file, "pictures are written as .png, .jpg or .exr");
    if (extension == ".exr" && image.type != PixelType::F32) return unfit(file, ".exr holds float pixels");
    if (extension != ".exr" && image.type == PixelType::F32) return unfit(file, "float pixels need .exr");
    if (extension == ".jpg" && image.type != PixelType::U8) return unfit(file, ".jpg holds 8 bits a channel");
    try {
        const Result<std::string> bytes = encode(extension.substr(1), image, spec);
        if (!bytes) return Error{file.string(), bytes.error().what};
        return writeFile(file, *bytes);
    } catch (const std::exception& error) {
        return unfit(file, error.what());
    }
}

} // namespace io
