// Writes a model as binary glTF 2.0 (Khronos, sections 3 and 4.4).
#include "io/files/gltf_buffer.h"
#include "io/files/image_file.h"
#include "io/files/png_file.h"
#include "io/files/model_file.h"
#include "io/scene/field_words.h"

#include <algorithm>
#include <cstring>

namespace io {
namespace {

template <class T, class Get> int addVertices(GltfBuffer& buffer, const Model& model, Get get, int component, const char* type)
{
    std::vector<T> values;
    values.reserve(model.vertices.size());
    for (const Vertex& vertex : model.vertices)
        values.push_back(get(vertex));
    const int view = buffer.addView(values.data(), values.size() * sizeof(T), kVertexData);
    return buffer.addAccessor(view, component, 0, values.size(), type);
}

bool any(const Model& model, auto differs)
{
    return std::any_of(model.vertices.begin(), model.vertices.end(), differs);
}

Value attributes(const Model& model, GltfBuffer& buffer)
{
    Value::Object result;
    const auto add = [&](const char* name, int accessor) { result.emplace_back(name, accessor); };
    add("POSITION", addVertices<glm::vec3>(buffer, model, [](const Vertex& v) { return v.position; }, kFloat, "VEC3"));
    Box bounds;
    for (const Vertex& vertex : model.vertices)
        bounds.add(vertex.position);
    buffer.accessors.back()["min"] = numbers(bounds.min);
    buffer.accessors.back()["max"] = numbers(bounds.max);
    add("NORMAL", addVertices<glm::vec3>(buffer, model, [](const Vertex& v) { return v.normal; }, kFloat, "VEC3"));
    const bool bumpy = std::any_of(model.materials.begin(), model.materials.end(),
                                   [](const Material& m) { return m.normalTexture.image >= 0; });
    if (bumpy)
        add("TANGENT", addVertices<glm::vec4>(buffer, model, [](const Vertex& v) { return v.tangent; }, kFloat, "VEC4"));
    const bool second = any(model, [](const Vertex& v) { return v.uv1 != glm::vec2{0}; });
    if (second || any(model, [](const Vertex& v) { return v.uv0 != glm::vec2{0}; }))
        add("TEXCOORD_0", addVertices<glm::vec2>(buffer, model, [](const Vertex& v) { return v.uv0; }, kFloat, "VEC2"));
    if (second)
        add("TEXCOORD_1", addVertices<glm::vec2>(buffer, model, [](const Vertex& v) { return v.uv1; }, kFloat, "VEC2"));
    if (any(model, [](const Vertex& v) { return v.colour != glm::u8vec4{255}; })) {
        add("COLOR_0", addVertices<glm::u8vec4>(buffer, model, [](const Vertex& v) { return v.colour; }, kUnsignedByte, "VEC4"));
        buffer.accessors.back()["normalized"] = true;
    }
    return result;
}

// One view holds all indices; each part is an accessor into it.
Value primitives(const Model& model, GltfBuffer& buffer)
{
    const Value vertexAccessors = attributes(model, buffer);
    const bool narrow = model.vertices.size() < 65535; // 65535 itself means "restart" to some readers
    const std::vector<std::uint16_t> shorts =
        narrow ? std::vector<std::uint16_t>(model.indices.begin(), model.indices.end()) : std::vector<std::uint16_t>{};
    const std::size_t size = narrow ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
    const void* data = narrow ? static_cast<const void*>(shorts.data()) : model.indices.data();
    const int view = buffer.addView(data, model.indices.size() * size, kIndexData);

    Value::Array result;
    for (const Part& part : model.parts) {
        const int indices = buffer.addAccessor(view, narrow ? kUnsignedShort : kUnsignedInt,
                                               std::uint64_t(part.firstIndex) * size, part.indexCount, "SCALAR");
        result.push_back(
            Value::Object{{"attributes", vertexAccessors}, {"indices", indices}, {"material", part.material}});
    }
    return result;
}

// Textures, samplers and materials, and the extensions they turn out to need.
class MaterialWriter {
public:
    explicit MaterialWriter(const Model& model) : m_model{model} {}
    Value::Array textures;
    Value::Array samplers;
    bool usesTransform = false;
    bool usesUnlit = false;

    Value write(const Material& material)
    {
        Value::Object pbr{{"baseColorFactor", numbers(material.baseColour)},
                          {"metallicFactor", decimal(material.metallic)},
                          {"roughnessFactor", decimal(material.roughness)}};
        addTexture(pbr, "baseColorTexture", material.baseColourTexture);
        addTexture(pbr, "metallicRoughnessTexture", material.metallicRoughnessTexture);
        Value::Object result{{"name", material.name}, {"pbrMetallicRoughness", std::move(pbr)}};
        addTexture(result, "normalTexture", material.normalTexture, "scale", material.normalScale);
        addTexture(result, "occlusionTexture", material.occlusionTexture, "strength", material.occlusionStrength);
        addTexture(result, "emissiveTexture", material.emissiveTexture);
        if (material.emissive != glm::vec3{0}) result.emplace_back("emissiveFactor", numbers(material.emissive));
        if (material.alphaMode == AlphaMode::Blend) result.emplace_back("alphaMode", "BLEND");
        if (material.alphaMode == AlphaMode::Mask) {
            result.emplace_back("alphaMode", "MASK");
            result.emplace_back("alphaCutoff", decimal(material.alphaCutoff));
        }
        if (material.doubleSided) result.emplace_back("doubleSided", true);
        if (material.unlit) {
            usesUnlit = true;
            result.emplace_back("extensions", Value::Object{{"KHR_materials_unlit", Value::Object{}}});
        }
        return result;
    }

private:
    void addTexture(Value::Object& owner, const char* key, const TextureUse& use, const char* factorKey = nullptr,
                    float factor = 1)
    {
        const bool known = use.image >= 0 && use.image < int(m_model.images.size()) && m_model.images[use.image];
        if (!known) return;
        Value::Object info{{"index", textureOf(use)}};
        if (use.uvSet != 0) info.emplace_back("texCoord", use.uvSet);
        if (factorKey && factor != 1) info.emplace_back(factorKey, decimal(factor));
        if (use.offset != glm::vec2{0} || use.scale != glm::vec2{1} || use.rotation != 0) {
            usesTransform = true;
            info.emplace_back("extensions",
                              Value::Object{{"KHR_texture_transform", Value::Object{{"offset", numbers(use.offset)},
                                                                                    {"rotation", decimal(use.rotation)},
                                                                                    {"scale", numbers(use.scale)}}}});
        }
        owner.emplace_back(key, std::move(info));
    }
    int textureOf(const TextureUse& use)
    {
        // Files without a null image number their images as the model does; see imageNumber().
        const Value texture = Value::Object{{"sampler", samplerOf(use)}, {"source", imageNumber(use.image)}};
        return indexIn(textures, texture);
    }
    int samplerOf(const TextureUse& use)
    {
        const auto code = [](Wrap wrap) { return wrap == Wrap::Clamp ? 33071 : wrap == Wrap::Mirror ? 33648 : 10497; };
        return indexIn(samplers, Value::Object{{"magFilter", 9729}, // LINEAR
                                               {"minFilter", 9987}, // LINEAR_MIPMAP_LINEAR
                                               {"wrapS", code(use.wrapU)},
                                               {"wrapT", code(use.wrapV)}});
    }
    int imageNumber(int image) const
    {
        return int(std::count_if(m_model.images.begin(), m_model.images.begin() + image,
                                 [](const auto& known) { return known != nullptr; }));
    }
    static int indexIn(Value::Array& list, const Value& item)
    {
        const auto found = std::find(list.begin(), list.end(), item);
        if (found != list.end()) return int(found - list.begin());
        list.push_back(item);
        return int(list.size()) - 1;
    }

    const Model& m_model;
};

Result<Value> images(const Model& model, GltfBuffer& buffer)
{
    Value::Array result;
    for (const auto& image : model.images) {
        if (!image) continue;
        const Result<std::string> png = encodePng(*image);
        if (!png) return png.error();
        const int view = buffer.addView(png->data(), png->size(), 0);
        result.push_back(Value::Object{{"bufferView", view}, {"mimeType", "image/png"}});
    }
    return Value{std::move(result)};
}

void addList(Value::Object& gltf, const char* key, Value::Array list)
{
    if (!list.empty()) gltf.emplace_back(key, std::move(list));
}

// Parts index whole triangles of known vertices and name known materials, or the file would be refused by readers.
bool consistent(const Model& model)
{
    const auto badPart = [&](const Part& part) {
        return part.indexCount == 0 || part.indexCount % 3 != 0 || part.material < 0 ||
               part.material >= int(model.materials.size()) ||
               std::uint64_t(part.firstIndex) + part.indexCount > model.indices.size();
    };
    return !model.vertices.empty() && !model.parts.empty() &&
           std::none_of(model.parts.begin(), model.parts.end(), badPart) &&
           std::all_of(model.indices.begin(), model.indices.end(),
                       [&](std::uint32_t index) { return index < model.vertices.size(); });
}

// Levels are made anew by whoever reads the file; the vertices that only they use stand last.
Model withoutLevels(Model model)
{
    model.levels.clear();
    const auto last = std::max_element(model.indices.begin(), model.indices.end());
    model.vertices.resize(last == model.indices.end() ? 0 : *last + std::size_t{1});
    return model;
}

} // namespace

Result<std::string> encodeGlb(const Model& model)
{
    if (!consistent(model)) return Error{model.name, "the model has no triangles, or parts that do not fit its data"};
    if (!model.levels.empty()) return encodeGlb(withoutLevels(model));
    GltfBuffer buffer;
    Value meshes = Value::Object{{"name", model.name}, {"primitives", primitives(model, buffer)}};
    MaterialWriter writer{model};
    Value::Array materials;
    for (const Material& material : model.materials)
        materials.push_back(writer.write(material));
    Result<Value> imageList = images(model, buffer);
    if (!imageList) return Error{model.name, imageList.error().text()};

    Value::Array extensions;
    if (writer.usesUnlit) extensions.push_back("KHR_materials_unlit");
    if (writer.usesTransform) extensions.push_back("KHR_texture_transform");
    Value::Object gltf{{"asset", Value::Object{{"version", "2.0"}, {"generator", "Wold"}}}};
    addList(gltf, "extensionsUsed", std::move(extensions));
    gltf.emplace_back("scene", 0);
    gltf.emplace_back("scenes", Value::Array{Value::Object{{"nodes", Value::Array{0}}}});
    gltf.emplace_back("nodes", Value::Array{Value::Object{{"name", model.name}, {"mesh", 0}}});
    gltf.emplace_back("meshes", Value::Array{std::move(meshes)});
    addList(gltf, "materials", std::move(materials));
    addList(gltf, "textures", std::move(writer.textures));
    addList(gltf, "samplers", std::move(writer.samplers));
    addList(gltf, "images", *imageList->asArray());
    addList(gltf, "accessors", std::move(buffer.accessors));
    addList(gltf, "bufferViews", std::move(buffer.views));
    gltf.emplace_back("buffers", Value::Array{Value::Object{{"byteLength", std::uint64_t(buffer.bytes.size())}}});

    return glbOf(gltf, std::move(buffer.bytes));
}

} // namespace io
