#include "io/files/gltf_document.h"

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

void addList(Value::Object& gltf, const char* key, Value::Array list)
{
    if (!list.empty()) gltf.emplace_back(key, std::move(list));
}

} // namespace

Value GltfDocument::text(const std::vector<int>& roots, const std::string& uri)
{
    Value::Array extensions;
    if (usesInstances) extensions.push_back("EXT_mesh_gpu_instancing");
    if (usesUnlit) extensions.push_back("KHR_materials_unlit");
    if (usesTransform) extensions.push_back("KHR_texture_transform");
    Value::Object gltf{{"asset", Value::Object{{"version", "2.0"}, {"generator", "Wold"}}}};
    addList(gltf, "extensionsUsed", std::move(extensions));
    if (usesInstances) gltf.emplace_back("extensionsRequired", Value::Array{"EXT_mesh_gpu_instancing"}); // without it one copy of each would be shown
    gltf.emplace_back("scene", 0);
    gltf.emplace_back("scenes", Value::Array{Value::Object{{"nodes", Value::Array(roots.begin(), roots.end())}}});
    gltf.emplace_back("nodes", std::move(nodes));
    addList(gltf, "meshes", std::move(meshes));
    addList(gltf, "materials", std::move(materials));
    addList(gltf, "textures", std::move(textures));
    addList(gltf, "samplers", std::move(samplers));
    addList(gltf, "images", std::move(images));
    addList(gltf, "accessors", std::move(buffer.accessors));
    addList(gltf, "bufferViews", std::move(buffer.views));
    Value::Object bytes{{"byteLength", std::uint64_t(buffer.bytes.size())}};
    if (!uri.empty()) bytes.emplace_back("uri", uri);
    gltf.emplace_back("buffers", Value::Array{std::move(bytes)});
    return gltf;
}

std::string glbOf(const Value& gltf, std::string bytes)
{
    std::string chunks;
    appendChunk(chunks, "JSON", writeJson(gltf), ' ');
    appendChunk(chunks, "BIN\0", std::move(bytes), '\0');
    const std::uint32_t header[] = {0x46546C67, 2, std::uint32_t(chunks.size()) + 12}; // "glTF"
    return std::string{reinterpret_cast<const char*>(header), sizeof header} + chunks;
}

} // namespace io
