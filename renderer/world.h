// The GPU's mirror of a scene's objects and of its scatter layers' instances: each has a row on the path that its template chose.
#pragma once

#include "io/scene/assets.h"
#include "io/scene/changes.h"
#include "io/scene/footprint.h"
#include "io/scene/scene.h"
#include "renderer/placed_models.h"

#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace renderer {

struct ModelRef { // false: none
    const ModelLibrary* library = nullptr;
    int number = -1; // in it
    const ModelEntry& entry() const { return library->entry(number); }
    explicit operator bool() const { return library != nullptr; }
};

class World {
public:
    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);
    void move(io::ObjectId id, const io::Transform& transform); // an object, until the next update of it
    void select(std::span<const io::ObjectId> ids); // marked in the GBuffer
    void upload(bool culledThere);                  // what changed since the last call; spheres where the GPU culls

    // Draws for all that `request` lets through: one list, and one for each direct model of which something is seen.
    glsl::CullCounts batchedDraws(GpuStream& stream, const CullRequest& request, bool blended, std::vector<DrawList>& lists) const;
    glsl::CullCounts directDraws(GpuStream& stream, const CullRequest& request, bool blended, std::vector<DrawList>& lists) const;

    std::vector<const InstanceTree*> trees() const; // that hold everything
    GpuCullScene gpuScene() const { return m_batched.gpuScene(); }

    const ModelLibrary& sharedModels() const { return m_batched.shared(); }
    ImpostorAtlas& impostors() { return m_batched.shared().impostors(); }
    std::size_t directModels() const { return m_direct.models(); }
    ModelRef modelOf(io::TemplateId id) const;
    InstanceHandle handleOf(io::ObjectId id) const; // of nobody where it is not drawn
    const glsl::CullRecord* recordOf(io::ObjectId id) const; // null where it is not drawn
    // visit(instance, footprint) for each thing in a box that grass keeps out of.
    template <class Visit> void footprints(const io::WorldBox& box, Visit&& visit) const
    {
        const auto ask = [&](const glsl::Instance& instance, const glsl::CullRecord& record) {
            if (const io::FootprintShape& shape = footprintOf(io::TemplateId{record.templateId}); !shape.empty()) visit(instance, shape);
        };
        m_batched.touching(box, ask);
        m_direct.touching(box, ask);
    }
    std::size_t instances() const { return m_handleOf.size() + m_scattered; }
    io::WorldBox boundsOf(std::span<const io::ObjectId> ids) const;
    io::WorldBox bounds() const { return m_bounds; } // at least everything; does not shrink until the next scene
    float mostSway() const { return m_mostSway; }    // of CullRecord::sway; likewise
    std::uint64_t uploadedBytes() const { return m_uploadedBytes; } // of instances, since the start
    std::uint64_t revision() const { return m_revision; }           // counts changes of what all is drawn with

    // Where something came, went or moved since the last forgetTouched(): spheres, m; few, or else the revision counts.
    std::span<const glm::dvec4> touched() const { return m_touched; }
    void forgetTouched() { m_touched.clear(); }

private:
    struct TemplateState {
        io::DrawPath path = io::DrawPath::Batched;
        int model = -1; // of that path
        bool castShadow = true;
        bool marker = false;
        float wind = 0;
        std::shared_ptr<const io::Model> standing;    // of which a footprint is made; null: none
        io::Template asked;                           // what it is to be
        mutable std::optional<io::FootprintShape> footprint; // once it was asked for: it looks at each triangle
        bool shows(const TemplateState& other) const { return path == other.path && model == other.model; }
    };
    PlacedModels& on(io::DrawPath path) { return path == io::DrawPath::Direct ? m_direct : m_batched; }
    const PlacedModels& on(io::DrawPath path) const { return path == io::DrawPath::Direct ? m_direct : m_batched; }
    const TemplateState& stateOf(io::TemplateId id) const;
    const io::FootprintShape& footprintOf(io::TemplateId id) const;

    void rebuild(const io::Scene& scene, const io::Assets& assets);
    bool wasteful() const;
    void updateTemplates(const io::Scene& scene, const io::Assets& assets, std::span<const io::TemplateId> ids);
    void readTemplate(const io::Scene& scene, const io::Assets& assets, io::TemplateId id);
    void unloadUnused(const TemplateState& before);
    void updateObject(const io::Scene& scene, io::ObjectId id);
    struct Standing { // what is drawn, whether object or instance
        io::ObjectId id = io::ObjectId::None;
        io::TemplateId templateId = io::TemplateId::None;
        io::Transform transform;
    };
    InstanceHandle place(InstanceHandle handle, const Standing& standing); // where it was before, if it was; answers where it is
    void remove(io::ObjectId id);
    void remove(InstanceHandle handle);
    // `all`: also those that lie as before, since what they are copies of is another thing now.
    void updateInstances(const io::Scene& scene, std::span<const io::LayerTile> tiles, bool all);
    void placeTile(const io::Scene& scene, const io::LayerTile& at, bool all);
    std::vector<io::LayerTile> allTiles(const io::Scene& scene) const; // those that were, and those that are
    void markPlace(InstanceHandle handle);
    void tint(io::ObjectId id, Tint tint);

    PlacedModels m_batched{io::DrawPath::Batched}, m_direct{io::DrawPath::Direct};
    std::vector<TemplateState> m_templates; // by slot
    std::unordered_map<std::uint32_t, InstanceHandle> m_handleOf; // by object id

    struct Tile {
        std::shared_ptr<const io::InstanceTile> shown;
        std::uint32_t first = 0;             // number of its first instance
        std::vector<InstanceHandle> handles; // of nobody where one is not drawn
    };
    std::map<io::LayerTile, Tile> m_tiles;
    std::map<std::uint32_t, io::LayerTile> m_tileOf; // by the number of its first instance
    std::size_t m_scattered = 0;                     // instances that are drawn

    bool m_growing = false; // all is new: no places are marked
    std::vector<io::ObjectId> m_selection;
    bool m_selectionStale = false;
    std::vector<glm::dvec4> m_touched;
    io::WorldBox m_bounds;
    float m_mostSway = 0;
    std::uint64_t m_uploadedBytes = 0;
    std::uint64_t m_revision = 0;
};

} // namespace renderer
