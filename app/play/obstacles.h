// Obstacles: what stands still in Bullet's world, for as long as something that moves is near it.
#pragma once

#include "app/play/bulk.h"
#include "app/play/surroundings.h"

#include <functional>
#include <map>
#include <memory>
#include <vector>

class btCollisionWorld;

namespace play {

class Obstacles {
public:
    using Held = std::vector<io::ObjectId>;

    // The ground and the edges of the map stay as long as this does. Both must outlive it.
    Obstacles(btCollisionWorld& world, Surroundings& surroundings);
    ~Obstacles();

    // In the world until they are let go of: what stands around `box`, but for what moves by itself.
    void hold(const io::WorldBox& box, const std::function<bool(io::ObjectId)>& moves, Held& held);
    void letGo(Held& held);
    void remove(io::ObjectId id); // whoever holds it: it is gone, or moves from now on

private:
    struct Placed;
    void addEdges();

    btCollisionWorld& m_world;
    Surroundings& m_surroundings;
    std::map<io::ObjectId, std::unique_ptr<Placed>> m_standing;
    std::vector<std::unique_ptr<Placed>> m_always;
    std::vector<Standing> m_found;
};

} // namespace play
