// Bodies: what falls, rolls and is pushed while somebody plays: objects whose template says `body.dynamic` (planted instances of
// one stand still). The mass that a template says is that of a copy of scale 1; it grows with the copy's volume.
//
// Only what is near the player moves: within kNear of it; what comes to be farther than kFar away freezes where it is, in the air too,
// and goes on when the player is near again. Of more than kMost at once the nearest ones move. What has come to rest, or stood
// on the ground from the beginning, sleeps until something touches it, and costs next to nothing; what is far away costs nothing.
#pragma once

#include "app/play/obstacles.h"
#include "app/play/walker.h"
#include "io/scene/moved.h"

#include <utility>

namespace play {

class Bodies {
public:
    static constexpr double kNear = 64, kFar = 80; // m, as seen from above
    static constexpr std::size_t kMost = 1024;

    explicit Bodies(Surroundings& surroundings); // must outlive it
    ~Bodies();

    void follow(io::ObjectId id); // an object came or went otherwise than by step()
    void step(const Walker& walker);

    const std::vector<io::Moved>& moved() const { return m_moved; } // in the last step, in the order of ids

    bool holds(io::ObjectId id) const { return find(id) != nullptr; }
    std::size_t awake() const;  // bodies that move
    double depth(io::ObjectId id); // m that it is inside of something, as Bullet saw it last
    void wake(io::ObjectId id);    // as by a touch
    void setVelocity(io::ObjectId id, const glm::dvec3& velocity); // m/s; of one near the player

    // Somebody of that mass ran into it, as equals do that then go on together; answers the speed (m/s) with which they go on.
    double push(const Touched& touched, double feet, double mass);
    void weigh(io::ObjectId id, const glm::dvec3& at, double mass); // somebody stands on it

private:
    struct Body;
    struct World;
    const Body* find(io::ObjectId id) const;
    Body* find(io::ObjectId id) { return const_cast<Body*>(std::as_const(*this).find(id)); }
    void add(const io::Object& object);
    void comeAndGo(const glm::dvec3& around);
    void join(Body& body);
    bool standsOnGround(const Body& body) const;
    void leave(Body& body);
    void changedAround(io::ObjectId id, const io::WorldBox& box);
    void placePlayer(const Walker& walker);
    void lookAround(Body& body);
    void keepOut(Body& body, const glm::dvec3& before);
    void note(Body& body);

    Surroundings& m_surroundings;
    std::unique_ptr<World> m_world;
    std::unique_ptr<Obstacles> m_obstacles;
    std::vector<std::unique_ptr<Body>> m_bodies; // in the order of ids
    std::vector<Body*> m_present;                // those that can move, likewise
    std::vector<io::Moved> m_moved;
    std::vector<io::ObjectId> m_lost;
    glm::dvec3 m_lookedFrom{0};
    long m_steps = 0;
};

} // namespace play
