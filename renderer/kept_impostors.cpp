#include "renderer/kept_impostors.h"

#include "renderer/run_length.h"
#include "renderer/shader_library.h"
#include "renderer/shaders/shared/impostor.h"

namespace renderer {
namespace {

// Counts up with every change of how the pictures are made that the texts of the shaders and the models do not show:
// renderer/impostor_baker.cpp, the mips of renderer/pixels.cpp, the levels of renderer/model_library.cpp.
constexpr std::uint32_t kBaking = 2;

constexpr std::array<std::string_view, 4> kStages{"objects.vert.glsl", "impostor_bake.frag.glsl",
                                                  "full_screen.vert.glsl", "impostor_shrink.frag.glsl"};

void add(io::ContentHash& hash, const auto& vector) // of GLM
{
    hash.add(&vector, sizeof vector);
}

void add(io::ContentHash& hash, const ModelLibrary& models, const io::Model& model, const io::TextureUse& use)
{
    const bool known = use.image >= 0 && std::size_t(use.image) < model.images.size();
    hash.add(use.image < 0);
    const io::Image* image = known ? model.images[std::size_t(use.image)].get() : nullptr;
    for (const std::uint64_t half : models.textures().pixelsOf(image))
        hash.add(half);
    hash.add(use.uvSet);
    add(hash, use.offset);
    add(hash, use.scale);
    hash.add(use.rotation);
    hash.add(use.wrapU);
    hash.add(use.wrapV);
}

void add(io::ContentHash& hash, const ModelLibrary& models, const io::Model& model, const io::Material& material)
{
    add(hash, material.baseColour);
    add(hash, material.emissive);
    for (const float value : {material.metallic, material.roughness, material.normalScale, material.occlusionStrength,
                              material.alphaCutoff})
        hash.add(value);
    hash.add(material.alphaMode);
    hash.add(material.doubleSided);
    hash.add(material.unlit);
    for (const io::TextureUse* use : {&material.baseColourTexture, &material.metallicRoughnessTexture,
                                      &material.normalTexture, &material.occlusionTexture, &material.emissiveTexture})
        add(hash, models, model, *use);
}

void add(io::ContentHash& hash, const std::vector<std::uint32_t>& indices, const std::vector<io::Part>& parts)
{
    static_assert(sizeof(io::Part) == 12, "hashed as bytes: no padding");
    hash.add(indices);
    hash.add(parts);
}

// Every mip of both arrays of one layer: `visit(texture, mip, texels)`.
template <class Visit> bool forEachPicture(const ImpostorAtlas& atlas, Visit&& visit)
{
    std::vector<std::uint32_t> texels;
    for (int mip = 0; mip < IMPOSTOR_MIPS; ++mip)
        for (const gl::Texture* texture : {&atlas.colours(), &atlas.surfaces()}) {
            const glm::ivec2 size = texture->size(mip);
            texels.resize(std::size_t(size.x) * std::size_t(size.y));
            if (!visit(*texture, mip, texels)) return false;
        }
    return true;
}

} // namespace

KeptImpostors::KeptImpostors(std::shared_ptr<io::KeptBytes> kept, const ShaderLibrary& shaders)
    : m_kept{std::move(kept)}, m_shaders{shaders}
{
}

io::ContentKey KeptImpostors::keyOf(const ModelLibrary& models, int number) const
{
    const io::Model& model = models.source(number);
    io::ContentHash hash;
    for (const std::uint32_t value : {kBaking, std::uint32_t(IMPOSTOR_FRAMES), std::uint32_t(IMPOSTOR_FRAME_TEXELS),
                                      std::uint32_t(IMPOSTOR_MIPS)})
        hash.add(value);
    for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) { // others round otherwise
        const auto* text = reinterpret_cast<const char*>(glGetString(name));
        hash.add(std::string_view{text ? text : ""});
    }
    for (const std::uint64_t half : m_shaders.textKey(kStages))
        hash.add(half);
    static_assert(sizeof(io::Vertex) == 60, "hashed as bytes: no padding");
    hash.add(model.vertices);
    add(hash, model.indices, model.parts);
    for (const io::Level& level : model.levels) {
        hash.add(level.error);
        add(hash, level.indices, level.parts);
    }
    for (const io::Material& material : model.materials)
        add(hash, models, model, material);
    return hash.key();
}

bool KeptImpostors::fill(const ModelLibrary& models, int model, const ImpostorAtlas& atlas, int layer)
{
    const std::optional<std::string> bytes = m_kept ? m_kept->find(keyOf(models, model)) : std::nullopt;
    if (!bytes) return false;
    std::string_view rest = *bytes;
    const auto take = [&](const gl::Texture& texture, int mip, std::vector<std::uint32_t>& texels) {
        if (!unpackTexels(rest, texels)) return false;
        texture.upload(texels.data(), GL_RGBA, GL_UNSIGNED_BYTE, mip, layer);
        return true;
    };
    return forEachPicture(atlas, take) && rest.empty();
}

void KeptImpostors::keep(const ModelLibrary& models, int model, const ImpostorAtlas& atlas, int layer)
{
    if (!m_kept) return;
    std::string bytes;
    forEachPicture(atlas, [&](const gl::Texture& texture, int mip, std::vector<std::uint32_t>& texels) {
        const glm::ivec2 size = texture.size(mip);
        glGetTextureSubImage(texture.id(), mip, 0, 0, layer, size.x, size.y, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                             GLsizei(texels.size() * sizeof texels[0]), texels.data());
        packTexels(texels, bytes);
        return true;
    });
    m_kept->keep(keyOf(models, model), bytes);
}

} // namespace renderer
