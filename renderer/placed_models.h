// Models and their placed copies on one draw path. Batched: all models share one library's buffers. Direct: each model
// has a library, and so buffers, of its own and can be unloaded alone. Both hand out the same handles.
#pragma once

#include "io/scene/ids.h"
#include "io/scene/transform.h"
#include "renderer/instance_handle.h"
#include "renderer/instance_set.h"
#include "renderer/model_library.h"

#include <memory>
#include <vector>

namespace renderer {

struct Placement {
    int model = -1; // of registerModel()
    io::Transform transform;
    io::ObjectId id = io::ObjectId::None;
    io::TemplateId templateId = io::TemplateId::None;
    std::uint32_t flags = 0; // CULL_CASTS_SHADOW, CULL_MARKER
    float wind = 0;          // how freely it sways, 0..1
};

enum class Tint { None, Selected };

class PlacedModels {
public:
    explicit PlacedModels(io::DrawPath path);

    // The same model gives the same number. Pictures in place of meshes (`impostor`) are the batched path's alone.
    int registerModel(const std::shared_ptr<const io::Model>& model, bool impostor = false);
    io::Status unload(int model); // on the direct path: with its buffers and its instances
    void clear();

    io::Result<InstanceHandle> add(const Placement& placement);
    io::Status move(InstanceHandle handle, const Placement& placement); // it stays with its model
    io::Status tint(InstanceHandle handle, Tint tint);
    io::Status remove(InstanceHandle handle);
    const glsl::CullRecord* find(InstanceHandle handle) const; // null: stale, or of the other path
    int modelOf(InstanceHandle handle) const;                  // -1: the same

    const ModelLibrary& library(int model) const { return setOf(model).models; }
    const ModelEntry& entry(int model) const { return library(model).entry(isDirect() ? 0 : model); }
    ModelLibrary& shared() { return m_sets[0]->models; } // the one library of the batched path
    const ModelLibrary& shared() const { return m_sets[0]->models; }
    GpuCullScene gpuScene() const { return m_sets[0]->instances.gpuScene(); }

    void grow();   // until settle() views do not find what is added: for many at once
    void settle();
    void uploadModels();
    std::uint64_t uploadInstances(InstanceSet::Wanted wanted); // answers the bytes
    // Adds lists of what is seen; answers the instances that passed each test.
    glsl::CullCounts draws(GpuStream& stream, const CullRequest& request, bool blended, bool apart,
                           std::vector<DrawList>& lists) const;

    std::vector<const InstanceTree*> trees() const;
    // visit(instance, record) for each whose box touches this one.
    template <class Visit> void touching(const io::WorldBox& box, Visit&& visit) const
    {
        for (const auto& set : m_sets)
            if (set) set->instances.tree().touching(box, [&](const InstanceTree::Item& item) { visit(set->instances.record(item.value), set->instances.cullRecord(item.value)); });
    }
    std::size_t instances() const;
    std::size_t models() const; // held now
    bool blends() const;        // some model has parts that do

private:
    struct Set {
        explicit Set(std::shared_ptr<TexturePool> pool) : models{std::move(pool)} {}
        ModelLibrary models;
        InstanceSet instances;
        std::shared_ptr<const io::Model> model; // of a direct set
    };
    bool isDirect() const { return m_path == io::DrawPath::Direct; }
    Set& setOf(int model) const { return *m_sets[isDirect() ? std::size_t(model) : 0]; }
    bool isRegistered(int model) const;
    io::Error notRegistered(int model) const;
    void place(InstancePlace at, const Placement& placement);

    io::DrawPath m_path;
    InstanceHandles m_handles;
    std::shared_ptr<TexturePool> m_pool;         // of the direct path: models share what they show
    std::vector<std::unique_ptr<Set>> m_sets;    // batched: one; direct: by model, null once unloaded
};

glsl::Instance instanceOf(const io::Transform& transform, io::ObjectId id);
bool isMirrored(const io::Transform& transform);

} // namespace renderer
