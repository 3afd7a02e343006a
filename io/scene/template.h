// A thing that can be placed: its model, how copies of it vary, and how the world meets it.
#pragma once

#include "io/scene/extra.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace io {

enum class Collision { None, Box, Mesh, Capsule, Hull }; // box and capsule of the model's bounds, its convex hull
enum class Footprint { None, Radius, Box, Mesh }; // what grass keeps out of
enum class LightKind { None, Point, Spot };
enum class ParticleKind { None, Fire, Smoke, Dust };
enum class DrawPath { Batched, Direct }; // shared buffers, or buffers of its own that can be unloaded alone

// A lamp that each copy carries. It shines along the model's -Z, as glTF's do.
struct LightSource {
    LightKind kind = LightKind::None;
    glm::vec3 colour{1, 0.75f, 0.45f}; // linear
    float intensity = 1;               // irradiance a metre away, where the sun's above the air is 1
    float range = 15;                  // m, where it has faded out
    float inner = 20, outer = 35;      // degrees from the axis, where a spot begins to fade and ends
    glm::vec3 offset{0};               // m, in the model's space
    bool castShadow = false;
    bool operator==(const LightSource&) const = default;
};

// What each copy gives off.
struct ParticleSource {
    ParticleKind kind = ParticleKind::None;
    float rate = 20;        // particles a second
    float life = 2;         // s
    float size = 0.5f;      // m, of a grown one
    float rise = 1;         // m/s, upwards where they begin
    float spread = 0.3f;    // m, around the place where they begin
    glm::vec3 colour{1};    // factor
    glm::vec3 offset{0};    // m, in the model's space
    bool operator==(const ParticleSource&) const = default;
};

// How a thing moves by itself while somebody plays.
struct Body {
    bool dynamic = false; // falls, and is pushed about
    float mass = 25;      // kg
    float friction = 0.6f;
    float bounce = 0.1f;  // share of the speed that comes back
    bool operator==(const Body&) const = default;
};

enum class SoundGroup { Effects, Ambience, Music, Steps };
enum class SoundWeather { Any, Dry, Wet, Storm };

// How loud a sound is on its way to silence: straight lines between these.
struct FalloffKey {
    float at = 0;    // share of the radius, 0..1, rising
    float level = 1; // 0..1
    bool operator==(const FalloffKey&) const = default;
};

// What each copy lets hear.
struct SoundSource {
    std::string file;    // sounds/….wav, .ogg or .flac inside the project; empty: silent
    SoundGroup group = SoundGroup::Effects;
    float volume = 1;    // factor of the amplitude
    float radius = 20;   // m from its place, where it has gone silent
    std::vector<FalloffKey> falloff; // empty: 1 - at, squared
    bool loop = true;
    bool flat = false;       // as loud in both ears, as music and the sound of a whole wood are
    bool occluded = true;    // muffled by what stands before it
    glm::vec2 hours{0, 24};  // of the day, when it is heard; over midnight if the first is the later
    SoundWeather weather = SoundWeather::Any; // dry: no rain or snow, storm: wind over 12 m/s as well
    glm::vec3 offset{0};     // m, in the model's space
    bool operator==(const SoundSource&) const = default;
};

enum class TriggerShape { None, Box, Sphere };
enum class TriggerDo { PlaySound, ComeToLook, Show, Hide, Teleport, Message };

struct TriggerAction {
    TriggerDo action = TriggerDo::Message;
    std::string what;    // the file of a sound, the name of a look, of the object or group, or where to go: a camera's; the message
    float seconds = 4;   // that a look takes to come, or a message stays
    bool operator==(const TriggerAction&) const = default;
};

// A place around each copy that does something when the player comes into it.
struct Trigger {
    TriggerShape shape = TriggerShape::None;
    glm::vec3 size{4};   // m, edges of a box; the first is a sphere's diameter. Times the copy's scale
    bool once = false;
    std::vector<TriggerAction> actions;
    bool operator==(const Trigger&) const = default;
};

enum class PlayerShape { Capsule, SweptBox };
enum class PlayerEye { First, Third };

// A copy of a template with `start` is where the player begins, and says what the player is like.
struct PlayerStart {
    bool start = false;
    PlayerShape shape = PlayerShape::Capsule;
    PlayerEye eye = PlayerEye::First;
    float height = 1.8f;     // m
    float radius = 0.3f;     // m
    float eyeHeight = 1.68f; // m above the feet
    float crouched = 1.1f;   // m, height while crouching
    glm::vec3 camera{0};     // m right of, above and ahead of the eye, where the camera is fixed; it turns with the player
    float behind = 3.5f;     // m, from there to the camera of the third person
    float walk = 2.2f;       // m/s
    float run = 5.5f;
    float creep = 1.1f;      // crouched
    float swim = 1.6f;
    float fly = 16;
    float jump = 1.1f;       // m, how high
    float step = 0.4f;       // m, the highest stair
    float slope = 46;        // degrees, the steepest ground to stand on
    float mass = 80;         // kg, with which things are pushed
    bool operator==(const PlayerStart&) const = default;
};

struct Template {
    std::string name;     // unique in its project; the stem of its file, templates/NAME.json
    std::string category; // the heading it stands under in the Templates panel, as "Trees"
    std::string model;    // models/….glb inside the project; empty: a marker, drawn as a box of `markerSize`
    glm::vec3 markerSize{1};       // m
    glm::vec2 yaw{0, 360};         // degrees, range from which a placed copy draws its turn
    glm::vec2 scale{1};            // factors, range from which a placed copy draws its size
    float tilt = 0;                // degrees, the most a copy leans at random
    bool alignToGround = false;    // its up axis follows the surface under it
    float sink = 0;                // m below the surface, so that roots and rocks sit in the ground
    Collision collision = Collision::Mesh;
    Body body;
    std::string steps;             // sounds/…, of feet on it; empty: the ground's
    Footprint footprintShape = Footprint::Mesh; // the circle alone, or with it its bounds, or where its mesh meets the ground
    float footprint = 0;           // m, radius of the circle around it that grass keeps out of
    bool castShadow = true;
    bool impostor = false;         // drawn as a picture of itself where it is small
    DrawPath drawPath = DrawPath::Batched;
    float wind = 0;                // how freely it sways: 0 a rock, 1 a reed
    LightSource light;
    ParticleSource particles;
    SoundSource sound;
    Trigger trigger;
    PlayerStart player;
    Extra extra;

    bool operator==(const Template&) const = default;
};

} // namespace io
