#include "io/files/image_file.h"

#include "io/files/atomic_file.h"
#include "io/files/image_bytes.h"
#include "io/files/image_rows.h"
#include "io/files/jpeg_file.h"
#include "io/files/picture_module.h"
#include "io/files/png_file.h"

#include <algorithm>
#include <cstring>

namespace io {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t(1280) << 20; // bytes; a ground of 16385 x 16385 floats, not packed

Result<Image> decode(std::string_view bytes, const std::string& where, const ImageLimits& limits)
{
    const std::string format{imageFormat(bytes)};
    if (format.empty()) return Error{where, "not an image that Wold reads (PNG, JPEG, TIFF, EXR, HDR, DDS)"};
    if (const std::string fault = headerFault(bytes); !fault.empty()) return Error{where, fault};
    if (const auto size = declaredSize(bytes))
        if (Status sides = checkSides(size->x, size->y, limits, where); !sides) return sides.error();
    if (format == "png") return decodePng(withoutMetadata(bytes), where, limits);
    if (format == "jpeg") return decodeJpeg(withoutMetadata(bytes), where);
    const Result<PictureModule> module = pictureModule();
    if (!module) return Error{where, module.error().what};
    return module->decode(format, bytes, where, limits);
}

Result<std::string> encode(const std::string& extension, const Image& image, int quality)
{
    if (extension == ".png") return encodePng(image);
    if (extension == ".jpg") return encodeJpeg(image, quality);
    return encodeFloatRows(extension, {image.size, image.channels, image.type}, [&](int first, int count, std::byte* rows) {
        std::memcpy(rows, image.row<std::byte>(first), image.rowBytes() * std::size_t(count));
    });
}

Error unfit(const std::filesystem::path& file, const char* what)
{
    return {file.string(), what};
}

} // namespace

Result<Image> decodeImage(std::string_view bytes, const std::string& where, const ImageLimits& limits)
{
    try {
        return decode(bytes, where, limits);
    } catch (const std::exception& error) {
        return Error{where, std::string{"cannot be decoded: "} + error.what()};
    }
}

Result<Image> readImage(const std::filesystem::path& file, const ImageLimits& limits)
{
    const Result<std::string> bytes = readFile(file, kLargestFile);
    if (!bytes) return bytes.error();
    return decodeImage(*bytes, file.string(), limits);
}

Status writeImage(const std::filesystem::path& file, const Image& image, int quality)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) { return char(std::tolower(c)); });
    if (extension == ".jpeg") extension = ".jpg";
    if (extension != ".jpg" && extension != ".exr" && extension != ".png")
        return unfit(file, "pictures are written as .png, .jpg or .exr");
    if (extension == ".exr" && image.type != PixelType::F32) return unfit(file, ".exr holds float pixels");
    if (extension != ".exr" && image.type == PixelType::F32) return unfit(file, "float pixels need .exr");
    if (extension == ".jpg" && image.type != PixelType::U8) return unfit(file, ".jpg holds 8 bits a channel");
    try {
        const Result<std::string> bytes = encode(extension, image, quality);
        if (!bytes) return Error{file.string(), bytes.error().what};
        return writeFile(file, *bytes);
    } catch (const std::exception& error) {
        return unfit(file, error.what());
    }
}

} // namespace io
