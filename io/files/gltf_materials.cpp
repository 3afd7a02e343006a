#include "io/files/gltf_materials.h"

#include "io/files/text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace io::gltf {
namespace {

constexpr std::uint64_t kMostImageBytes = std::uint64_t(2) << 30;
constexpr std::size_t kLongestName = 256;

float factor(double value, double low, double high, double usual)
{
    return float(std::isfinite(value) ? std::clamp(value, low, high) : usual);
}

// An extension's list of numbers, when it is one.
template <int N> std::optional<glm::vec<N, float>> vector(const tinygltf::Value& object, const char* key)
{
    if (!object.Has(key)) return std::nullopt;
    const tinygltf::Value& list = object.Get(key);
    if (!list.IsArray() || list.ArrayLen() != N) return std::nullopt;
    glm::vec<N, float> result;
    for (int i = 0; i < N; ++i) {
        const tinygltf::Value& number = list.Get(i);
        if (!number.IsNumber() || !(std::abs(number.GetNumberAsDouble()) < 1e6)) return std::nullopt;
        result[i] = float(number.GetNumberAsDouble());
    }
    return result;
}

Wrap wrap(int code)
{
    return code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Wrap::Clamp
           : code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::Mirror
                                                           : Wrap::Repeat;
}

void transform(TextureUse& use, const tinygltf::ExtensionMap& extensions, const std::string& place, Notes& notes)
{
    const auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end()) return;
    const tinygltf::Value& value = found->second;
    if (!value.IsObject()) return notes.warn(place + ".KHR_texture_transform: is no object; left out");
    for (const char* key : {"offset", "scale"})
        if (value.Has(key) && !vector<2>(value, key))
            notes.warn(place + ".KHR_texture_transform." + key + ": must be two numbers; left out");
    use.offset = vector<2>(value, "offset").value_or(use.offset);
    use.scale = vector<2>(value, "scale").value_or(use.scale);
    if (value.Has("rotation") && value.Get("rotation").IsNumber())
        use.rotation = factor(value.Get("rotation").GetNumberAsDouble(), -1e6, 1e6, 0);
    if (value.Has("texCoord") && value.Get("texCoord").IsInt()) use.uvSet = value.Get("texCoord").GetNumberAsInt();
}

} // namespace

Materials::Materials(const tinygltf::Model& model, const Sources& sources, Notes& notes)
    : m_model{model}, m_sources{sources}, m_notes{notes}, m_place(model.materials.size() + 1, -1),
      m_imagePlace(sources.imageCount(), -1)
{
}

int Materials::use(int material)
{
    if (material >= int(m_model.materials.size()) || material < -1) {
        m_notes.warn("there is no material " + std::to_string(material) + "; the usual one is taken");
        material = -1;
    }
    int& place = m_place[std::size_t(material + 1)];
    if (place < 0) {
        place = int(list.size());
        list.push_back(material < 0 ? Material{}
                                    : read(m_model.materials[std::size_t(material)],
                                           "materials[" + std::to_string(material) + "]"));
    }
    return place;
}

Material Materials::read(const tinygltf::Material& source, const std::string& place)
{
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    Material result;
    result.name = source.name.substr(0, kLongestName);
    if (result.name.size() < source.name.size()) result.name = repairedUtf8(result.name); // cut inside a letter
    for (int i = 0; i < 4 && pbr.baseColorFactor.size() == 4; ++i)
        result.baseColour[i] = factor(pbr.baseColorFactor[std::size_t(i)], 0, 1, 1);
    for (int i = 0; i < 3 && source.emissiveFactor.size() == 3; ++i)
        result.emissive[i] = factor(source.emissiveFactor[std::size_t(i)], 0, 1, 0);
    result.metallic = factor(pbr.metallicFactor, 0, 1, 1);
    result.roughness = factor(pbr.roughnessFactor, 0, 1, 1);
    result.normalScale = factor(source.normalTexture.scale, -100, 100, 1);
    result.occlusionStrength = factor(source.occlusionTexture.strength, 0, 1, 1);
    result.alphaCutoff = factor(source.alphaCutoff, 0, 1, 0.5);
    result.doubleSided = source.doubleSided;
    result.unlit = source.extensions.contains("KHR_materials_unlit");
    if (source.alphaMode == "MASK")
        result.alphaMode = AlphaMode::Mask;
    else if (source.alphaMode == "BLEND")
        result.alphaMode = AlphaMode::Blend;
    else if (source.alphaMode != "OPAQUE" && !source.alphaMode.empty())
        m_notes.warn(place + ".alphaMode: unknown; taken as OPAQUE");

    const auto use = [&](const auto& info, const char* key) {
        return info.index == -1 ? TextureUse{} : texture(info.index, info.texCoord, info.extensions, place + "." + key);
    };
    result.baseColourTexture = use(pbr.baseColorTexture, "baseColorTexture");
    result.metallicRoughnessTexture = use(pbr.metallicRoughnessTexture, "metallicRoughnessTexture");
    result.normalTexture = use(source.normalTexture, "normalTexture");
    result.occlusionTexture = use(source.occlusionTexture, "occlusionTexture");
    result.emissiveTexture = use(source.emissiveTexture, "emissiveTexture");
    return result;
}

TextureUse Materials::texture(int index, int uvSet, const tinygltf::ExtensionMap& extensions, const std::string& place)
{
    if (index < 0 || index >= int(m_model.textures.size())) {
        m_notes.warn(place + ": there is no texture " + std::to_string(index) + "; left out");
        return {};
    }
    const tinygltf::Texture& source = m_model.textures[std::size_t(index)];
    TextureUse use{.image = image(source.source, place), .uvSet = uvSet};
    if (source.sampler >= 0 && source.sampler < int(m_model.samplers.size())) {
        use.wrapU = wrap(m_model.samplers[std::size_t(source.sampler)].wrapS);
        use.wrapV = wrap(m_model.samplers[std::size_t(source.sampler)].wrapT);
    } else if (source.sampler != -1) {
        m_notes.warn(place + ": there is no sampler " + std::to_string(source.sampler) + "; the usual one is taken");
    }
    transform(use, extensions, place, m_notes);
    if (use.uvSet != 0 && use.uvSet != 1) {
        m_notes.warn(place + ".texCoord: " + std::to_string(use.uvSet) + " is not supported; 0 is taken");
        use.uvSet = 0;
    }
    return use;
}

int Materials::image(int source, const std::string& place)
{
    if (source < 0 || source >= int(m_imagePlace.size())) {
        m_notes.warn(place + ": its image is missing or of a kind that Wold does not read; left out");
        return -1;
    }
    int& found = m_imagePlace[std::size_t(source)];
    if (found >= 0) return found;
    found = int(images.size());
    using Shared = Result<std::shared_ptr<const Image>>;
    const Shared read = m_imageBytes > kMostImageBytes ? Shared{Error{place, "its images are over 2 GiB"}}
                                                       : m_sources.readImage(std::size_t(source));
    if (read)
        m_imageBytes += (*read)->bytes.size();
    else
        m_notes.warn(place + ": " + read.error().text());
    images.push_back(read ? *read : nullptr);
    return found;
}

} // namespace io::gltf
