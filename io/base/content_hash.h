// ContentHash: 128 bits that tell contents apart, the same on every machine of its byte order. Not proof against those
// who mean harm.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace io {

using ContentKey = std::array<std::uint64_t, 2>;

// Two sums with different multipliers over 8 bytes at a time (multiply and xor-shift, as in MurmurHash64).
class ContentHash {
public:
    void add(const void* data, std::size_t size)
    {
        const char* bytes = static_cast<const char*>(data);
        for (; size >= 8; bytes += 8, size -= 8)
            mix(word(bytes, 8));
        mix(word(bytes, size) ^ std::uint64_t(size) << 56);
    }
    void add(std::string_view text) { add(text.data(), text.size()); }
    template <class T> void add(const std::vector<T>& values)
    {
        add(values.size());
        add(values.data(), values.size() * sizeof(T));
    }
    template <class T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void add(T value)
    {
        add(&value, sizeof value);
    }
    ContentKey key() const { return {m_a ^ m_a >> 29, m_b ^ m_b >> 31}; }

private:
    static std::uint64_t word(const char* bytes, std::size_t size)
    {
        std::uint64_t value = 0;
        if (size > 0) std::memcpy(&value, bytes, size);
        return value;
    }
    void mix(std::uint64_t value)
    {
        m_a = (m_a ^ value) * 0x9e3779b97f4a7c15u;
        m_a ^= m_a >> 32;
        m_b = (m_b + value) * 0xc2b2ae3d27d4eb4fu;
        m_b ^= m_b >> 29;
    }
    std::uint64_t m_a = 0x243f6a8885a308d3u;
    std::uint64_t m_b = 0x13198a2e03707344u;
};

inline ContentKey contentKey(std::string_view bytes)
{
    ContentHash hash;
    hash.add(bytes);
    return hash.key();
}

} // namespace io
