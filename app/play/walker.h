// Walker: the player's body. It walks, climbs stairs, slides along what it meets and down what is too steep, jumps, swims and flies,
// one fixed step at a time.
#pragma once

#include "app/play/surroundings.h"
#include "io/scene/template.h"

#include <optional>
#include <span>
#include <vector>

namespace play {

constexpr double kStep = 1.0 / 60; // s

// What the person wants for one step.
struct Wish {
    glm::dvec2 move{0};  // right, ahead: at most 1 long
    double yaw = 0, pitch = 0; // degrees that the head turns, left and up
    bool run = false, crouch = false, jump = false;
    bool fly = false;    // begins or ends it
};

struct Touched {
    io::ObjectId id = io::ObjectId::None; // None: the ground
    glm::dvec3 point{0}, normal{0, 1, 0};
    double speed = 0;                     // m/s, with which it was run into
};

class Walker {
public:
    explicit Walker(const io::PlayerStart& likes = {}) : m_likes{likes}, m_height{likes.height} {}

    // At a place and looking somewhere; out of whatever is there, out of the ground, and on the map.
    void put(const glm::dvec3& feet, double yaw, double pitch, Surroundings& surroundings);
    void step(const Wish& wish, Surroundings& surroundings);

    // By what the thing it stands on has moved since the last step.
    void carry(const glm::dmat4& moved, double turned, Surroundings& surroundings);

    const glm::dvec3& feet() const { return m_feet; }
    glm::dvec3 eye() const { return m_feet + glm::dvec3{0, m_eye, 0}; }
    const glm::dvec3& velocity() const { return m_velocity; }
    void setVelocity(const glm::dvec3& velocity) { m_velocity = velocity; }
    double yaw() const { return m_yaw; }
    double pitch() const { return m_pitch; }
    bool grounded() const { return m_grounded; }
    bool flying() const { return m_flying; }
    bool swimming() const { return m_swimming; }
    bool crouching() const { return m_crouching; }
    const glm::dvec3& groundNormal() const { return m_groundNormal; }
    io::ObjectId ground() const { return m_ground; } // that it stands on
    std::span<const Touched> touched() const { return m_touched; } // in the last step, each once
    const io::PlayerStart& likes() const { return m_likes; }
    Mover mover() const { return mover(m_height); }
    glm::dvec3 centre() const { return m_feet + glm::dvec3{0, m_height / 2, 0}; }
    double depth(Surroundings& surroundings) const; // m that it is inside of things; 0: nowhere

private:
    struct Slid {
        glm::dvec3 at, velocity;
        bool blocked = false; // by something that is no floor
    };
    Mover mover(double height) const;
    std::optional<Hit> first(const glm::dvec3& from, const glm::dvec3& motion) const;
    Slid slide(glm::dvec3 at, glm::dvec3 motion, glm::dvec3 velocity, bool walking);
    std::optional<glm::dvec3> floorOf(const Hit& hit, double feet) const; // its normal where one can stand on it, from there
    glm::dvec3 pushedOut(glm::dvec3 at) const;
    bool room(const glm::dvec3& at) const;
    void findRoom(Surroundings& surroundings);
    glm::dvec3 lifted(const glm::dvec3& centre, const io::Scene& scene) const; // onto the ground, where it is below
    void look(const Wish& wish);
    void crouch(const Wish& wish, Surroundings& surroundings);
    void fly(const Wish& wish);
    void walk(const Wish& wish);
    void fall(const Wish& wish);
    void swim(const Wish& wish);
    void land(double reach);
    void gather(Surroundings& surroundings, const glm::dvec3& reach);
    void stayAboveGround(const glm::dvec3& before, const io::Scene& scene);
    glm::dvec3 onMap(glm::dvec3 feet, const io::Scene& scene) const; // the nearest place there
    glm::dvec3 wished(const Wish& wish, double speed) const;
    void touch(const Hit& hit, const glm::dvec3& velocity);

    io::PlayerStart m_likes;
    glm::dvec3 m_feet{0}, m_velocity{0}, m_groundNormal{0, 1, 0};
    glm::dvec3 m_stood{0}, m_stands{0}; // where it stood a second ago or earlier, or began; what becomes that next
    int m_standing = 0;                 // steps that it has been on the ground since
    double m_yaw = 0, m_pitch = 0;
    double m_height = 1.8, m_eye = 1.68;
    bool m_grounded = false, m_flying = false, m_swimming = false, m_crouching = false;
    int m_wedged = 0; // steps in the air without getting anywhere
    io::ObjectId m_ground = io::ObjectId::None;
    std::vector<Touched> m_touched;
    const std::vector<Thing>* m_things = nullptr; // of this step
};

} // namespace play
