// RayTree: instances as one Embree tree. It outlives changes: what was moved or removed since it was built no longer
// counts.
#pragma once

#include "editor/ray_mesh.h"
#include "io/scene/bounds.h"
#include "io/scene/ids.h"
#include "io/scene/transform.h"

#include <functional>
#include <span>
#include <vector>

namespace editor {

constexpr std::uint32_t kNoTile = ~0u;

// An object that rays can meet. Places in the list of them are used again; a version never is.
struct alignas(64) RayInstance { // what a hit needs lies in one line of the processor's cache
    io::Transform transform;
    io::ObjectId id = io::ObjectId::None; // None: a free place
    io::TemplateId templateId = io::TemplateId::None;
    std::uint32_t version = 0;
    std::uint32_t tile = kNoTile;
    io::WorldBox bounds;
    std::uint32_t slot = 0; // in the tile's members
};

// What is asked of a tree.
struct RayQuery {
    io::Ray ray;
    std::span<const io::ObjectId> skip; // sorted
    float pixelWidth = 0;               // m, at 1 m
};

struct RayTreeHit {
    double distance = 0; // m, as good as a float from the box's edge on
    std::uint32_t place = kNoTile;
    const PartOfModel* part = nullptr;
    std::size_t triangle = 0; // counts from the part's first
    const glm::mat3* linear = nullptr; // of the instance's transform
};

class RayTree {
public:
    using MeshOf = std::function<std::shared_ptr<RayMesh>(io::TemplateId)>;
    using Places = std::span<const std::uint32_t>;
    // `often`: built so that building is cheap, else so that rays are.
    void build(RTCDevice device, Places places, std::span<const RayInstance> instances, const MeshOf& meshOf,
               bool often);
    void clear() { *this = {}; }
    bool empty() const { return m_built.empty(); }

    void lose() { ++m_lost; } // an instance that it was built of went or moved
    bool muchLost() const { return m_lost * 4 > m_built.size(); }

    // Nearer than `reach` only. `entry` is where the ray enters a box around all.
    bool hit(const RayQuery& query, std::span<const RayInstance> instances, double entry, double reach,
             RayTreeHit& found) const;

private:
    struct Built { // an instance as it was; its number here is Embree's
        std::uint32_t place, version;
        const RayMesh* mesh;
        glm::mat3 linear; // of the transform
    };
    struct Candidate;
    struct Context;
    friend void filterHit(const RTCFilterFunctionNArguments* arguments);
    static bool seen(const Context& context, const Candidate& hit);
    bool stands(const Context& context, const RTCRayHit& hit) const;

    EmbreeScene m_scene;
    std::vector<Built> m_built;
    std::vector<std::shared_ptr<RayMesh>> m_meshes; // kept while the tree stands on their triangles
    glm::dvec3 m_anchor{0};                         // m; Embree's floats are relative to it
    std::size_t m_lost = 0;
};

} // namespace editor
