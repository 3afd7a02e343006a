// The GPU's mirror of a scene's objects: one record each, found by id, uploaded only when it changed.
#pragma once

#include "io/scene/assets.h"
#include "io/scene/changes.h"
#include "io/scene/scene.h"
#include "renderer/cull.h"
#include "renderer/draw_list.h"
#include "renderer/gpu_culling.h"
#include "renderer/model_library.h"
#include "renderer/shaders/shared/instance.h"

#include <span>
#include <unordered_map>
#include <vector>

namespace renderer {

class World {
public:
    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);
    void select(std::span<const io::ObjectId> ids); // marked in the GBuffer
    void upload(bool culledThere);                  // what changed since the last call, where the GPU culls

    // Draws for all that `request` lets through.
    DrawList draws(GpuStream& stream, const CullRequest& request, bool blended) const;

    GpuCullScene gpuScene() const { return {m_recordBuffer.id(), m_cullBuffer.id(), m_records.size()}; }

    const ModelLibrary& models() const { return m_models; }
    ImpostorAtlas& impostors() { return m_models.impostors(); }
    int modelOf(io::TemplateId id) const; // -1: none
    std::size_t instances() const { return m_records.size(); }
    io::WorldBox boundsOf(std::span<const io::ObjectId> ids) const;
    io::WorldBox bounds() const { return m_bounds; } // at least everything; does not shrink until the next scene
    std::uint64_t uploadedBytes() const { return m_uploadedBytes; } // of instances, since the start
    std::uint64_t revision() const { return m_revision; }           // counts changes of what all is drawn with

    // Where something came, went or moved since the last forgetTouched(): spheres, m; few, or else the revision counts.
    std::span<const glm::dvec4> touched() const { return m_touched; }
    void forgetTouched() { m_touched.clear(); }

private:
    void rebuild(const io::Scene& scene, const io::Assets& assets);
    bool wasteful() const;
    void updateTemplates(const io::Scene& scene, const io::Assets& assets, std::span<const io::TemplateId> ids);
    void readTemplate(const io::Scene& scene, const io::Assets& assets, io::TemplateId id);
    void updateObject(const io::Scene& scene, io::ObjectId id);
    void place(std::uint32_t slot, const io::Object& object);
    void remove(std::uint32_t slot);
    void touch(std::uint32_t slot);
    void markPlace(std::uint32_t slot);
    void setFlags(io::ObjectId id, std::uint32_t flags);

    struct TemplateState {
        int model = -1;
        bool castShadow = true;
        bool marker = false;
    };
    ModelLibrary m_models;
    std::vector<TemplateState> m_templates; // by slot

    // By slot, all the same length.
    std::vector<glsl::Instance> m_records;
    std::vector<glsl::CullRecord> m_cullRecords;
    std::unordered_map<std::uint32_t, std::uint32_t> m_slotOf; // by object id

    io::SceneTree<std::uint32_t> m_tree; // of slots
    bool m_growing = false;              // the tree is built when all are there

    std::vector<std::uint32_t> m_dirty; // slots, perhaps more than once
    std::vector<io::ObjectId> m_selection;
    bool m_selectionStale = false;
    std::vector<glm::dvec4> m_touched;
    gl::Buffer m_recordBuffer, m_cullBuffer;
    bool m_onGpu = false; // the buffers hold what was there at the last upload
    io::WorldBox m_bounds;
    std::uint64_t m_uploadedBytes = 0;
    std::uint64_t m_revision = 0;
    mutable std::vector<Seen> m_seen; // kept between frames for its memory
};

glsl::Instance instanceOf(const io::Transform& transform, io::ObjectId id);
bool isMirrored(const io::Transform& transform);

} // namespace renderer
