// Writes a model as binary glTF 2.0 (Khronos, sections 3 and 4.4).
#include "io/files/gltf_document.h"
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
Value primitives(const Model& model, GltfBuffer& buffer, int firstMaterial)
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
            Value::Object{{"attributes", vertexAccessors}, {"indices", indices}, {"material", firstMaterial + part.material}});
    }
    return result;
}

// Textures, samplers and materials, and the extensions they turn out to need.
class MaterialWriter {
public:
    MaterialWriter(const Model& model, GltfDocument& document) : m_model{model}, m_document{document} {}

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
            m_document.usesUnlit = true;
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
            m_document.usesTransform = true;
            info.emplace_back("extensions",
                              Value::Object{{"KHR_texture_transform", Value::Object{{"offset", numbers(use.offset)},
                                                                                    {"rotation", decimal(use.rotation)},
                                                                                    {"scale", numbers(use.scale)}}}});
        }
        owner.emplace_back(key, std::move(info));
    }
    int textureOf(const TextureUse& use)
    {
        const int source = m_document.imageNumbers.at(m_model.images[std::size_t(use.image)].get());
        return indexIn(m_document.textures, Value::Object{{"sampler", samplerOf(use)}, {"source", source}});
    }
    int samplerOf(const TextureUse& use)
    {
        const auto code = [](Wrap wrap) { return wrap == Wrap::Clamp ? 33071 : wrap == Wrap::Mirror ? 33648 : 10497; };
        return indexIn(m_document.samplers, Value::Object{{"magFilter", 9729}, // LINEAR
                                               {"minFilter", 9987}, // LINEAR_MIPMAP_LINEAR
                                               {"wrapS", code(use.wrapU)},
                                               {"wrapT", code(use.wrapV)}});
    }
    static int indexIn(Value::Array& list, const Value& item)
    {
        const auto found = std::find(list.begin(), list.end(), item);
        if (found != list.end()) return int(found - list.begin());
        list.push_back(item);
        return int(list.size()) - 1;
    }

    const Model& m_model;
    GltfDocument& m_document;
};

Status addImages(const Model& model, GltfDocument& document)
{
    for (const auto& image : model.images) {
        if (!image || document.imageNumbers.contains(image.get())) continue;
        const Result<std::string> png = encodePng(*image);
        if (!png) return png.error();
        const int view = document.buffer.addView(png->data(), png->size(), 0);
        document.imageNumbers[image.get()] = int(document.images.size());
        document.images.push_back(Value::Object{{"bufferView", view}, {"mimeType", "image/png"}});
    }
    return {};
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

Result<int> GltfDocument::addMesh(const Model& model)
{
    if (!consistent(model)) return Error{model.name, "the model has no triangles, or parts that do not fit its data"};
    if (!model.levels.empty()) return addMesh(withoutLevels(model));
    meshes.push_back(Value::Object{{"name", model.name}, {"primitives", primitives(model, buffer, int(materials.size()))}});
    if (const Status added = addImages(model, *this); !added) return Error{model.name, added.error().text()};
    MaterialWriter writer{model, *this};
    for (const Material& material : model.materials)
        materials.push_back(writer.write(material));
    return int(meshes.size()) - 1;
}

Result<std::string> encodeGlb(const Model& model)
{
    GltfDocument document;
    const Result<int> mesh = document.addMesh(model);
    if (!mesh) return mesh.error();
    document.nodes.push_back(Value::Object{{"name", model.name}, {"mesh", *mesh}});
    const Value text = document.text({0});
    return glbOf(text, std::move(document.buffer.bytes));
}

} // namespace io
