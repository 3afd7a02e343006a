#include "io/files/gltf_buffer.h"

#include "io/files/json.h"

namespace io {
namespace {

void appendChunk(std::string& out, const char* type, std::string data, char padding)
{
    data.resize((data.size() + 3) & ~std::size_t{3}, padding);
    const auto size = std::uint32_t(data.size());
    out.append(reinterpret_cast<const char*>(&size), 4);
    out.append(type, 4);
    out += data;
}

} // namespace

std::string glbOf(const Value& gltf, std::string bytes)
{
    std::string chunks;
    appendChunk(chunks, "JSON", writeJson(gltf), ' ');
    appendChunk(chunks, "BIN\0", std::move(bytes), '\0');
    const std::uint32_t header[] = {0x46546C67, 2, std::uint32_t(chunks.size()) + 12}; // "glTF"
    return std::string{reinterpret_cast<const char*>(header), sizeof header} + chunks;
}

} // namespace io
