// Surroundings: what of a scene can be run into near a place: the ground as triangles, objects and planted instances by the
// collision of their templates. Nothing is made before something comes near it.
#pragma once

#include "app/play/narrow.h"
#include "app/play/shapes.h"
#include "io/scene/scene_tree.h"

#include <functional>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

namespace play {

// An object or a planted instance that can be run into.
struct Standing {
    io::ObjectId id = io::ObjectId::None;
    io::TemplateId templateId = io::TemplateId::None;
    io::Transform transform;
};

class Surroundings {
public:
    // Both must outlive it; what changes in the scene is told by follow().
    Surroundings(const io::Scene& scene, const io::Assets& assets);
    ~Surroundings();

    void follow(const io::Changes& changes);
    // Things whose boxes touch `box`, in an order that depends on the scene alone. They hold until the next follow() or find().
    const std::vector<Thing>& find(const io::WorldBox& box);
    // Which things there are around `box`, and those a little farther off; in an order that depends on the scene alone.
    void standing(const io::WorldBox& box, std::vector<Standing>& things);
    // As they are now, whatever was moved; for the pictures of shapes.
    void addObject(io::ObjectId id, const io::WorldBox& box, std::vector<Thing>& things);

    // Whether a place lies in the solid of a closed mesh, which has walls alone; those of what is convex are told by contactOf().
    bool buried(const glm::dvec3& at);

    Shapes& shapes() { return m_shapes; }
    const io::Scene& scene() const { return m_scene; }

private:
    struct Placed;
    struct Grid;
    void index();
    void addGround(const io::WorldBox& box);
    void addEdges(const io::WorldBox& box);
    void eachInstance(const io::WorldBox& box, const std::function<void(const Standing&)>& visit);
    void add(io::ObjectId id, io::TemplateId templateId, const io::Transform& transform, const io::WorldBox& box, std::vector<Thing>& things);
    void addMesh(io::ObjectId id, io::TemplateId templateId, const glm::dmat4& world, const io::WorldBox& box, std::vector<Thing>& things);
    const Thing& solidOf(io::ObjectId id, const Shape& shape, const io::Transform& transform);
    const Grid& gridOf(const io::LayerTile& tile);

    const io::Scene& m_scene;
    const io::Assets& m_assets;
    Shapes m_shapes;
    io::SceneTree<io::ObjectId> m_tree;
    std::unordered_map<std::uint32_t, std::unique_ptr<Placed>> m_solids;
    std::map<io::LayerTile, std::unique_ptr<Grid>> m_grids;
    std::vector<Thing> m_found;
    std::vector<io::ObjectId> m_ids;
    std::vector<std::uint32_t> m_triangles;
};

} // namespace play
