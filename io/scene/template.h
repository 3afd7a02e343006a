// A thing that can be placed: its model, how copies of it vary, and how the world meets it.
#pragma once

#include "io/scene/extra.h"

#include <glm/glm.hpp>
#include <string>

namespace io {

enum class Collision { None, Box, Mesh, Capsule };
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
    Footprint footprintShape = Footprint::Mesh; // the circle alone, or with it its bounds, or where its mesh meets the ground
    float footprint = 0;           // m, radius of the circle around it that grass keeps out of
    bool castShadow = true;
    bool impostor = false;         // drawn as a picture of itself where it is small
    DrawPath drawPath = DrawPath::Batched;
    float wind = 0;                // how freely it sways: 0 a rock, 1 a reed
    LightSource light;
    ParticleSource particles;
    Extra extra;

    bool operator==(const Template&) const = default;
};

} // namespace io
