#include "io/files/image_rows.h"

#include "io/base/contract.h"
#include "io/files/file_reader.h"
#include "io/files/image_bytes.h"
#include "io/files/image_file.h"
#include "io/files/picture_module.h"
#include "io/files/png_rows.h"

#include <cstring>

namespace io {
namespace {

class RowsOfImage final : public ImageRows { // of one that could only be decoded whole
public:
    explicit RowsOfImage(Image image) : m_image{std::move(image)} { m_layout = {m_image.size, m_image.channels, m_image.type}; }
    Status next(int count, std::byte* rows) override
    {
        EXPECTS(m_row + count <= m_image.size.y);
        std::memcpy(rows, m_image.row<std::byte>(m_row), m_image.rowBytes() * std::size_t(count));
        m_row += count;
        return {};
    }

private:
    Image m_image;
    int m_row = 0;
};

Result<std::unique_ptr<ImageRows>> wholeImage(const std::filesystem::path& file)
{
    Result<Image> image = readImage(file);
    if (!image) return image.error();
    return std::unique_ptr<ImageRows>{std::make_unique<RowsOfImage>(std::move(*image))};
}

} // namespace

Result<std::unique_ptr<ImageRows>> openImageRows(const std::filesystem::path& file, int largestSide)
{
    const std::string where = file.string();
    Result<FileReader> reader = FileReader::open(file);
    if (!reader) return reader.error();
    const std::string start = reader->start(32), format{imageFormat(start)};
    if (format == "png") {
        if (const auto size = declaredSize(start))
            if (Status sides = checkSides(size->x, size->y, {.side = largestSide}, where); !sides) return sides.error();
        auto rows = openPngRows(std::move(*reader), where, largestSide);
        return !rows || *rows ? std::move(rows) : wholeImage(file);
    }
    if (format != "tiff" && format != "openexr") return wholeImage(file);
    const Result<PictureModule> module = pictureModule();
    if (!module) return Error{where, module.error().what};
    return module->openRows(format, where, reader->size(), largestSide);
}

Result<std::string> encodeFloatRows(const std::string& extension, const ImageLayout& layout, const RowSource& source)
{
    EXPECTS(layout.type == PixelType::F32);
    const Result<PictureModule> module = pictureModule();
    if (!module) return module.error();
    if (extension == ".exr") return module->encode("exr", layout, source);
    if (extension == ".tif" || extension == ".tiff") return module->encode("tiff", layout, source);
    return Error{extension, "float pixels are written as .exr or .tif"};
}

} // namespace io
