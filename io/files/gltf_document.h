// What writers of glTF share: the lists of a document, the binary buffer with the views and accessors into it, the container.
#pragma once

#include "io/base/result.h"
#include "io/base/value.h"
#include "io/scene/cover_map.h"
#include "io/scene/field_words.h"
#include "io/scene/height_map.h"
#include "io/scene/model.h"

#include <map>
#include <string>
#include <vector>

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

// The lists of one file. Models that hold the same image share it.
struct GltfDocument {
    GltfBuffer buffer;
    Value::Array nodes, meshes, materials, textures, samplers, images;
    std::map<const Image*, int> imageNumbers;
    bool usesTransform = false, usesUnlit = false, usesInstances = false;

    Result<int> addMesh(const Model& model); // its number; without levels of detail, images as PNG
    // The text, whose scene is these nodes. The buffer's bytes are taken out by the caller; `uri` names them, in a .glb it is empty.
    Value text(const std::vector<int>& roots, const std::string& uri = {});
};

// Binary glTF of the text and its one buffer (Khronos, section 4.4).
std::string glbOf(const Value& gltf, std::string bytes);

// The ground as nodes of a document under one, whose number comes back; -1 where all of it is a hole.
struct GroundNodes {
    int root = -1, tiles = 0;
    std::uint64_t triangles = 0;
};
GroundNodes addGround(GltfDocument& document, const HeightMap& heights, const CoverMap* cover, const Terrain& terrain, int step);

} // namespace io
