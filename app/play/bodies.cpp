#include "app/play/bodies.h"

#include "app/play/bullet.h"
#include "app/play/ground_contacts.h"
#include "app/play/ground_shape.h"
#include "io/scene/ground.h"

#include <algorithm>
#include <btBulletDynamicsCommon.h>
#include <cmath>

namespace play {
namespace {

constexpr int kLookEvery = 16;         // steps between two looks at what is near the player
constexpr double kGravity = 9.81;      // m/s2
constexpr double kFastest = 120;       // m/s
constexpr double kSpins = 40;          // rad/s
constexpr double kSeen = 1.0;          // m around a body in which what stands is known
constexpr double kSunk = 0.012;        // m in the ground, deeper than which a body is lifted
constexpr double kStands = 0.06;       // m between the ground and a corner that stands on it
constexpr double kLost = 200;          // m below the ground or the start, where a fall ends
constexpr double kLooked = 0.01;       // m in a step, farther than which it is asked whether a centre went into something
constexpr double kLightest = 0.05, kHeaviest = 1e5; // kg
constexpr double kRestSpeed = 0.3, kRestSpin = 0.5; // m/s, rad/s; slower for a while, a body falls asleep
constexpr double kRestAfter = 0.6;     // s
constexpr double kDamping = 0.02, kSpinDamping = 0.1; // share of speed and spin lost in a second

bool finite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool sound(const io::Transform& t)
{
    const glm::dvec3 size = glm::abs(glm::dvec3{t.scale});
    return finite(t.position) && finite(t.rotation) && finite(t.scale) && glm::all(glm::lessThan(glm::abs(t.position), glm::dvec3{1e7})) &&
           glm::all(glm::lessThan(size, glm::dvec3{1e4}));
}

double within(double value, double low, double high)
{
    return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

double massOf(const io::Body& body, const glm::vec3& scale)
{
    return within(double(body.mass) * std::abs(double(scale.x) * double(scale.y) * double(scale.z)), kLightest, kHeaviest);
}

// The more slippery and the more springy of two things decides.
btScalar leastFriction(const btCollisionObject* a, const btCollisionObject* b)
{
    return std::min(a->getFriction(), b->getFriction());
}
btScalar mostBounce(const btCollisionObject* a, const btCollisionObject* b)
{
    return std::max(a->getRestitution(), b->getRestitution());
}
btScalar mostRolling(const btCollisionObject* a, const btCollisionObject* b)
{
    return std::max(a->getRollingFriction(), b->getRollingFriction());
}

btDefaultCollisionConstructionInfo roomForGround()
{
    btDefaultCollisionConstructionInfo info;
    info.m_customCollisionAlgorithmMaxElementSize = kGroundContactsSize;
    return info;
}

// As Bullet's own, but for the ground, which has contacts of its own making.
void collide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info)
{
    auto* a = static_cast<btCollisionObject*>(pair.m_pProxy0->m_clientObject);
    auto* b = static_cast<btCollisionObject*>(pair.m_pProxy1->m_clientObject);
    if (!isGround(*a->getCollisionShape()) && !isGround(*b->getCollisionShape())) return btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
    if (!dispatcher.needsCollision(a, b)) return;
    if (isGround(*a->getCollisionShape())) std::swap(a, b);
    const auto* bulk = static_cast<const Bulk*>(a->getUserPointer());
    if (!bulk) return; // the player
    const btCollisionObjectWrapper body{nullptr, a->getCollisionShape(), a, a->getWorldTransform(), -1, -1};
    const btCollisionObjectWrapper ground{nullptr, b->getCollisionShape(), b, b->getWorldTransform(), -1, -1};
    if (!pair.m_algorithm) pair.m_algorithm = groundContacts(dispatcher, *bulk, *a, *b);
    btManifoldResult result{&body, &ground};
    pair.m_algorithm->processCollision(&body, &ground, info, &result);
}

} // namespace

struct Bodies::Body {
    io::ObjectId id = io::ObjectId::None;
    io::TemplateId templateId = io::TemplateId::None;
    io::Transform begun, now;
    std::shared_ptr<Bulk> bulk;         // made when it first comes near
    std::unique_ptr<btRigidBody> rigid; // null: frozen
    btVector3 velocity{0, 0, 0}, spin{0, 0, 0}; // of a frozen one
    bool asleep = false;                // likewise
    bool met = false;                   // it has been near the player
    io::WorldBox seen;                  // what stands in there is held
    Obstacles::Held held;

    glm::dvec3 centre() const { return plain(rigid->getWorldTransform().getOrigin()); }
};

struct Bodies::World {
    btDefaultCollisionConfiguration configuration{roomForGround()};
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    btCollisionObject player;
    std::unique_ptr<btCollisionShape> playerShape;
    Mover mover;
    glm::dvec3 playerAt{0};

    World()
    {
        // They are the whole program's; nothing else of it uses Bullet's dynamics.
        gCalculateCombinedFrictionCallback = leastFriction;
        gCalculateCombinedRestitutionCallback = mostBounce;
        gCalculateCombinedRollingFrictionCallback = mostRolling;
        gDeactivationTime = kRestAfter;
        configuration.setConvexConvexMultipointIterations(4, 4);
        dispatcher.setNearCallback(collide);
        world.setGravity({0, -kGravity, 0});
        world.setForceUpdateAllAabbs(false);
        world.getDispatchInfo().m_useContinuous = true;
        world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS; // or heaps creep
    }
    ~World()
    {
        if (playerShape) world.removeCollisionObject(&player);
    }
};

Bodies::Bodies(Surroundings& surroundings) : m_surroundings{surroundings}
{
    for (const io::Object& object : surroundings.scene().objects())
        add(object);
    std::ranges::sort(m_bodies, {}, [](const auto& body) { return body->id; });
}

Bodies::~Bodies()
{
    for (Body* body : m_present)
        m_world->world.removeRigidBody(body->rigid.get());
}

void Bodies::add(const io::Object& object)
{
    const io::Template* value = m_surroundings.scene().find(object.templateId);
    if (!value || !value->body.dynamic || !sound(object.transform)) return;
    auto body = std::make_unique<Body>();
    body->id = object.id;
    body->templateId = object.templateId;
    body->begun = body->now = object.transform;
    m_bodies.push_back(std::move(body));
}

const Bodies::Body* Bodies::find(io::ObjectId id) const
{
    const auto at = std::ranges::lower_bound(m_bodies, id, {}, [](const auto& body) { return body->id; });
    return at != m_bodies.end() && (*at)->id == id ? at->get() : nullptr;
}

std::size_t Bodies::awake() const
{
    return std::size_t(std::ranges::count_if(m_present, [](const Body* body) { return body->rigid->isActive(); }));
}

double Bodies::depth(io::ObjectId id)
{
    const Body* body = find(id);
    double deepest = 0;
    for (int i = 0; body && body->rigid && i < m_world->dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *m_world->dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getBody0() != body->rigid.get() && manifold.getBody1() != body->rigid.get()) continue;
        for (int k = 0; k < manifold.getNumContacts(); ++k)
            deepest = std::max(deepest, -double(manifold.getContactPoint(k).getDistance()));
    }
    return deepest;
}

void Bodies::wake(io::ObjectId id)
{
    if (Body* body = find(id); body && body->rigid) body->rigid->activate(true);
}

void Bodies::setVelocity(io::ObjectId id, const glm::dvec3& velocity)
{
    Body* body = find(id);
    if (!body || !body->rigid || !finite(velocity)) return;
    body->rigid->activate(true);
    body->rigid->setLinearVelocity(bullet(velocity));
}

void Bodies::follow(io::ObjectId id)
{
    if (Body* gone = find(id)) {
        if (gone->rigid) leave(*gone);
        std::erase_if(m_bodies, [&](const auto& body) { return body.get() == gone; });
    }
    const io::Object* object = m_surroundings.scene().find(id);
    if (object) {
        add(*object);
        std::ranges::sort(m_bodies, {}, [](const auto& body) { return body->id; });
    }
    // Who stood on it, or would stand in it now, looks around anew.
    if (m_obstacles) m_obstacles->remove(id);
    for (Body* body : m_present) {
        const bool held = std::erase(body->held, id) > 0;
        if (!held && !object) continue;
        body->seen = {};
        body->rigid->activate(true);
    }
    m_steps = 0;
}

// What is about to move is no obstacle any more, or again; those beside it must see that.
void Bodies::changedAround(io::ObjectId id, const io::WorldBox& box)
{
    m_obstacles->remove(id);
    for (Body* body : m_present) {
        std::erase(body->held, id);
        if (!body->seen.empty() && glm::all(glm::lessThanEqual(box.min, body->seen.max)) && glm::all(glm::lessThanEqual(body->seen.min, box.max))) body->seen = {};
    }
}

// As a person put it there: it stays like that until something touches it, and does not settle by itself to be another world's.
bool Bodies::standsOnGround(const Body& body) const
{
    const glm::dquat turn = plain(body.rigid->getWorldTransform().getRotation());
    std::size_t on = 0;
    for (const glm::dvec3& corner : body.bulk->corners) {
        const glm::dvec3 point = body.centre() + turn * corner;
        const auto ground = io::groundHeight(m_surroundings.scene(), point.x, point.z);
        on += ground && std::abs(point.y - body.bulk->rim - *ground) < kStands;
    }
    return on >= std::min<std::size_t>(3, body.bulk->corners.size());
}

void Bodies::join(Body& body)
{
    const io::Scene& scene = m_surroundings.scene();
    const io::Template* value = scene.find(body.templateId);
    if (!body.bulk) body.bulk = bulkOf(m_surroundings.shapes(), body.templateId, body.now.scale);
    if (!body.bulk || !value) return;
    if (!m_world) {
        m_world = std::make_unique<World>();
        m_obstacles = std::make_unique<Obstacles>(m_world->world, m_surroundings);
    }
    const double mass = massOf(value->body, body.now.scale);
    btVector3 inertia{0, 0, 0};
    body.bulk->shape->calculateLocalInertia(mass, inertia);
    for (int axis = 0; axis < 3; ++axis)
        inertia[axis] = std::max(inertia[axis], mass * 1e-5);
    const glm::dquat turn = io::orientation(body.now.rotation);
    btRigidBody::btRigidBodyConstructionInfo info{mass, nullptr, body.bulk->shape.get(), inertia};
    info.m_startWorldTransform = btTransform{bullet(turn), bullet(body.now.position + turn * body.bulk->centre)};
    info.m_friction = within(value->body.friction, 0, 4);
    info.m_restitution = within(value->body.bounce, 0, 0.95);
    info.m_linearDamping = kDamping;
    info.m_angularDamping = kSpinDamping;
    info.m_linearSleepingThreshold = kRestSpeed;
    info.m_angularSleepingThreshold = kRestSpin;
    body.rigid = std::make_unique<btRigidBody>(info);
    body.rigid->setUserPointer(body.bulk.get());
    if (body.bulk->rim > 0) body.rigid->setRollingFriction(0.02); // what is round comes to rest
    body.rigid->setCcdMotionThreshold(body.bulk->inner * 0.5);
    body.rigid->setCcdSweptSphereRadius(body.bulk->inner * 0.8);
    body.rigid->setLinearVelocity(body.velocity);
    body.rigid->setAngularVelocity(body.spin);
    if (!std::exchange(body.met, true)) body.asleep = standsOnGround(body);
    if (body.asleep) body.rigid->setActivationState(ISLAND_SLEEPING);
    m_present.insert(std::ranges::lower_bound(m_present, body.id, {}, [](const Body* other) { return other->id; }), &body);
    m_world->world.addRigidBody(body.rigid.get());
    btVector3 low, high;
    body.rigid->getAabb(low, high);
    changedAround(body.id, {plain(low), plain(high)});
}

void Bodies::leave(Body& body)
{
    btVector3 low, high;
    body.rigid->getAabb(low, high);
    body.velocity = body.rigid->getLinearVelocity();
    body.spin = body.rigid->getAngularVelocity();
    body.asleep = !body.rigid->isActive();
    m_world->world.removeRigidBody(body.rigid.get());
    body.rigid.reset();
    m_obstacles->letGo(body.held);
    body.seen = {};
    std::erase(m_present, &body);
    changedAround(body.id, {plain(low), plain(high)});
}

void Bodies::comeAndGo(const glm::dvec3& around)
{
    const auto away = [&](const Body& body) { return glm::length(glm::dvec2{body.now.position.x - around.x, body.now.position.z - around.z}); };
    for (const std::vector<Body*> present = m_present; Body* body : present)
        if (away(*body) > kFar) leave(*body);
    std::vector<std::pair<double, Body*>> coming;
    for (const auto& body : m_bodies)
        if (const double distance = body->rigid ? kFar : away(*body); distance <= kNear) coming.emplace_back(distance, body.get());
    const std::size_t room = kMost - std::min(kMost, m_present.size());
    if (coming.size() > room) {
        std::ranges::stable_sort(coming, {}, [](const auto& one) { return one.first; });
        coming.resize(room);
    }
    for (const auto& [distance, body] : coming)
        join(*body);
    m_lookedFrom = around;
}

// The player stops bodies and is no force itself: what it runs into is told by push().
void Bodies::placePlayer(const Walker& walker)
{
    World& w = *m_world;
    const Mover mover = walker.mover();
    if (!w.playerShape || mover.radius != w.mover.radius || mover.stem != w.mover.stem || mover.half != w.mover.half) {
        if (w.playerShape) w.world.removeCollisionObject(&w.player);
        if (mover.isBox()) w.playerShape = std::make_unique<btBoxShape>(bullet(mover.half));
        else w.playerShape = std::make_unique<btCapsuleShape>(mover.radius, 2 * mover.stem);
        w.mover = mover;
        w.player.setCollisionShape(w.playerShape.get());
        w.player.setFriction(0.4);
        w.player.forceActivationState(ISLAND_SLEEPING);
        w.world.addCollisionObject(&w.player, btBroadphaseProxy::CharacterFilter, btBroadphaseProxy::DefaultFilter);
    }
    const int flags = btCollisionObject::CF_STATIC_OBJECT | (walker.flying() ? int(btCollisionObject::CF_NO_CONTACT_RESPONSE) : 0);
    w.player.setCollisionFlags(flags);
    w.player.setWorldTransform(btTransform{btQuaternion::getIdentity(), bullet(walker.centre())});
    w.world.updateSingleAabb(&w.player);
    if (glm::length(walker.centre() - w.playerAt) < 1e-3) return;
    // What leaned against it may fall.
    const glm::dvec3 reach = mover.reach() + 0.05;
    struct Wake final : btBroadphaseAabbCallback {
        bool process(const btBroadphaseProxy* proxy) override
        {
            auto* object = static_cast<btCollisionObject*>(proxy->m_clientObject);
            if (!object->isStaticOrKinematicObject()) object->activate();
            return true;
        }
    } wake;
    if (!walker.flying()) w.broadphase.aabbTest(bullet(w.playerAt - reach), bullet(w.playerAt + reach), wake);
    w.playerAt = walker.centre();
}

void Bodies::lookAround(Body& body)
{
    btVector3 low, high;
    body.rigid->getAabb(low, high);
    io::WorldBox box{plain(low) - 0.05, plain(high) + 0.05};
    const glm::dvec3 motion = plain(body.rigid->getLinearVelocity()) * kStep;
    box.add(io::WorldBox{box.min + motion, box.max + motion});
    if (!body.seen.empty() && glm::all(glm::lessThanEqual(body.seen.min, box.min)) && glm::all(glm::lessThanEqual(box.max, body.seen.max))) return;
    const glm::dvec3 farther = motion * 8.0;
    box.add(io::WorldBox{box.min + glm::min(farther, 0.0), box.max + glm::max(farther, 0.0)});
    body.seen = {box.min - kSeen, box.max + kSeen};
    Obstacles::Held before = std::move(body.held);
    body.held.clear();
    m_obstacles->hold(body.seen, [this](io::ObjectId id) {
        const Body* other = find(id);
        return other && other->rigid;
    }, body.held);
    m_obstacles->letGo(before);
}

// Whatever Bullet made of it: it is somewhere, not in the ground, and not on the other side of what it flew at.
void Bodies::keepOut(Body& body, const glm::dvec3& before)
{
    btRigidBody& rigid = *body.rigid;
    const io::Scene& scene = m_surroundings.scene();
    glm::dvec3 at = body.centre();
    const auto put = [&](const glm::dvec3& to) {
        rigid.getWorldTransform().setOrigin(bullet(to));
        rigid.setInterpolationWorldTransform(rigid.getWorldTransform());
        at = to;
    };
    const auto stop = [&](const glm::dvec3& normal) {
        const glm::dvec3 velocity = plain(rigid.getLinearVelocity());
        rigid.setLinearVelocity(bullet(velocity - normal * std::min(0.0, glm::dot(velocity, normal))));
    };
    if (glm::length(at - before) > kLooked) {
        btCollisionWorld::ClosestRayResultCallback ray{bullet(before), bullet(at)};
        ray.m_collisionFilterGroup = btBroadphaseProxy::DefaultFilter;
        ray.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
        m_world->world.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
        if (ray.hasHit()) {
            glm::dvec3 normal = plain(ray.m_hitNormalWorld);
            if (glm::dot(normal, at - before) > 0) normal = -normal;
            put(plain(ray.m_hitPointWorld) + normal * body.bulk->inner);
            stop(normal);
        }
    }
    const auto ground = io::groundHeight(scene, at.x, at.z), was = io::groundHeight(scene, before.x, before.z);
    if (!ground || !was || before.y < *was) return; // beside the map, or where one gets through a hole
    if (at.y < *ground) put({at.x, *ground, at.z}), stop({0, 1, 0});
    const glm::dquat turn = plain(rigid.getWorldTransform().getRotation());
    const glm::dvec3 normal = scene.heights()->normal(at.x, at.z).value_or(glm::dvec3{0, 1, 0});
    double deepest = 0;
    for (const glm::dvec3& corner : body.bulk->corners) {
        const glm::dvec3 point = at + turn * corner - normal * body.bulk->rim;
        const auto over = io::groundHeight(scene, point.x, point.z);
        if (!over) return; // beside a hole, which it may be going through
        deepest = std::max(deepest, (*over - point.y) * normal.y);
    }
    if (deepest > kSunk) put(at + normal * (deepest - kSunk)), stop(normal);
}

void Bodies::note(Body& body)
{
    const glm::dquat turn = plain(body.rigid->getWorldTransform().getRotation());
    const glm::dvec3 at = body.centre() - turn * body.bulk->centre;
    const auto& heights = m_surroundings.scene().heights();
    const double bottom = (heights ? std::min(double(heights->min), body.begun.position.y) : body.begun.position.y) - kLost;
    if (!finite(at) || !finite({turn.x, turn.y, turn.z}) || !sound({at, {0, 0, 0}, body.now.scale}) || at.y < bottom) return void(m_lost.push_back(body.id));
    io::Transform transform = body.now;
    transform.position = at;
    transform.rotation = io::eulerDegrees(turn);
    if (transform == body.now) return;
    body.now = transform;
    m_moved.push_back({body.id, transform});
}

void Bodies::step(const Walker& walker)
{
    m_moved.clear();
    if (m_bodies.empty()) return;
    if (m_steps++ % kLookEvery == 0 || glm::length(walker.feet() - m_lookedFrom) > kNear / 4) comeAndGo(walker.feet());
    if (m_present.empty()) return;
    placePlayer(walker);
    if (awake() == 0) return;
    for (Body* body : m_present) {
        btRigidBody& rigid = *body->rigid;
        if (!rigid.isActive()) continue;
        if (const double speed = rigid.getLinearVelocity().length(); speed > kFastest) rigid.setLinearVelocity(rigid.getLinearVelocity() * (kFastest / speed));
        if (const double spin = rigid.getAngularVelocity().length(); spin > kSpins) rigid.setAngularVelocity(rigid.getAngularVelocity() * (kSpins / spin));
    }
    for (Body* body : m_present)
        if (body->rigid->isActive() || body->seen.empty()) lookAround(*body);
    struct Was {
        Body* body;
        glm::dvec3 centre;
        bool awake;
    };
    std::vector<Was> before;
    for (Body* body : m_present)
        before.push_back({body, body->centre(), body->rigid->isActive()});
    m_world->world.stepSimulation(kStep, 0);
    m_lost.clear();
    for (const Was& was : before) {
        if (!was.awake && !was.body->rigid->isActive()) continue;
        keepOut(*was.body, was.centre);
        note(*was.body);
    }
    for (const io::ObjectId id : m_lost) { // out of the world, or nowhere: back to where it began, at rest
        Body& body = *find(id);
        leave(body);
        body.velocity = body.spin = {0, 0, 0};
        body.asleep = true;
        if (body.now != body.begun) m_moved.push_back({id, body.now = body.begun});
    }
    std::ranges::stable_sort(m_moved, {}, &io::Moved::id);
}

double Bodies::push(const Touched& touched, double feet, double mass)
{
    Body* body = find(touched.id);
    if (!body || !body->rigid || !(mass > 0)) return 0;
    btRigidBody& rigid = *body->rigid;
    const bool level = std::abs(touched.normal.y) < 0.5;
    const glm::dvec3 way = -(level ? glm::normalize(glm::dvec3{touched.normal.x, 0, touched.normal.z}) : touched.normal);
    const glm::dvec3 centre = body->centre();
    glm::dvec3 point = touched.point;
    if (level) point.y = std::clamp(centre.y, feet + 0.3, feet + 1.4); // by the hands
    const glm::dvec3 arm = point - centre;
    const double approach = touched.speed - glm::dot(plain(rigid.getVelocityInLocalPoint(bullet(arm))), way);
    if (!(approach > 0) || !finite(point)) return touched.speed;
    const double impulse = approach / (1 / mass + rigid.computeImpulseDenominator(bullet(point), bullet(way)));
    rigid.activate(true);
    rigid.applyImpulse(bullet(way * impulse), bullet(arm));
    return touched.speed - impulse / mass;
}

void Bodies::weigh(io::ObjectId id, const glm::dvec3& at, double mass)
{
    Body* body = find(id);
    if (!body || !body->rigid || !body->rigid->isActive()) return;
    body->rigid->applyImpulse({0, -mass * kGravity * kStep, 0}, bullet(at - body->centre()));
}

} // namespace play
