// Models in one vertex, one index and one material buffer, and the batches that draw them: all models of the batched
// path, where the parts of a batch go out in one multi-draw, or a single one of the direct path.
#pragma once

#include "io/scene/model.h"
#include "renderer/gl/buffer.h"
#include "renderer/impostors.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/culling.h"
#include "renderer/shaders/shared/material.h"
#include "renderer/texture_library.h"
#include "renderer/vertex_format.h"

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace renderer {

// What a batch's shader must do beyond the plain case; each combination is one program.
enum Feature : unsigned {
    kFeatureMask = 1,       // cut out by alpha
    kFeatureNormalMap = 2,
    kFeatureSurfaceMaps = 4, // roughness, metallic, occlusion or emission from textures, or emission at all
    kFeatureWrap = 8,       // a texture that does not repeat
    kFeatureImpostor = 16,  // a quad with pictures of the model, drawn by programs of its own
    kFeatureUvTransform = 32, // a texture that is moved, scaled or turned, or uses the second coordinates
    kFeatureSmoothColours = 64, // colours differ between the corners of a triangle
    kFeatureEnd = 128,
};
std::vector<std::string> definesOf(unsigned features);

struct Batch {
    bool twoSided = false;
    bool blend = false;
    unsigned features = 0;
    std::array<int, MATERIAL_TEXTURES> arrays{}; // of the texture library, by unit
    auto operator<=>(const Batch&) const = default;
};

// Not every fragment of it stays.
inline bool hasHoles(const Batch& batch)
{
    return batch.features & (kFeatureMask | kFeatureImpostor);
}

struct ModelPart {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    int batch = 0;
};

struct ModelLevel {
    float error = 0;              // of the model's radius: how far its surface strays from the full model's
    std::vector<ModelPart> parts;
};

struct ModelEntry {
    std::vector<ModelLevel> levels; // the full model first, at most MOST_LEVELS
    bool impostor = false;  // the last level is one
    io::Box bounds;         // m, model space, of all levels
    glm::vec3 centre{0};    // of the sphere around the bounds
    float radius = 0;
    bool blended = false;   // has parts that blend, which cannot fade
    bool sways = false;     // some template of it does
    std::uint32_t firstBin = 0;
};

// What is drawn alike goes into one bin: one level of one model, as it is or mirrored, whole or fading, still or swaying.
struct Bin {
    int model = 0, level = 0;
    bool mirrored = false, fading = false, swaying = false;
};
constexpr std::uint32_t binIndex(const ModelEntry& model, int level, bool mirrored, bool fading)
{
    return model.firstBin + std::uint32_t(level) * BINS_OF_LEVEL + (mirrored ? 2 : 0) + (fading ? 1 : 0);
}

class ModelLibrary {
public:
    explicit ModelLibrary(std::shared_ptr<TexturePool> pool = nullptr); // given one: for a single model, no byte too many

    // The same model gives the same number. `impostor`: it may be drawn as a picture of itself where it is small.
    int add(const std::shared_ptr<const io::Model>& model, bool impostor = false);
    void letSway(int model);
    const ModelEntry& entry(int model) const { return m_entries[std::size_t(model)]; }
    const io::Model& source(int model) const { return *m_models[std::size_t(model)]; }
    int size() const { return int(m_entries.size()); }
    std::span<const Bin> bins() const { return m_bins; }
    std::span<const glsl::CullModel> cullModels() const { return m_cullModels; }
    std::span<const Batch> batches() const { return m_batches; }
    const TextureLibrary& textures() const { return m_textures; }
    const ImpostorAtlas& impostors() const { return m_impostors; }
    ImpostorAtlas& impostors() { return m_impostors; }
    void clear();
    std::uint64_t revision() const { return m_revision; } // counts models that came or went
    bool blends() const { return m_blends; }               // some model has parts that do

    void upload(); // what was added since the last call
    GLuint vertices() const { return m_vertexBuffer.id(); }
    GLuint indices() const { return m_indexBuffer.id(); }
    void bindMaterials() const;

private:
    int batchOf(const Batch& batch);
    std::uint32_t addMaterial(const io::Model& model, const io::Part& part, Batch& batch);
    glsl::MaterialTexture addTexture(const io::Model& model, const io::TextureUse& use, ColourSpace space, float cutoff,
                                     int unit, Batch& batch);

    // What a material of the model being added became. Vertices carry it, so one that two materials share is
    // stored for each; levels use the vertices of those before them.
    struct Placed {
        int material = 0;
        std::uint32_t index = 0;
        int batch = 0;
        std::vector<std::uint32_t> vertices; // place in the buffer, by vertex of the model; kNowhere: not there yet
    };
    Placed& place(const io::Model& model, const io::Part& part, std::vector<Placed>& placed);
    ModelLevel addLevel(const io::Model& model, std::span<const std::uint32_t> indices, std::span<const io::Part> parts,
                        std::vector<Placed>& placed);
    void addLevels(const io::Model& model, ModelEntry& entry);
    void addImpostor(const io::Model& model, ModelEntry& entry);

    bool m_single;
    bool m_staysOnTexture = false; // the material being added, in its coordinates
    TextureLibrary m_textures;
    ImpostorAtlas m_impostors;
    std::vector<ModelEntry> m_entries;
    std::vector<std::shared_ptr<const io::Model>> m_models; // beside m_entries; keeps the keys of m_known alive
    std::map<std::pair<const io::Model*, bool>, int> m_known; // with or without an impostor
    std::uint64_t m_revision = 0;
    bool m_blends = false;
    std::vector<Bin> m_bins;
    std::vector<glsl::CullModel> m_cullModels; // beside m_entries
    std::vector<Batch> m_batches;

    // What still has to go to the GPU; counts are of what is there already.
    std::vector<PackedVertex> m_newVertices;
    std::vector<std::uint32_t> m_newIndices;
    std::vector<glsl::Material> m_newMaterials;
    std::size_t m_vertexCount = 0, m_indexCount = 0, m_materialCount = 0;
    gl::Buffer m_vertexBuffer, m_indexBuffer, m_materialBuffer;
    gl::BufferTexture m_materialTexels;
};

} // namespace renderer
