#include "io/files/gltf_accessors.h"

#include <algorithm>
#include <cstring>

namespace io::gltf {
namespace {

constexpr std::size_t kMostElements = std::size_t(64) << 20; // of one accessor, and of all that are read

std::string placeOf(int accessor)
{
    return "accessors[" + std::to_string(accessor) + "]";
}

template <class T> T load(const unsigned char* data)
{
    T value;
    std::memcpy(&value, data, sizeof value);
    return value;
}

// Normalization after the specification: signed values share zero, and the lowest one is cut off at -1.
float component(const unsigned char* data, int type, bool normalized)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return load<float>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return float(*data) / (normalized ? 255.0f : 1.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return float(load<std::uint16_t>(data)) / (normalized ? 65535.0f : 1.0f);
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
        const auto value = float(load<std::int8_t>(data));
        return normalized ? std::max(value / 127.0f, -1.0f) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
        const auto value = float(load<std::int16_t>(data));
        return normalized ? std::max(value / 32767.0f, -1.0f) : value;
    }
    default:
        return float(load<std::uint32_t>(data));
    }
}

std::size_t componentSize(int type, const std::string& place)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        throw Refused{place + ": componentType " + std::to_string(type) + " is unknown"};
    }
}

int componentsOf(int type, const std::string& place)
{
    switch (type) {
    case TINYGLTF_TYPE_SCALAR:
        return 1;
    case TINYGLTF_TYPE_VEC2:
        return 2;
    case TINYGLTF_TYPE_VEC3:
        return 3;
    case TINYGLTF_TYPE_VEC4:
        return 4;
    default:
        throw Refused{place + ": its type does not fit its use"};
    }
}

std::uint32_t index(const unsigned char* data, int type, const std::string& place)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return *data;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(data);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return load<std::uint32_t>(data);
    default:
        throw Refused{place + ": indices must be unsigned integers"};
    }
}

} // namespace

const tinygltf::Accessor& Accessors::at(int accessor) const
{
    if (accessor < 0 || std::size_t(accessor) >= m_model.accessors.size())
        throw Refused{"there is no accessor " + std::to_string(accessor)};
    return m_model.accessors[std::size_t(accessor)];
}

std::size_t Accessors::count(int accessor) const
{
    const std::size_t count = at(accessor).count;
    if (count < 1 || count > kMostElements)
        throw Refused{placeOf(accessor) + ": count " + std::to_string(count) + " is no possible size"};
    return count;
}

// (count - 1) * stride + offset + size must end inside the view, and the view inside its buffer; all below 2^31, so
// that no sum wraps in 64 bits.
Accessors::Range Accessors::range(int view, std::size_t offset, std::size_t count, std::size_t elementSize,
                                  bool strided, const std::string& place) const
{
    if (view < 0 || std::size_t(view) >= m_model.bufferViews.size())
        throw Refused{place + ": there is no bufferView " + std::to_string(view)};
    const tinygltf::BufferView& found = m_model.bufferViews[std::size_t(view)];
    if (found.buffer < 0 || std::size_t(found.buffer) >= m_sources.bufferCount())
        throw Refused{"bufferViews[" + std::to_string(view) + "]: there is no buffer " + std::to_string(found.buffer)};
    const std::string_view bytes = m_sources.buffer(std::size_t(found.buffer));
    if (found.byteOffset > bytes.size() || found.byteLength > bytes.size() - found.byteOffset)
        throw Refused{"bufferViews[" + std::to_string(view) + "]: reaches past the end of its buffer"};
    const std::size_t stride = strided && found.byteStride != 0 ? found.byteStride : elementSize;
    if (stride < elementSize || stride > 252)
        throw Refused{place + ": stride " + std::to_string(stride) + " is not possible"};
    if (count > kMostElements || offset > found.byteLength ||
        (count - 1) * stride + elementSize > found.byteLength - offset)
        throw Refused{place + ": reaches past the end of its bufferView"};
    return {reinterpret_cast<const unsigned char*>(bytes.data()) + found.byteOffset + offset, stride};
}

const Rows& Accessors::rows(int accessor, const Wanted& wanted)
{
    const tinygltf::Accessor& source = at(accessor);
    if (std::find(wanted.types.begin(), wanted.types.end(), source.type) == wanted.types.end())
        throw Refused{placeOf(accessor) + ": its type does not fit its use"};
    if (wanted.onlyFloat && source.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
        throw Refused{placeOf(accessor) + ": must hold float numbers"};
    if (const auto known = m_rows.find(accessor); known != m_rows.end()) return known->second;
    m_elements += count(accessor);
    if (m_elements > kMostElements) throw Refused{"over 64 million vertices; make it simpler"};
    return m_rows.emplace(accessor, read(accessor)).first->second;
}

Rows Accessors::read(int accessor) const
{
    const std::string place = placeOf(accessor);
    const tinygltf::Accessor& source = at(accessor);
    const std::size_t size = componentSize(source.componentType, place);
    const int components = componentsOf(source.type, place);

    Rows rows(count(accessor), glm::vec4{0});
    if (source.bufferView >= 0) {
        const Range data =
            range(source.bufferView, source.byteOffset, rows.size(), size * std::size_t(components), true, place);
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (int c = 0; c < components; ++c)
                rows[i][c] = component(data.data + i * data.stride + std::size_t(c) * size, source.componentType,
                                       source.normalized);
    } else if (!source.sparse.isSparse && rows.size() > 1'000'000) {
        throw Refused{place + ": has no data"}; // zeros by the specification, but never so many in earnest
    }
    if (source.sparse.isSparse) replaceSparse(source, place, rows);
    return rows;
}

void Accessors::replaceSparse(const tinygltf::Accessor& accessor, const std::string& place, Rows& rows) const
{
    const auto& sparse = accessor.sparse;
    if (sparse.count < 1 || std::size_t(sparse.count) > rows.size() || sparse.indices.byteOffset < 0 ||
        sparse.values.byteOffset < 0)
        throw Refused{place + ".sparse: count " + std::to_string(sparse.count) + " is not possible"};
    const auto count = std::size_t(sparse.count);
    const std::size_t size = componentSize(accessor.componentType, place);
    const int components = componentsOf(accessor.type, place);
    const std::size_t indexSize = componentSize(sparse.indices.componentType, place + ".sparse");
    const Range indices = range(sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset), count, indexSize,
                                false, place + ".sparse");
    const Range values = range(sparse.values.bufferView, std::size_t(sparse.values.byteOffset), count,
                               size * std::size_t(components), false, place + ".sparse");
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t row = index(indices.data + i * indexSize, sparse.indices.componentType, place + ".sparse");
        if (row >= rows.size()) throw Refused{place + ".sparse: index " + std::to_string(row) + " is past the end"};
        for (int c = 0; c < components; ++c)
            rows[row][c] = component(values.data + i * values.stride + std::size_t(c) * size, accessor.componentType,
                                     accessor.normalized);
    }
}

std::vector<std::uint32_t> Accessors::indices(int accessor) const
{
    const std::string place = placeOf(accessor);
    const tinygltf::Accessor& source = at(accessor);
    if (source.type != TINYGLTF_TYPE_SCALAR) throw Refused{place + ": indices must be single numbers"};
    if (source.sparse.isSparse) throw Refused{place + ": sparse indices are not supported; export it without"};
    const std::size_t size = componentSize(source.componentType, place);
    std::vector<std::uint32_t> result(count(accessor));
    const Range data = range(source.bufferView, source.byteOffset, result.size(), size, false, place);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = index(data.data + i * size, source.componentType, place);
    return result;
}

} // namespace io::gltf
