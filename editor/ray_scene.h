// RayScene: the objects of a scene as instances of shared triangle trees (Embree), for rays.
#pragma once

#include "editor/picker.h"

#include <functional>
#include <memory>
#include <span>

namespace editor {

class RayScene {
public:
    RayScene();
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);
    void setBoxesOnly(bool boxesOnly);
    bool boxesOnly() const;

    // `skip` is sorted; `pixelWidth` as in PickOptions. The tree over all instances is brought up to date first.
    PickHit hit(const io::Ray& ray, double maxDistance, std::span<const io::ObjectId> skip, double pixelWidth);

    bool holds(io::ObjectId id) const;
    io::WorldBox bounds(io::ObjectId id) const;
    void forEachBounds(const std::function<void(io::ObjectId, const io::WorldBox&)>& visit) const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace editor
