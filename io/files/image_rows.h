// Pictures read and written row by row, so that their pixels are never all in memory.
#pragma once

#include "io/base/result.h"
#include "io/scene/image.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace io {

struct ImageLayout {
    glm::ivec2 size{0};
    int channels = 1;
    PixelType type = PixelType::U8;

    std::size_t rowBytes() const { return std::size_t(size.x) * std::size_t(channels) * std::size_t(bytesOf(type)); }
};

// Decoded in two halves, so that one thread can unpack rows while another one makes pixels of those before.
class ImageRows {
public:
    virtual ~ImageRows() = default;
    // Unpacks the next `count` rows, packedRowBytes() each: a multiple of step(), or all that are left.
    virtual Status next(int count, std::byte* packed) = 0;
    // The pixels of the next row of those, laid out as in Image; they stay where they lie until the next call.
    virtual Result<const std::byte*> pixels(const std::byte* packed) { return packed; }

    const ImageLayout& layout() const { return m_layout; }
    std::size_t packedRowBytes() const { return m_packedRowBytes > 0 ? m_packedRowBytes : m_layout.rowBytes(); }
    int step() const { return m_step; } // rows that are unpacked together

protected:
    ImageLayout m_layout;
    std::size_t m_packedRowBytes = 0; // 0: as the pixels
    int m_step = 1;
};

// The pictures of decodeImage() with the same pixels. PNG, TIFF and EXR are read in bands, of which a side may have up to
// `largestSide` pixels and all of them any size; what can be decoded only whole (JPEG, HDR, DDS, interlaced PNG) is limited as there.
Result<std::unique_ptr<ImageRows>> openImageRows(const std::filesystem::path& file, int largestSide);

// Fills `rows` with `count` rows from `first` on; asked once for each row, in order.
using RowSource = std::function<void(int first, int count, std::byte* rows)>;

// The bytes of a PNG (8 or 16 bits), or of an EXR or TIFF (float; ".exr", ".tif", ".tiff").
Result<std::string> encodePngRows(const ImageLayout& layout, const RowSource& source);
Result<std::string> encodeFloatRows(const std::string& extension, const ImageLayout& layout, const RowSource& source);

} // namespace io
