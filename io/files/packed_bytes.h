// Bytes kept small in memory, by zlib at its quickest: what undo holds of large things.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace io {

class PackedBytes {
public:
    PackedBytes() = default;
    explicit PackedBytes(std::span<const std::byte> bytes);
    std::vector<std::byte> unpacked() const;
    std::size_t bytes() const { return m_packed.capacity(); }

private:
    std::string m_packed;
    std::size_t m_size = 0;
};

} // namespace io
