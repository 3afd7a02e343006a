#include "io/files/packed_bytes.h"

#include "io/base/contract.h"

#include <zlib.h>

namespace io {

PackedBytes::PackedBytes(std::span<const std::byte> bytes) : m_size{bytes.size()}
{
    uLongf size = compressBound(uLong(bytes.size()));
    m_packed.resize(size);
    const int code = compress2(reinterpret_cast<Bytef*>(m_packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                               uLong(bytes.size()), Z_BEST_SPEED);
    if (code == Z_MEM_ERROR) throw std::bad_alloc{};
    EXPECTS(code == Z_OK);
    m_packed.resize(size);
    m_packed.shrink_to_fit();
}

std::vector<std::byte> PackedBytes::unpacked() const
{
    std::vector<std::byte> bytes(m_size);
    uLongf size = uLongf(m_size);
    const int code = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(m_packed.data()),
                                uLong(m_packed.size()));
    if (code == Z_MEM_ERROR) throw std::bad_alloc{};
    EXPECTS(code == Z_OK && size == m_size);
    return bytes;
}

} // namespace io
