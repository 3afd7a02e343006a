#include "app/play/session.h"

#include "io/base/value.h"
#include "io/files/json.h"
#include "io/scene/instance_walk.h"

#include <algorithm>
#include <cmath>

namespace play {
namespace {

void dropRepeated(std::vector<io::ObjectId>& ids)
{
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

const io::Object* startOf(const io::Scene& scene)
{
    const io::Object* best = nullptr;
    for (const io::Object& object : scene.objects())
        if (const io::Template* value = scene.find(object.templateId); value && value->player.start && (!best || object.id < best->id)) best = &object;
    return best;
}

io::PlayerStart likesOf(const io::Scene& scene)
{
    const io::Object* start = startOf(scene);
    return start ? scene.find(start->templateId)->player : io::PlayerStart{};
}

io::Value asValue(const glm::dvec3& v)
{
    return io::Value::Array{v.x, v.y, v.z};
}

} // namespace

Session::Session(const io::Scene& scene, const io::Assets& assets, const io::Camera& camera, bool fromMarker)
    : m_scene{scene}, m_begin{camera}, m_surroundings{m_scene, assets}, m_bodies{m_surroundings}, m_walker{likesOf(scene)}
{
    const io::PlayerStart& likes = m_walker.likes();
    m_third = likes.eye == io::PlayerEye::Third;
    if (const io::Object* start = fromMarker ? startOf(m_scene) : nullptr)
        m_walker.put(start->transform.position, start->transform.rotation.y, 0, m_surroundings);
    else
        m_walker.put(camera.eye - glm::dvec3{0, likes.eyeHeight, 0}, camera.yaw, camera.pitch, m_surroundings);
    findTriggers();
    m_eyeBefore = m_eyeNow = m_walker.eye() + fixedAt();
}

void Session::findTriggers()
{
    const auto isTrigger = [&](io::TemplateId id) {
        const io::Template* value = m_scene.find(id);
        return value && value->trigger.shape != io::TriggerShape::None;
    };
    for (const io::Object& object : m_scene.objects())
        if (isTrigger(object.templateId)) m_triggers.push_back({object.id});
    for (const io::ScatterLayer& layer : m_scene.scatterLayers()) {
        if (std::ranges::none_of(io::templatesOf(m_scene, layer), isTrigger)) continue;
        for (const auto& [place, tile] : m_scene.instances(layer.id))
            io::eachInstance(m_scene, {layer.id, place}, [&](io::ObjectId id, io::TemplateId what, const io::Transform& transform) {
                if (isTrigger(what)) m_triggers.push_back({id, io::Object{.id = id, .templateId = what, .transform = transform}});
            });
    }
    std::ranges::sort(m_triggers, {}, &Place::id);
}

void Session::change(io::ObjectId id, std::optional<io::Object> object)
{
    const auto before = m_scene.exchange(id, std::move(object));
    m_original.try_emplace(number(id), before);
    m_changes.objects.push_back(id);
    if (m_changes.objects.size() >= m_most) dropRepeated(m_changes.objects), m_most = 2 * m_changes.objects.size() + 4096;
    m_surroundings.follow({.objects = {id}});
}

io::Changes Session::takeChanges()
{
    dropRepeated(m_changes.objects);
    return std::exchange(m_changes, {});
}

bool Session::changed(io::ObjectId id) const
{
    const auto original = m_original.find(number(id));
    if (original == m_original.end()) return false;
    const io::Object* now = m_scene.find(id);
    return !now || !original->second || !(*now == *original->second);
}

std::vector<std::pair<io::Object, std::optional<io::Object>>> Session::left() const
{
    std::vector<std::pair<io::Object, std::optional<io::Object>>> result;
    for (const io::ObjectId id : differences().objects) {
        const std::optional<io::Object>& before = m_original.at(number(id));
        const io::Object* now = m_scene.find(id);
        if (before && !(now && *now == *before)) result.emplace_back(*before, now ? std::optional{*now} : std::nullopt);
    }
    return result;
}

io::Changes Session::differences() const
{
    io::Changes changes;
    for (const auto& [id, object] : m_original)
        changes.objects.push_back(io::ObjectId{id});
    std::ranges::sort(changes.objects);
    return changes;
}

void Session::step(const Wish& wish, bool otherEye)
{
    m_events.clear();
    ++m_steps;
    if (otherEye) m_third = !m_third;
    m_eyeBefore = m_eyeNow;
    m_centreBefore = m_walker.centre();
    carry();
    const glm::dvec3 before = m_walker.feet();
    m_walker.step(wish, m_surroundings);
    m_walked = m_walker.grounded() ? glm::length(m_walker.feet() - before) : 0;
    m_stoodOn = m_walker.ground();
    stand();
    push();
    moveBodies();
    carry();
    stepSounds(m_walked);
    trigger();
    m_eyeNow = m_walker.eye() + fixedAt();
    m_stoodOn = m_walker.ground();
    stand();
    standBehind();
}

void Session::stand()
{
    if (const io::Object* object = m_scene.find(m_stoodOn)) m_stoodAt = object->transform;
}

void Session::carry()
{
    const io::Object* object = m_scene.find(m_stoodOn);
    if (!object || object->transform == m_stoodAt) return;
    const glm::dquat turn = io::orientation(object->transform.rotation) * glm::inverse(io::orientation(m_stoodAt.rotation));
    m_walker.carry(io::worldFromModel(object->transform) * glm::inverse(io::worldFromModel(m_stoodAt)),
                   std::remainder(glm::degrees(2 * std::atan2(turn.y, turn.w)), 360.0), m_surroundings);
}

// What the player runs into and can move goes on as fast as the player then does; what it stands on bears its weight.
void Session::push()
{
    const double mass = double(m_walker.likes().mass);
    for (const Touched& touched : m_walker.touched()) {
        if (!m_bodies.holds(touched.id)) continue;
        const double speed = m_bodies.push(touched, m_walker.feet().y, mass);
        if (const glm::dvec3 way{-touched.normal.x, 0, -touched.normal.z}; std::abs(touched.normal.y) < 0.5)
            m_walker.setVelocity(m_walker.velocity() + glm::normalize(way) * std::max(0.0, speed));
    }
    if (m_walker.grounded()) m_bodies.weigh(m_walker.ground(), m_walker.feet(), mass);
}

void Session::moveBodies()
{
    m_bodies.step(m_walker);
    m_ways.clear();
    for (const io::Moved& moved : m_bodies.moved()) {
        const io::Object* object = m_scene.find(moved.id);
        if (!object) continue;
        m_ways.push_back({moved.id, object->transform, moved.transform});
        io::Object copy = *object;
        copy.transform = moved.transform;
        change(moved.id, std::move(copy));
    }
}

io::TemplateId Session::standsOn() const
{
    if (const io::Object* on = m_scene.find(m_walker.ground())) return on->templateId;
    const auto planted = m_scene.findInstance(m_walker.ground());
    return planted ? m_scene.templateOf(*planted) : io::TemplateId::None;
}

void Session::stepSounds(double walked)
{
    const io::Feet feet{.at = m_walker.feet(), .walked = walked, .speed = float(glm::length(m_walker.velocity())), .on = standsOn()};
    if (const std::string file = m_feet.walk(m_scene, feet); !file.empty()) m_events.push_back({Event::Kind::Step, file, 0, feet.at});
}

// The player's middle goes straight from where it was before the step: what is thinner than a step is long is met too.
bool Session::meets(const io::Object& object, const io::Trigger& trigger) const
{
    const glm::dvec3 size = glm::dvec3{trigger.size} * glm::abs(glm::dvec3{object.transform.scale}) / 2.0;
    const glm::dvec3 to = m_walker.centre() - object.transform.position, from = m_centreBefore - object.transform.position;
    const double reach = glm::length(size) + glm::length(to - from);
    if (glm::dot(to, to) > reach * reach) return false; // most are far away, of planted ones there may be many
    const glm::dquat turn = glm::inverse(io::orientation(object.transform.rotation));
    const glm::dvec3 at = turn * from, way = turn * (to - from);
    if (trigger.shape == io::TriggerShape::Sphere) {
        const double length = glm::dot(way, way);
        const double nearest = length > 0 ? std::clamp(-glm::dot(at, way) / length, 0.0, 1.0) : 0;
        const glm::dvec3 there = at + way * nearest;
        return glm::dot(there, there) <= size.x * size.x;
    }
    double enter = 0, leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(way[axis]) < 1e-12) {
            if (std::abs(at[axis]) > size[axis]) return false;
            continue;
        }
        const double a = (-size[axis] - at[axis]) / way[axis], b = (size[axis] - at[axis]) / way[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

void Session::trigger()
{
    for (Place& place : m_triggers) {
        const io::Object* object = place.planted ? &*place.planted : m_scene.find(place.id);
        const io::Template* value = object ? m_scene.find(object->templateId) : nullptr;
        const bool inside = value && meets(*object, value->trigger);
        const bool entered = inside && !place.inside && !(place.done && value->trigger.once);
        place.inside = inside;
        if (!entered) continue;
        place.done = true;
        const glm::dvec3 at = object->transform.position;
        const std::vector<io::TriggerAction> actions = value->trigger.actions; // they may hide the trigger itself
        for (const io::TriggerAction& action : actions)
            act(action, at);
    }
}

void Session::act(const io::TriggerAction& action, const glm::dvec3& at)
{
    switch (action.action) {
    case io::TriggerDo::PlaySound: return void(m_events.push_back({Event::Kind::Sound, action.what, 0, at}));
    case io::TriggerDo::ComeToLook: return void(m_events.push_back({Event::Kind::Look, action.what, action.seconds, at}));
    case io::TriggerDo::Message: return void(m_events.push_back({Event::Kind::Message, action.what, action.seconds, at}));
    case io::TriggerDo::Show: return show(action.what, true);
    case io::TriggerDo::Hide: return show(action.what, false);
    case io::TriggerDo::Teleport:
        if (const io::Camera* camera = m_scene.findCamera(action.what)) {
            m_walker.put(camera->eye - glm::dvec3{0, m_walker.likes().eyeHeight, 0}, camera->yaw, camera->pitch, m_surroundings);
            m_centreBefore = m_walker.centre(); // nothing is between the two places
            m_eyeBefore = m_walker.eye() + fixedAt();
        }
        return;
    }
}

// An object by its name, or all that a group of that name holds, and the groups in it.
void Session::show(const std::string& name, bool shown)
{
    if (name.empty()) return;
    const auto meant = [&](const io::Object& object) {
        constexpr int kDeepest = 64;
        const io::Object* one = &object;
        for (int depth = 0; one && depth < kDeepest; ++depth, one = m_scene.find(one->parent))
            if (one->name == name) return true;
        return false;
    };
    if (shown) {
        for (const io::Object& object : std::exchange(m_hidden, {})) {
            if (meant(object)) change(object.id, object), m_bodies.follow(object.id);
            else m_hidden.push_back(object);
        }
        // What appears where the player is pushes it out.
        if (m_walker.depth(m_surroundings) > 0.01 || m_surroundings.buried(m_walker.centre())) m_walker.put(m_walker.feet(), m_walker.yaw(), m_walker.pitch(), m_surroundings);
        return;
    }
    std::vector<io::Object> gone;
    for (const io::Object& object : m_scene.objects())
        if (object.templateId != io::TemplateId::None && meant(object)) gone.push_back(object);
    for (const io::Object& object : gone) {
        m_hidden.push_back(object);
        change(object.id, std::nullopt);
        m_bodies.follow(object.id);
    }
}

std::vector<io::Moved> Session::between(double share) const
{
    std::vector<io::Moved> things;
    for (const Way& way : m_ways) {
        io::Moved& thing = things.emplace_back(way.id, way.to);
        thing.transform.position = glm::mix(way.from.position, way.to.position, share);
        thing.transform.rotation = io::eulerDegrees(glm::slerp(io::orientation(way.from.rotation), io::orientation(way.to.rotation), share));
    }
    return things;
}

io::Camera Session::eye(const glm::dvec3& at) const
{
    io::Camera camera = m_begin;
    camera.eye = at;
    camera.yaw = float(m_walker.yaw());
    camera.pitch = float(m_walker.pitch());
    return camera;
}

io::Camera Session::camera(double share) const
{
    io::Camera camera = eye(glm::mix(m_eyeBefore, m_eyeNow, share));
    if (m_third) camera.eye -= io::forward(camera) * glm::mix(m_behindBefore, m_behindNow, share);
    return camera;
}

double Session::free(const glm::dvec3& from, const glm::dvec3& way)
{
    constexpr double kRadius = 0.2; // m, that it keeps from things
    io::WorldBox box;
    for (const glm::dvec3& end : {from, from + way})
        for (const double side : {-kRadius, kRadius})
            box.add(end + side);
    double share = 1;
    for (const Thing& thing : m_surroundings.find(box))
        if (const auto hit = sweep({.radius = kRadius}, from, way, thing)) share = std::min(share, hit->share);
    return share;
}

glm::dvec3 Session::fixedAt()
{
    const glm::dvec3 own{m_walker.likes().camera};
    if (own == glm::dvec3{0}) return own;
    const double yaw = glm::radians(m_walker.yaw());
    const glm::dvec3 right{std::cos(yaw), 0, -std::sin(yaw)}, ahead{-std::sin(yaw), 0, -std::cos(yaw)};
    const glm::dvec3 way = right * own.x + glm::dvec3{0, own.y, 0} + ahead * own.z;
    return way * free(m_walker.eye(), way);
}

// The camera of the third person keeps before what stands behind the player: at once where it comes near, slowly back again.
void Session::standBehind()
{
    constexpr double kBack = 4;     // m/s
    m_behindBefore = m_behindNow;
    if (!m_third) {
        m_behindBefore = m_behindNow = 0;
        return;
    }
    const double wanted = double(m_walker.likes().behind);
    const double share = free(m_eyeNow, -io::forward(eye(m_eyeNow)) * wanted);
    m_behindNow = std::min(share * wanted, m_behindNow + kBack * kStep);
    m_behindBefore = std::min(m_behindBefore, share * wanted);
}

std::string traceLine(const Session& session)
{
    const Walker& walker = session.walker();
    io::Value::Array contacts, sounds, moved;
    for (const io::Moved& body : session.bodies().moved())
        moved.push_back(io::Value::Object{{"id", double(number(body.id))}, {"position", asValue(body.transform.position)}, {"rotation", asValue(body.transform.rotation)}});
    for (const Touched& touched : walker.touched())
        contacts.push_back(io::Value::Object{{"id", double(number(touched.id))}, {"normal", asValue(touched.normal)}, {"speed", touched.speed}});
    for (const Event& event : session.events())
        if (event.kind == Event::Kind::Sound || event.kind == Event::Kind::Step) sounds.push_back(event.what);
    return io::writeJson(io::Value::Object{{"step", double(session.steps())},
                                           {"position", asValue(walker.feet())},
                                           {"velocity", asValue(walker.velocity())},
                                           {"grounded", walker.grounded()},
                                           {"contacts", std::move(contacts)},
                                           {"sounds", std::move(sounds)},
                                           {"moved", std::move(moved)}}) + "\n";
}

} // namespace play
