// A scatter layer: what grows where, as rules and settings. Its instances: io/scene/instances.h.
#pragma once

#include "io/scene/extra.h"
#include "io/scene/ids.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace io {

constexpr std::size_t kMostSpecies = 256; // an instance names its own in a byte

struct Species {
    std::string templateName; // by name, as a template may be missing
    float weight = 1;         // share of it among those of its layer
    glm::vec2 scale{1};       // factors, in addition to the layer's
    float spacing = 0;        // m, the least between two of this species
    Extra extra;
    bool operator==(const Species&) const = default;
};

struct ScatterLayer {
    ScatterId id = ScatterId::None;
    std::string name;            // unique in its scene
    bool rule = false;           // instances follow from what is below and the ground, but for those that a person painted or erased
    std::vector<Species> species;
    float density = 0.1f;        // instances per m2, before the rules take from it
    float spacing = 2;           // m, the least between two of the layer (Poisson)
    glm::vec2 scale{0.8f, 1.2f}; // factors
    glm::vec2 yaw{0, 360};       // degrees
    float tilt = 0;              // degrees, the most that it leans at random
    float sink = 0;              // m below the surface
    float align = 0;             // 0 upright, 1 along the surface's normal
    glm::vec2 slope{0, 35};      // degrees from level
    glm::vec2 altitude{-1e5f, 1e5f}; // m
    std::string ground;          // only where this terrain layer shows; empty: anywhere
    float clearance = 0;         // m, to the footprints of objects and of other layers' plants
    bool meshes = false;         // also on top of objects, not on the ground alone
    bool shown = true;           // drawn and picked
    std::uint32_t seed = 1;
    Extra extra;
    bool operator==(const ScatterLayer&) const = default;
};

} // namespace io
