// RayScene: the objects of a scene as instances of shared triangle trees (Embree), for rays. A tree over all instances
// would be built whole at each change; so they lie in tiles, and what changed lately in a small tree of its own.
#pragma once

#include "editor/picker.h"

#include <functional>
#include <memory>
#include <span>

namespace editor {

class RayScene {
public:
    static constexpr std::size_t kTile = 4000;  // instances in a tile when it is made; up to half as many again come
    static constexpr std::size_t kRecent = 64; // instances in the small tree

    RayScene();
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);
    void setBoxesOnly(bool boxesOnly);
    bool boxesOnly() const;

    // `skip` is sorted; `pixelWidth` as in PickOptions. The tiles that the ray enters are brought up to date first.
    PickHit hit(const io::Ray& ray, double maxDistance, std::span<const io::ObjectId> skip, double pixelWidth);
    void prepare(); // all tiles at once

    bool holds(io::ObjectId id) const;
    io::WorldBox bounds(io::ObjectId id) const;
    // At least those that reach into the planes' inside, dot(n, p) + d >= 0.
    void forEachInside(std::span<const glm::dvec4> planes,
                       const std::function<void(io::ObjectId, const io::WorldBox&)>& visit);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace editor
