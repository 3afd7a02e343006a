#include "app/play/obstacles.h"

#include "app/play/bullet.h"
#include "app/play/ground_shape.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <algorithm>
#include <cmath>

namespace play {
namespace {

constexpr double kThick = 20, kHighest = 5000; // m, of the walls around the map

} // namespace

struct Obstacles::Placed {
    std::shared_ptr<Bulk> bulk;
    std::unique_ptr<btCollisionShape> shape; // of the ground and the edges of the map
    btCollisionObject object;
    int holders = 0;

    void put(btCollisionWorld& world, btCollisionShape& what, const btTransform& at)
    {
        object.setCollisionShape(&what);
        object.setWorldTransform(at);
        object.setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
        object.forceActivationState(ISLAND_SLEEPING); // or Bullet looks at what sleeps on it too
        object.setFriction(1); // what moves says how it slides and how it bounces
        object.setRestitution(0);
        world.addCollisionObject(&object, btBroadphaseProxy::StaticFilter, btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
    }
};

Obstacles::Obstacles(btCollisionWorld& world, Surroundings& surroundings) : m_world{world}, m_surroundings{surroundings}
{
    auto shape = groundShape(surroundings.scene());
    if (!shape) return;
    m_always.push_back(std::make_unique<Placed>());
    m_always.back()->shape = std::move(shape);
    m_always.back()->put(world, *m_always.back()->shape, btTransform::getIdentity());
    addEdges();
}

Obstacles::~Obstacles()
{
    for (auto& [id, placed] : m_standing)
        m_world.removeCollisionObject(&placed->object);
    for (auto& placed : m_always)
        m_world.removeCollisionObject(&placed->object);
}

// Nothing rolls off the map.
void Obstacles::addEdges()
{
    const io::HeightMap& map = *m_surroundings.scene().heights();
    const glm::dvec2 low = map.origin, high = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel;
    const glm::dvec3 middle{(low.x + high.x) / 2, 0, (low.y + high.y) / 2};
    const glm::dvec3 half{(high.x - low.x) / 2, kHighest, (high.y - low.y) / 2};
    for (const glm::dvec3& side : {glm::dvec3{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}) {
        glm::dvec3 size = half + kThick;
        if (side.x != 0) size.x = kThick;
        else size.z = kThick;
        m_always.push_back(std::make_unique<Placed>());
        m_always.back()->shape = std::make_unique<btBoxShape>(bullet(size));
        m_always.back()->put(m_world, *m_always.back()->shape, btTransform{btQuaternion::getIdentity(), bullet(middle + side * (half + kThick))});
    }
}

void Obstacles::hold(const io::WorldBox& box, const std::function<bool(io::ObjectId)>& moves, Held& held)
{
    m_found.clear();
    m_surroundings.standing(box, m_found);
    for (const Standing& thing : m_found) {
        if (moves(thing.id)) continue;
        std::unique_ptr<Placed>& placed = m_standing[thing.id];
        if (!placed) {
            // Of instances a little farther off, only those that reach here.
            const Shape& shape = m_surroundings.shapes().of(thing.templateId);
            const io::WorldBox around = io::transformed(shape.box, io::worldFromModel(thing.transform));
            const bool near = glm::all(glm::lessThanEqual(around.min, box.max)) && glm::all(glm::lessThanEqual(box.min, around.max));
            auto bulk = near ? bulkOf(m_surroundings.shapes(), thing.templateId, thing.transform.scale) : nullptr;
            if (!bulk) {
                m_standing.erase(thing.id);
                continue;
            }
            const glm::dquat turn = io::orientation(thing.transform.rotation);
            placed = std::make_unique<Placed>();
            placed->bulk = bulk;
            placed->put(m_world, *bulk->shape, btTransform{bullet(turn), bullet(thing.transform.position + turn * bulk->centre)});
        }
        ++placed->holders;
        held.push_back(thing.id);
    }
}

void Obstacles::letGo(Held& held)
{
    for (const io::ObjectId id : held) {
        const auto placed = m_standing.find(id);
        if (placed == m_standing.end() || --placed->second->holders > 0) continue;
        m_world.removeCollisionObject(&placed->second->object);
        m_standing.erase(placed);
    }
    held.clear();
}

void Obstacles::remove(io::ObjectId id)
{
    const auto placed = m_standing.find(id);
    if (placed == m_standing.end()) return;
    m_world.removeCollisionObject(&placed->second->object);
    m_standing.erase(placed);
}

} // namespace play
