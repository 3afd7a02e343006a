#include "renderer/model_library.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <utility>

namespace renderer {
namespace {

constexpr std::uint32_t kNowhere = 0xffffffffu;
constexpr float kStep = 1.2f; // least ratio of the errors of one level and the next

// Normals that were bent on purpose (outwards from a crown, say) differ from their triangles' own by far.
bool hasBentNormals(const io::Model& model, const io::Part& part)
{
    std::size_t bent = 0;
    for (std::uint32_t i = 0; i + 2 < part.indexCount; i += 3) {
        const std::uint32_t* corner = &model.indices[part.firstIndex + i];
        const io::Vertex& a = model.vertices[corner[0]];
        const glm::vec3 face = glm::cross(model.vertices[corner[1]].position - a.position,
                                          model.vertices[corner[2]].position - a.position);
        const float length = glm::length(face);
        if (length > 0 && std::abs(glm::dot(face / length, a.normal)) < 0.87f) ++bent;
    }
    return bent * 6 > part.indexCount / 3;
}

// Whether something is true of each triangle that a material covers, at any level.
bool everyTriangle(const io::Model& model, int material, auto&& isTrue)
{
    const auto inside = [&](std::span<const std::uint32_t> indices, std::span<const io::Part> parts) {
        for (const io::Part& part : parts)
            for (std::uint32_t i = 0; part.material == material && i + 2 < part.indexCount; i += 3) {
                const std::uint32_t* corner = &indices[part.firstIndex + i];
                if (!isTrue(model.vertices[corner[0]], model.vertices[corner[1]], model.vertices[corner[2]])) return false;
            }
        return true;
    };
    return inside(model.indices, model.parts) &&
           std::ranges::all_of(model.levels, [&](const io::Level& level) { return inside(level.indices, level.parts); });
}

// No coordinate leaves the picture: how that goes on beyond its edges does not matter then, and need not be paid for.
bool staysOnTexture(const io::Model& model, int material)
{
    const auto inside = [](const glm::vec2& uv) { return glm::all(glm::lessThanEqual(glm::abs(uv - 0.5f), glm::vec2{0.5f})); };
    return everyTriangle(model, material, [&](const auto&... corner) { return ((inside(corner.uv0) && inside(corner.uv1)) && ...); });
}

bool hasSmoothColours(const io::Model& model, int material)
{
    return !everyTriangle(model, material, [](const io::Vertex& a, const io::Vertex& b, const io::Vertex& c) {
        return a.colour == b.colour && a.colour == c.colour;
    });
}

glsl::CullModel cullModelOf(const ModelEntry& entry)
{
    glsl::CullModel model{};
    model.levels = std::uint32_t(entry.levels.size());
    for (int i = 0; i < int(entry.levels.size()); ++i)
        model.errors[i / 4][i % 4] = entry.levels[std::size_t(i)].error;
    model.firstBin = entry.firstBin;
    model.whole = entry.blended;
    model.impostor = entry.impostor;
    return model;
}

void addQuickWords(glsl::Material& to)
{
    const auto layer = [&](int unit) { return std::uint32_t(to.textures[unit].layer) & 0xffffu; };
    to.quick = {glm::packUnorm2x16({to.baseColour.r, to.baseColour.g}), glm::packUnorm2x16({to.baseColour.b, to.baseColour.a}),
                layer(BASE_COLOUR_UNIT) | layer(NORMAL_UNIT) << 16, to.flags};
    to.quick2 = {glm::packUnorm2x16({to.roughness, to.metallic}),
                 glm::packUnorm2x16({to.alphaCutoff, to.normalScale / MATERIAL_MOST_SCALE}), 0, 0};
}

const io::Material& materialOf(const io::Model& model, const io::Part& part)
{
    static const io::Material kPlain{.metallic = 0, .roughness = 0.8f};
    const bool known = part.material >= 0 && std::size_t(part.material) < model.materials.size();
    return known ? model.materials[std::size_t(part.material)] : kPlain;
}

template <class T>
void append(gl::Buffer& buffer, std::string_view label, std::vector<T>& fresh, std::size_t& count)
{
    if (fresh.empty()) return;
    gl::grow(buffer, label, (count + fresh.size()) * sizeof(T), count * sizeof(T));
    buffer.write(count * sizeof(T), std::as_bytes(std::span{fresh}));
    count += fresh.size();
    fresh.clear();
    fresh.shrink_to_fit();
}

} // namespace

std::vector<std::string> definesOf(unsigned features)
{
    std::vector<std::string> defines;
    if (features & kFeatureMask) defines.emplace_back("MASK");
    if (features & kFeatureNormalMap) defines.emplace_back("NORMAL_MAP");
    if (features & kFeatureSurfaceMaps) defines.emplace_back("SURFACE_MAPS");
    if (features & kFeatureWrap) defines.emplace_back("WRAP");
    if (features & kFeatureSmoothColours) defines.emplace_back("SMOOTH_COLOURS");
    if (features & kFeatureUvTransform) defines.emplace_back("UV_TRANSFORM");
    return defines;
}

ModelLibrary::ModelLibrary(std::shared_ptr<TexturePool> pool)
    : m_single{pool != nullptr}, m_textures{std::move(pool)}, m_materialTexels{"materials", GL_RGBA32UI}
{
    clear();
}

void ModelLibrary::clear()
{
    m_textures.clear();
    m_impostors.clear();
    m_entries.clear();
    m_models.clear();
    m_known.clear();
    m_bins.clear();
    m_cullModels.clear();
    ++m_revision;
    m_blends = false;
    m_batches.clear();
    m_newVertices.clear();
    m_newIndices.clear();
    m_newMaterials.clear();
    m_vertexCount = m_indexCount = m_materialCount = 0;
    if (m_single) return; // upload() makes them
    m_vertexBuffer = gl::Buffer{"vertices", sizeof(PackedVertex) * 1024};
    m_indexBuffer = gl::Buffer{"indices", sizeof(std::uint32_t) * 4096};
    m_materialBuffer = gl::Buffer{"materials", sizeof(glsl::Material) * 16};
    m_materialTexels.source(m_materialBuffer.id(), 0, m_materialBuffer.bytes());
}

int ModelLibrary::batchOf(const Batch& batch)
{
    const auto found = std::ranges::find(m_batches, batch);
    if (found != m_batches.end()) return int(found - m_batches.begin());
    m_batches.push_back(batch);
    return int(m_batches.size()) - 1;
}

glsl::MaterialTexture ModelLibrary::addTexture(const io::Model& model, const io::TextureUse& use, ColourSpace space,
                                               float cutoff, int unit, Batch& batch)
{
    glsl::MaterialTexture texture{};
    texture.matrix = {1, 0, 0, 1};
    texture.layer = -1;
    if (use.image < 0) return texture;

    const bool known = std::size_t(use.image) < model.images.size();
    const TextureLayer layer = m_textures.add(known ? model.images[std::size_t(use.image)] : nullptr, space, cutoff);
    batch.arrays[std::size_t(unit)] = layer.array;
    const bool moved = use.offset != glm::vec2{0} || use.scale != glm::vec2{1} || use.rotation != 0;
    if (moved || use.uvSet == 1) batch.features |= kFeatureUvTransform;
    if (!m_staysOnTexture && (use.wrapU != io::Wrap::Repeat || use.wrapV != io::Wrap::Repeat)) batch.features |= kFeatureWrap;

    // Counter-clockwise on the image, whose v runs down.
    const float c = std::cos(use.rotation), s = std::sin(use.rotation);
    texture.matrix = {c * use.scale.x, -s * use.scale.x, s * use.scale.y, c * use.scale.y};
    texture.offset = use.offset;
    texture.layer = layer.layer;
    texture.mode = (use.uvSet == 1 ? TEXTURE_UV1 : 0u) | unsigned(use.wrapU) << TEXTURE_WRAP_U_SHIFT |
                   unsigned(use.wrapV) << TEXTURE_WRAP_V_SHIFT;
    return texture;
}

std::uint32_t ModelLibrary::addMaterial(const io::Model& model, const io::Part& part, Batch& batch)
{
    const io::Material& from = materialOf(model, part);
    const bool mask = from.alphaMode == io::AlphaMode::Mask;
    batch.twoSided = from.doubleSided;
    batch.blend = from.alphaMode == io::AlphaMode::Blend;
    if (mask) batch.features |= kFeatureMask;
    if (hasSmoothColours(model, part.material)) batch.features |= kFeatureSmoothColours;
    if (from.normalTexture.image >= 0) batch.features |= kFeatureNormalMap;
    if (from.metallicRoughnessTexture.image >= 0 || from.occlusionTexture.image >= 0 ||
        from.emissiveTexture.image >= 0 || from.emissive != glm::vec3{0})
        batch.features |= kFeatureSurfaceMaps;

    glsl::Material to{};
    to.baseColour = from.baseColour;
    to.emissive = from.emissive;
    to.roughness = from.roughness;
    to.metallic = from.metallic;
    to.normalScale = from.normalScale;
    to.occlusionStrength = from.occlusionStrength;
    to.alphaCutoff = from.alphaCutoff;
    const bool leaf = mask && from.doubleSided;
    to.flags = (from.unlit ? MATERIAL_UNLIT : 0u) | (leaf ? MATERIAL_LEAF : 0u) |
               (from.doubleSided && hasBentNormals(model, part) ? MATERIAL_KEEP_NORMAL : 0u);

    m_staysOnTexture = staysOnTexture(model, part.material);
    const float cutoff = mask ? from.alphaCutoff : -1.0f;
    const io::TextureUse* uses[MATERIAL_TEXTURES] = {&from.baseColourTexture, &from.metallicRoughnessTexture,
                                                     &from.normalTexture, &from.occlusionTexture, &from.emissiveTexture};
    for (int unit = 0; unit < MATERIAL_TEXTURES; ++unit) {
        const bool colour = unit == BASE_COLOUR_UNIT || unit == EMISSIVE_UNIT;
        to.textures[unit] = addTexture(model, *uses[unit], colour ? ColourSpace::Srgb : ColourSpace::Linear,
                                       unit == BASE_COLOUR_UNIT ? cutoff : -1.0f, unit, batch);
    }
    addQuickWords(to);
    m_newMaterials.push_back(to);
    return std::uint32_t(m_materialCount + m_newMaterials.size() - 1);
}

ModelLibrary::Placed& ModelLibrary::place(const io::Model& model, const io::Part& part, std::vector<Placed>& placed)
{
    const auto known = std::ranges::find(placed, part.material, &Placed::material);
    if (known != placed.end()) return *known;
    Batch batch;
    Placed& fresh = placed.emplace_back();
    fresh.material = part.material;
    fresh.index = addMaterial(model, part, batch);
    fresh.batch = batchOf(batch);
    fresh.vertices.assign(model.vertices.size(), kNowhere);
    return fresh;
}

ModelLevel ModelLibrary::addLevel(const io::Model& model, std::span<const std::uint32_t> indices,
                                  std::span<const io::Part> parts, std::vector<Placed>& placed)
{
    ModelLevel level;
    for (const io::Part& part : parts) {
        if (part.indexCount < 3) continue;
        Placed& material = place(model, part, placed);
        level.parts.push_back({.firstIndex = std::uint32_t(m_indexCount + m_newIndices.size()),
                               .indexCount = part.indexCount,
                               .batch = material.batch});
        for (const std::uint32_t from : indices.subspan(part.firstIndex, part.indexCount)) {
            std::uint32_t& vertex = material.vertices[from];
            if (vertex == kNowhere) {
                vertex = std::uint32_t(m_vertexCount + m_newVertices.size());
                m_newVertices.push_back(pack(model.vertices[from], material.index));
            }
            m_newIndices.push_back(vertex);
        }
    }
    return level;
}

// Levels that differ too little to fade into one another are left out.
void ModelLibrary::addLevels(const io::Model& model, ModelEntry& entry)
{
    std::vector<Placed> placed;
    entry.levels.push_back(addLevel(model, model.indices, model.parts, placed));
    for (const ModelPart& part : entry.levels[0].parts)
        entry.blended |= m_batches[std::size_t(part.batch)].blend;
    if (!(entry.radius > 0)) return;
    for (const io::Level& level : model.levels) {
        const float error = level.error / entry.radius;
        const bool coarser = entry.levels.size() == 1 ? error > 0 : error >= entry.levels.back().error * kStep;
        if (!coarser || entry.levels.size() == MOST_LEVELS) continue;
        entry.levels.push_back(addLevel(model, level.indices, level.parts, placed));
        entry.levels.back().error = error;
    }
}

// The last level of all: a quad, in place of meshes that stray farther. What blends has none, as pictures cannot.
void ModelLibrary::addImpostor(const io::Model& model, ModelEntry& entry)
{
    if (entry.blended || entry.levels[0].parts.empty() || !(entry.radius > 0) || m_impostors.full()) return;
    while (entry.levels.back().error * kStep > kImpostorError || entry.levels.size() == MOST_LEVELS)
        entry.levels.pop_back();
    ImpostorShape shape{.centre = entry.centre,
                        .radius = entry.radius,
                        .extent = entry.bounds.size() / 2.0f,
                        .layer = m_impostors.add(size())};
    measureSurface(model, shape);
    const auto firstVertex = std::uint32_t(m_vertexCount + m_newVertices.size());
    const ModelPart quad{.firstIndex = std::uint32_t(m_indexCount + m_newIndices.size()),
                         .indexCount = 6,
                         .batch = batchOf({.twoSided = true, .features = kFeatureImpostor})};
    for (const PackedVertex& vertex : impostorQuad(shape))
        m_newVertices.push_back(vertex);
    for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u})
        m_newIndices.push_back(firstVertex + corner);
    entry.levels.push_back({.error = kImpostorError, .parts = {quad}});
    entry.impostor = true;
}

int ModelLibrary::add(const std::shared_ptr<const io::Model>& model, bool impostor)
{
    const std::pair key{model.get(), impostor};
    if (const auto known = m_known.find(key); known != m_known.end()) return known->second;
    ModelEntry entry;
    entry.bounds = model->bounds;
    for (const io::Level& level : model->levels) // cards that grew may reach a little further
        for (const std::uint32_t index : level.indices)
            entry.bounds.add(model->vertices[index].position);
    if (!entry.bounds.empty()) {
        entry.centre = entry.bounds.centre();
        entry.radius = glm::length(entry.bounds.size()) / 2;
    }
    addLevels(*model, entry);
    if (impostor) addImpostor(*model, entry);
    entry.firstBin = std::uint32_t(m_bins.size());
    for (int level = 0; level < int(entry.levels.size()); ++level)
        for (const bool swaying : {false, true})
            for (const bool mirrored : {false, true})
                for (const bool fading : {false, true})
                    m_bins.push_back({.model = size(), .level = level, .mirrored = mirrored, .fading = fading, .swaying = swaying});
    ++m_revision;
    m_blends |= entry.blended;
    m_cullModels.push_back(cullModelOf(entry));
    m_entries.push_back(std::move(entry));
    m_models.push_back(model);
    m_known.emplace(key, size() - 1);
    return size() - 1;
}

void ModelLibrary::letSway(int model)
{
    ModelEntry& entry = m_entries[std::size_t(model)];
    if (!std::exchange(entry.sways, true)) ++m_revision;
}

void ModelLibrary::upload()
{
    m_textures.upload();
    append(m_vertexBuffer, "vertices", m_newVertices, m_vertexCount);
    append(m_indexBuffer, "indices", m_newIndices, m_indexCount);
    append(m_materialBuffer, "materials", m_newMaterials, m_materialCount);
    m_materialTexels.source(m_materialBuffer.id(), 0, m_materialBuffer.bytes());
}

void ModelLibrary::bindMaterials() const
{
    glBindTextureUnit(MATERIALS_UNIT, m_materialTexels.id());
}

} // namespace renderer
