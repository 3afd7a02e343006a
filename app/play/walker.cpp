#include "app/play/walker.h"

#include "io/scene/ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace play {
namespace {

constexpr double kGravity = 9.81;     // m/s2
constexpr double kFastest = 100;      // m/s
constexpr double kGrip = 40;          // m/s2, on the ground
constexpr double kSteer = 6;          // m/s2, in the air
constexpr double kDrag = 3;           // 1/s, of water
constexpr double kAfloat = 0.7;       // share of the height that is in the water when swimming begins
constexpr int kSlides = 6;            // things slid along in a step
constexpr int kWedged = 15;           // steps
constexpr int kFirm = 30;             // steps on the ground, after which a place is one to come back to
constexpr double kLooked = 89;        // degrees, the most up and down
constexpr double kLost = 200;         // m below the ground, or below where it last stood if there is none, where a fall ends

const double kRadians = glm::radians(1.0);

glm::dvec3 level(const glm::dvec3& v)
{
    return {v.x, 0, v.z};
}

glm::dvec3 towards(const glm::dvec3& from, const glm::dvec3& to, double most)
{
    const glm::dvec3 way = to - from;
    const double length = glm::length(way);
    return length <= most ? to : from + way * (most / length);
}

bool finite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Without what goes into the planes met so far: along one, along the crease of two, nowhere with three.
glm::dvec3 along(const glm::dvec3& motion, std::span<const glm::dvec3> planes)
{
    const auto free = [&](const glm::dvec3& way) {
        return std::ranges::all_of(planes, [&](const glm::dvec3& n) { return glm::dot(way, n) >= -1e-9; });
    };
    if (free(motion)) return motion;
    for (std::size_t i = planes.size(); i-- > 0;)
        if (const glm::dvec3 way = motion - planes[i] * std::min(0.0, glm::dot(motion, planes[i])); free(way)) return way;
    for (std::size_t i = planes.size(); i-- > 0;)
        for (std::size_t k = i; k-- > 0;) {
            const glm::dvec3 crease = glm::cross(planes[i], planes[k]);
            const double length = glm::dot(crease, crease);
            if (length < 1e-8) continue;
            if (const glm::dvec3 way = crease * (glm::dot(motion, crease) / length); free(way)) return way;
        }
    return {0, 0, 0};
}

} // namespace

Mover Walker::mover(double height) const
{
    const double radius = std::min(double(m_likes.radius), height / 2);
    if (m_likes.shape == io::PlayerShape::SweptBox) return {.half = {radius, height / 2, radius}};
    return {.radius = radius, .stem = height / 2 - radius};
}

glm::dvec3 Walker::wished(const Wish& wish, double speed) const
{
    const double sine = std::sin(m_yaw * kRadians), cosine = std::cos(m_yaw * kRadians);
    const glm::dvec2 move = glm::dot(wish.move, wish.move) > 1 ? glm::normalize(wish.move) : wish.move;
    return speed * glm::dvec3{move.x * cosine - move.y * sine, 0, -move.x * sine - move.y * cosine};
}

void Walker::gather(Surroundings& surroundings, const glm::dvec3& reach)
{
    const glm::dvec3 half = mover(m_likes.height).reach() + reach + 0.1, middle = m_feet + glm::dvec3{0, m_likes.height / 2.0, 0};
    m_things = &surroundings.find({middle - half, middle + half});
}

std::optional<Hit> Walker::first(const glm::dvec3& from, const glm::dvec3& motion) const
{
    std::optional<Hit> best;
    if (glm::dot(motion, motion) < 1e-18) return best;
    for (const Thing& thing : *m_things)
        if (auto hit = sweep(mover(), from, motion, thing); hit && (!best || hit->share < best->share)) best = hit;
    return best;
}

glm::dvec3 Walker::pushedOut(glm::dvec3 at) const
{
    for (int i = 0; i < 12; ++i) {
        std::optional<Contact> worst;
        for (const Thing& thing : *m_things)
            if (auto contact = contactOf(mover(), at, thing, kTouch * 0.75); contact && (!worst || contact->distance < worst->distance)) worst = contact;
        if (!worst) break;
        at += worst->normal * (kGap - worst->distance);
    }
    return at;
}

bool Walker::room(const glm::dvec3& at) const
{
    return std::ranges::none_of(*m_things, [&](const Thing& thing) { return contactOf(mover(), at, thing, 0).has_value(); });
}

double Walker::depth(Surroundings& surroundings) const
{
    const Mover shape = mover();
    double deepest = 0;
    for (const Thing& thing : surroundings.find({centre() - shape.reach(), centre() + shape.reach()}))
        if (const auto contact = contactOf(shape, centre(), thing, 0)) deepest = std::max(deepest, -contact->distance);
    return deepest;
}

glm::dvec3 Walker::lifted(const glm::dvec3& at, const io::Scene& scene) const
{
    const double feet = at.y - (centre().y - m_feet.y);
    const auto ground = io::groundHeight(scene, at.x, at.z);
    return ground && feet < *ground + kGap ? at + glm::dvec3{0, *ground + kGap - feet, 0} : at;
}

// The nearest place, further and further out and up, where the body fits.
void Walker::findRoom(Surroundings& surroundings)
{
    const glm::dvec3 start = centre();
    for (double reach = 0.25; reach < 24; reach *= 1.5)
        for (int up = 0; up < 3; ++up)
            for (int turn = 0; turn < 8; ++turn) {
                const double angle = turn * 45 * kRadians;
                const glm::dvec3 way = up == 2 ? glm::dvec3{0, 1, 0} : glm::normalize(glm::dvec3{std::cos(angle), up, std::sin(angle)});
                const glm::dvec3 place = lifted(start + way * reach, surroundings.scene());
                if (!room(place) || surroundings.buried(place)) continue;
                m_feet += place - start;
                return;
            }
}

void Walker::put(const glm::dvec3& feet, double yaw, double pitch, Surroundings& surroundings)
{
    m_feet = onMap(finite(feet) ? feet : glm::dvec3{0}, surroundings.scene());
    m_yaw = yaw;
    m_pitch = std::clamp(pitch, -kLooked, kLooked);
    m_velocity = {0, 0, 0};
    m_grounded = false;
    m_touched.clear();
    if (const auto ground = io::groundHeight(surroundings.scene(), m_feet.x, m_feet.z); ground && m_feet.y < *ground + kGap) m_feet.y = *ground + kGap;
    gather(surroundings, glm::dvec3{1});
    const glm::dvec3 out = pushedOut(centre());
    if (room(out) && !surroundings.buried(out) && lifted(out, surroundings.scene()) == out) {
        m_feet += out - centre();
    } else {
        gather(surroundings, glm::dvec3{50});
        findRoom(surroundings);
    }
    gather(surroundings, glm::dvec3{1});
    land(0.1);
    m_stood = m_stands = m_feet;
    m_standing = 0;
}

void Walker::carry(const glm::dmat4& moved, double turned, Surroundings& surroundings)
{
    const glm::dvec3 way = glm::dvec3{moved * glm::dvec4{m_feet, 1}} - m_feet;
    if (!finite(way)) return;
    m_yaw += turned;
    gather(surroundings, glm::abs(way) + 0.1);
    // What carries is under the feet: up, it pushes; along, nothing but other things stops.
    m_feet.y += std::max(0.0, way.y);
    m_feet += slide(centre(), {way.x, std::min(0.0, way.y), way.z}, {}, false).at - centre();
    m_feet += pushedOut(centre()) - centre();
}

void Walker::touch(const Hit& hit, const glm::dvec3& velocity)
{
    const Touched now{hit.thing->id, hit.contact.point, hit.contact.normal, std::max(0.0, -glm::dot(velocity, hit.contact.normal))};
    for (Touched& other : m_touched)
        if (other.id == now.id && glm::dot(other.normal, now.normal) > 0.999) return void(other.speed = std::max(other.speed, now.speed));
    m_touched.push_back(now);
}

std::optional<glm::dvec3> Walker::floorOf(const Hit& hit, double feet) const
{
    const double least = std::cos(m_likes.slope * kRadians) - 1e-6;
    const glm::dvec3& normal = hit.contact.normal;
    if (normal.y >= least) return normal;
    if (normal.y < 0.05) return std::nullopt;
    // On an edge: what is just beyond it? No more than a step above the feet.
    if (hit.contact.point.y - feet > m_likes.step + kGap) return std::nullopt;
    const Mover point{.radius = 0.002};
    const glm::dvec3 inwards = -glm::normalize(level(normal)) * 0.03, from = hit.contact.point + inwards + glm::dvec3{0, 0.06, 0};
    std::optional<Hit> best;
    for (const Thing& thing : *m_things)
        if (auto under = sweep(point, from, {0, -0.1, 0}, thing); under && (!best || under->share < best->share)) best = under;
    if (!best || best->contact.normal.y < least) return std::nullopt;
    return best->contact.normal;
}

Walker::Slid Walker::slide(glm::dvec3 at, glm::dvec3 motion, glm::dvec3 velocity, bool walking)
{
    const double least = std::cos(m_likes.slope * kRadians) - 1e-6;
    const glm::dvec3 wanted = motion;
    std::vector<glm::dvec3> planes;
    bool blocked = false;
    for (int i = 0; i < kSlides && glm::dot(motion, motion) > 1e-14; ++i) {
        const auto hit = first(at, motion);
        if (!hit) {
            at += motion;
            break;
        }
        at += motion * hit->share;
        motion *= 1 - hit->share;
        touch(*hit, velocity);
        glm::dvec3 plane = hit->contact.normal;
        const bool floor = plane.y >= least;
        if (walking && !floor) {
            // Neither up what is too steep nor down under what hangs over.
            blocked = true;
            const glm::dvec3 flat = level(plane);
            if (glm::dot(flat, flat) > 1e-6) plane = glm::normalize(flat);
        }
        std::erase_if(planes, [&](const glm::dvec3& other) { return glm::dot(plane, other) > 0.999; }); // the next piece of the same slope
        planes.push_back(plane);
        motion = along(motion, planes);
        // On a floor the way along it is as long seen from above.
        if (glm::dot(level(motion), level(wanted)) < 0 && walking) motion = {0, 0, 0};
        velocity = along(velocity, planes);
        if (walking && glm::dot(motion, motion) < 1e-14) velocity = {0, 0, 0}; // in a corner one stands, also in a wide one
    }
    return {pushedOut(at), velocity, blocked};
}

void Walker::land(double reach)
{
    m_grounded = false;
    m_ground = io::ObjectId::None;
    const glm::dvec3 at = centre();
    const auto hit = first(at, {0, -reach, 0});
    if (!hit) return;
    const glm::dvec3 down = at - glm::dvec3{0, reach * hit->share, 0};
    const auto floor = floorOf(*hit, down.y - m_height / 2);
    if (!floor) return;
    m_feet.y = down.y - m_height / 2;
    m_feet += pushedOut(centre()) - centre();
    m_grounded = true;
    m_groundNormal = *floor;
    m_ground = hit->thing->id;
    touch(*hit, m_velocity);
}

void Walker::look(const Wish& wish)
{
    m_yaw = std::remainder(m_yaw + (std::isfinite(wish.yaw) ? wish.yaw : 0), 360.0);
    m_pitch = std::clamp(m_pitch + (std::isfinite(wish.pitch) ? wish.pitch : 0), -kLooked, kLooked);
}

void Walker::crouch(const Wish& wish, Surroundings& surroundings)
{
    const bool wanted = wish.crouch && !m_flying && !m_swimming;
    if (wanted != m_crouching) {
        const double before = m_height;
        m_height = wanted ? std::min(m_likes.crouched, m_likes.height) : m_likes.height;
        gather(surroundings, glm::dvec3{0.2});
        if (!wanted && !room(centre())) m_height = before; // stays down under what is low
        else m_crouching = wanted;
    }
    const double eye = m_crouching ? m_likes.eyeHeight * double(m_likes.crouched) / m_likes.height : double(m_likes.eyeHeight);
    m_eye += std::clamp(eye - m_eye, -4 * kStep, 4 * kStep);
}

void Walker::fly(const Wish& wish)
{
    const double speed = m_likes.fly * (wish.run ? 4 : 1);
    const double pitch = m_pitch * kRadians;
    glm::dvec3 way = wished({.move = {wish.move.x, wish.move.y * std::cos(pitch)}}, speed);
    way.y = speed * (std::clamp(wish.move.y, -1.0, 1.0) * std::sin(pitch) + (wish.jump ? 1 : 0) - (wish.crouch ? 1 : 0));
    m_velocity = towards(m_velocity, way, 80 * kStep * std::max(1.0, speed / 16));
    m_feet += m_velocity * kStep;
    m_grounded = false;
    m_ground = io::ObjectId::None;
}

void Walker::walk(const Wish& wish)
{
    const double speed = m_crouching ? m_likes.creep : wish.run ? m_likes.run : m_likes.walk;
    m_velocity = towards(level(m_velocity), wished(wish, speed), kGrip * kStep);
    const glm::dvec3 from = centre();
    glm::dvec3 motion = m_velocity * kStep;
    motion.y = -glm::dot(level(m_groundNormal), motion) / std::max(m_groundNormal.y, 0.1);
    const Slid plain = slide(from, motion, m_velocity, true);
    Slid best = plain;
    if (plain.blocked && m_likes.step > 0) { // the same way a step higher
        const double rise = m_likes.step + kGap; // clear of a stair that is just as high
        const auto ceiling = first(from, {0, rise, 0});
        const double up = rise * (ceiling ? ceiling->share : 1.0);
        const Slid high = slide(from + glm::dvec3{0, up, 0}, level(motion), m_velocity, true);
        const auto under = first(high.at, {0, -up - 0.02, 0});
        const auto gone = [&](const glm::dvec3& at) { return glm::length(level(at - from)); };
        if (under && gone(high.at) > gone(plain.at) + 1e-4) {
            const glm::dvec3 down = high.at - glm::dvec3{0, (up + 0.02) * under->share, 0};
            if (floorOf(*under, m_feet.y)) best = {pushedOut(down), high.velocity, high.blocked};
        }
    }
    m_feet += best.at - from;
    m_velocity = level(best.velocity);
    const glm::dvec3 before = m_velocity;
    land(m_likes.step + kGap);
    if (!m_grounded) m_velocity = before;
}

void Walker::fall(const Wish& wish)
{
    const glm::dvec3 wanted = wished(wish, wish.run ? m_likes.run : m_likes.walk);
    if (glm::dot(wish.move, wish.move) > 0) {
        const glm::dvec3 steered = towards(level(m_velocity), wanted, kSteer * kStep);
        m_velocity = {steered.x, m_velocity.y, steered.z};
    }
    m_velocity.y -= kGravity * kStep;
    if (glm::length(m_velocity) > kFastest) m_velocity *= kFastest / glm::length(m_velocity);
    const glm::dvec3 from = centre();
    const Slid slid = slide(from, m_velocity * kStep, m_velocity, false);
    m_feet += slid.at - from;
    const bool rises = slid.velocity.y > 0.5;
    m_velocity = slid.velocity;
    if (!rises) land(2 * kGap);
    // Between steep walls one stands too, or would never get out.
    m_wedged = !m_grounded && glm::length(slid.at - from) < 0.002 && !m_touched.empty() ? m_wedged + 1 : 0;
    if (m_wedged >= kWedged) m_grounded = true, m_groundNormal = {0, 1, 0};
    if (m_grounded) m_velocity = level(m_velocity);
}

void Walker::swim(const Wish& wish)
{
    const double pitch = m_pitch * kRadians;
    glm::dvec3 way = wished({.move = {wish.move.x, wish.move.y * std::cos(pitch)}}, m_likes.swim * (wish.run ? 1.5 : 1));
    way.y = m_likes.swim * (std::clamp(wish.move.y, -1.0, 1.0) * std::sin(pitch) + (wish.jump ? 1 : 0) - (wish.crouch ? 1 : 0));
    m_velocity += (way - m_velocity) * std::min(1.0, kDrag * kStep);
    const glm::dvec3 from = centre();
    const Slid slid = slide(from, m_velocity * kStep, m_velocity, false);
    m_feet += slid.at - from;
    m_velocity = slid.velocity;
    m_grounded = false;
    m_ground = io::ObjectId::None;
}

glm::dvec3 Walker::onMap(glm::dvec3 feet, const io::Scene& scene) const
{
    const auto& map = scene.heights();
    if (!map) return feet;
    const glm::dvec2 low = map->origin, high = map->origin + glm::dvec2{map->size - 1} * double(map->metresPerTexel);
    const glm::dvec2 inside = glm::min(glm::dvec2{m_likes.radius + 0.1}, (high - low) / 2.0);
    const glm::dvec2 at = glm::clamp(glm::dvec2{feet.x, feet.z}, low + inside, high - inside);
    return {at.x, feet.y, at.y};
}

// Through a hole one gets under the ground, through the ground never.
void Walker::stayAboveGround(const glm::dvec3& before, const io::Scene& scene)
{
    const auto& heights = scene.heights();
    if (m_feet.y < (heights ? double(heights->min) : m_stood.y) - kLost) { // out of the world
        if (const auto ground = io::groundHeight(scene, m_feet.x, m_feet.z)) m_feet.y = *ground + kGap;
        else m_feet = m_stood;
        m_velocity = {0, 0, 0};
    }
    const auto was = io::groundHeight(scene, before.x, before.z), is = io::groundHeight(scene, m_feet.x, m_feet.z);
    if (was && is && before.y >= *was - 0.01 && m_feet.y < *is - 0.01) m_feet.y = *is + kGap;
}

void Walker::step(const Wish& wish, Surroundings& surroundings)
{
    m_touched.clear();
    const glm::dvec3 before = m_feet;
    look(wish);
    if (wish.fly) {
        m_flying = !m_flying;
        m_velocity = {0, 0, 0};
        if (!m_flying) return put(m_feet, m_yaw, m_pitch, surroundings);
    }
    crouch(wish, surroundings);
    if (m_flying) return fly(wish);
    const io::Water& water = surroundings.scene().environment().water;
    m_swimming = water.on && m_feet.y + kAfloat * m_height < water.level;
    const double speed = std::max(glm::length(m_velocity) + kGravity * kStep, std::max({double(m_likes.run), double(m_likes.walk), double(m_likes.swim)}));
    gather(surroundings, glm::dvec3{speed * kStep + m_likes.step});
    m_feet += pushedOut(centre()) - centre();
    if (m_swimming) {
        swim(wish);
    } else {
        if (m_grounded && wish.jump) {
            m_grounded = false;
            m_velocity.y = std::sqrt(2 * kGravity * m_likes.jump);
            m_wedged = 0;
        }
        if (m_grounded && m_wedged < kWedged) walk(wish);
        else fall(wish);
    }
    if (!finite(m_feet) || !finite(m_velocity)) m_feet = before, m_velocity = {0, 0, 0};
    stayAboveGround(before, surroundings.scene());
    if (m_grounded && ++m_standing % kFirm == 0) m_stood = std::exchange(m_stands, m_feet); // not the edge that it is about to fall off
    m_things = nullptr;
}

} // namespace play
