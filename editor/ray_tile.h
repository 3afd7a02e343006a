// RayTile: some hundred instances that lie together, as one Embree tree. It outlives changes: what was moved or removed
// since it was built no longer counts, and it is built again when something came or much has gone.
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
struct RayInstance {
    io::Transform transform;
    io::WorldBox bounds;
    io::ObjectId id = io::ObjectId::None; // None: a free place
    io::TemplateId templateId = io::TemplateId::None;
    std::uint32_t version = 0;
    std::uint32_t tile = kNoTile;
    std::uint32_t slot = 0; // in the tile's members
};

// What is asked of a tile.
struct RayQuery {
    io::Ray ray;
    std::span<const io::ObjectId> skip; // sorted
    float pixelWidth = 0;               // m, at 1 m
};

struct RayTileHit {
    double distance = 0; // m, as good as a float from the tile's edge on
    std::uint32_t place = kNoTile;
    const PartOfModel* part = nullptr;
    std::size_t triangle = 0; // counts from the part's first
};

class RayTile {
public:
    std::vector<std::uint32_t> members; // places of instances

    bool stale() const { return m_stale; }
    void touch() { m_stale = true; } // something came
    void lose();                     // a member went
    const io::WorldBox& box() const { return m_box; }
    void widen(const io::WorldBox& box) { m_box.add(box); }

    using MeshOf = std::function<std::shared_ptr<RayMesh>(io::TemplateId)>;
    // `often`: built so that building is cheap, else so that rays are.
    void build(RTCDevice device, std::span<const RayInstance> instances, const MeshOf& meshOf, bool often);

    // Nearer than `reach` only. `entry` is where the ray enters the tile's box.
    bool hit(const RayQuery& query, std::span<const RayInstance> instances, double entry, double reach,
             RayTileHit& found) const;

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
    static bool stands(const Context& context, const RTCRayHit& hit);

    EmbreeScene m_scene;
    std::vector<Built> m_built;
    std::vector<std::shared_ptr<RayMesh>> m_meshes; // kept while the tree stands on their triangles
    glm::dvec3 m_anchor{0};                         // m; Embree's floats are relative to it
    io::WorldBox m_box;                             // around the members; wider after one went
    std::size_t m_lost = 0;
    bool m_stale = true;
};

} // namespace editor
