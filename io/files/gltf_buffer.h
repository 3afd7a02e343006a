// What writers of glTF share: the binary buffer with the views and accessors into it, and the container.
#pragma once

#include "io/base/value.h"
#include "io/scene/field_words.h"

#include <string>

namespace io {

constexpr int kFloat = 5126;
constexpr int kUnsignedByte = 5121;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kVertexData = 34962; // ARRAY_BUFFER
constexpr int kIndexData = 34963;  // ELEMENT_ARRAY_BUFFER

template <class V> Value numbers(const V& vector)
{
    Value::Array result;
    for (int i = 0; i < vector.length(); ++i)
        result.push_back(decimal(vector[i]));
    return result;
}

// The binary chunk, and the views and accessors into it.
struct GltfBuffer {
    std::string bytes;
    Value::Array views;
    Value::Array accessors;

    int addView(const void* data, std::size_t size, int target)
    {
        bytes.resize((bytes.size() + 3) & ~std::size_t{3});
        Value::Object view{
            {"buffer", 0}, {"byteOffset", std::uint64_t(bytes.size())}, {"byteLength", std::uint64_t(size)}};
        if (target != 0) view.emplace_back("target", target);
        bytes.append(static_cast<const char*>(data), size);
        views.push_back(std::move(view));
        return int(views.size()) - 1;
    }
    int addAccessor(int view, int component, std::uint64_t offset, std::uint64_t count, const char* type)
    {
        Value::Object accessor{{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
        if (offset > 0) accessor.insert(accessor.begin() + 1, {"byteOffset", offset});
        accessors.push_back(std::move(accessor));
        return int(accessors.size()) - 1;
    }
};

// Binary glTF of the text and its one buffer (Khronos, section 4.4).
std::string glbOf(const Value& gltf, std::string bytes);

} // namespace io
