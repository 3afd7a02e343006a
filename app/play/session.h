// Session: playing a world. It has a copy of the scene beside the document's, steps it, and says what a mirror of it must follow.
// The document is never touched.
#pragma once

#include "app/play/bodies.h"
#include "app/play/controls.h"
#include "app/play/walker.h"
#include "io/scene/camera.h"
#include "io/scene/footsteps.h"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace play {

// What the program around it is asked to do.
struct Event {
    enum class Kind { Sound, Step, Look, Message }; // a step: of feet, which app/sound hears by itself
    Kind kind = Kind::Message;
    std::string what;  // file, name of the look, text
    float seconds = 0; // that a look takes, or a message stays
    glm::dvec3 at{0};  // m, of a sound
};

class Session {
public:
    // From the first start marker of the scene, if that is asked for and there is one, else from the camera. The assets must outlive it.
    Session(const io::Scene& scene, const io::Assets& assets, const io::Camera& camera, bool fromMarker = true);

    void step(const Wish& wish, bool otherEye = false);

    const io::Scene& scene() const { return m_scene; }
    const Walker& walker() const { return m_walker; }
    io::TemplateId standsOn() const; // the thing's, planted or not; None: the ground's, or nothing
    Surroundings& surroundings() { return m_surroundings; }
    Bodies& bodies() { return m_bodies; }
    const Bodies& bodies() const { return m_bodies; }
    const std::vector<Event>& events() const { return m_events; } // of the last step
    long steps() const { return m_steps; }
    double walked() const { return m_walked; } // m on the ground in the last step, by itself: what carries it does not count
    bool changed(io::ObjectId id) const; // whether it stands otherwise than in the document: hidden, or moved
    io::Camera camera(double share = 1) const; // between the last two steps
    std::vector<io::Moved> between(double share) const; // where bodies are that moved in the last step
    io::Changes takeChanges();                 // of the scene, since the last call
    // What stands otherwise than in the document: as it was, and as it is now, or nothing where it is hidden. In the order of ids.
    std::vector<std::pair<io::Object, std::optional<io::Object>>> left() const;
    io::Changes differences() const;           // between the scene and the document's: a mirror shows that again after these

private:
    struct Place { // of a trigger
        io::ObjectId id;
        std::optional<io::Object> planted = {}; // of an instance, which stays where it is
        bool inside = false, done = false;
    };
    void change(io::ObjectId id, std::optional<io::Object> object);
    void stand(); // notes where what the player stands on is
    void carry(); // the player by what that has moved since
    void push();
    void moveBodies();
    void findTriggers();
    void trigger();
    bool meets(const io::Object& object, const io::Trigger& trigger) const; // on the way of this step
    void act(const io::TriggerAction& action, const glm::dvec3& at);
    void show(const std::string& name, bool shown);
    void stepSounds(double walked);
    io::Camera eye(const glm::dvec3& at) const;
    void standBehind();
    double free(const glm::dvec3& from, const glm::dvec3& way); // share of it that a camera can go
    glm::dvec3 fixedAt(); // m from the eye, in the world: where the camera is fixed to the player

    io::Scene m_scene;
    io::Camera m_begin;
    Surroundings m_surroundings;
    Bodies m_bodies;
    Walker m_walker;
    std::vector<Place> m_triggers;
    std::vector<Event> m_events;
    std::unordered_map<std::uint32_t, std::optional<io::Object>> m_original; // what the document holds of what changed
    std::vector<io::Object> m_hidden;
    io::Changes m_changes;
    struct Way {
        io::ObjectId id = io::ObjectId::None;
        io::Transform from, to;
    };
    std::vector<Way> m_ways; // of bodies in the last step
    std::size_t m_most = 4096; // of m_changes, before repeated ones are looked for
    io::ObjectId m_stoodOn = io::ObjectId::None;
    io::Transform m_stoodAt;
    glm::dvec3 m_eyeBefore{0}, m_eyeNow{0}; // where the camera is fixed
    glm::dvec3 m_centreBefore{0}; // of the player, before this step
    double m_behindBefore = 0, m_behindNow = 0; // m, from the eye to the camera of the third person
    io::Footsteps m_feet;
    bool m_third = false;
    long m_steps = 0;
    double m_walked = 0;
};

// One JSON object: step, position, velocity, grounded, contacts, sounds, and of what moved by itself id, position and rotation.
std::string traceLine(const Session& session);

} // namespace play
