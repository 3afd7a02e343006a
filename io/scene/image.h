// Pixels as read from a file: 8 or 16 bits or float, 1 to 4 channels, top row first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace io {

enum class PixelType { U8, U16, F32 };

constexpr int bytesOf(PixelType type)
{
    return type == PixelType::U8 ? 1 : type == PixelType::U16 ? 2 : 4;
}

struct Image {
    glm::ivec2 size{0};
    int channels = 4;
    PixelType type = PixelType::U8;
    std::vector<std::byte> bytes; // size.x * size.y * channels * bytesOf(type), no padding, native byte order

    std::size_t rowBytes() const { return std::size_t(size.x) * channels * bytesOf(type); }
    template <class T>
    const T* row(int y) const
    {
        return reinterpret_cast<const T*>(bytes.data() + rowBytes() * y);
    }
    template <class T>
    T* row(int y)
    {
        return reinterpret_cast<T*>(bytes.data() + rowBytes() * y);
    }
};

} // namespace io
