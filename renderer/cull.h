// Which instances a view sees, and at which levels of detail.
#pragma once

#include "io/scene/scene_tree.h"
#include "renderer/eye.h"
#include "renderer/shaders/shared/culling.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace renderer {

struct CullRequest {
    std::optional<Volume> volume;        // none: all are inside
    glm::dvec3 eye{0};
    std::optional<glm::dvec3> towardSun; // of a view by parallel light
    float smallestAngle = 0;             // radius / distance under which a thing is left out
    float smallestRadius = 0;            // m, the same for parallel light
    float errorAngle = 0;                // error / distance that a level of detail may have; 0: full models
    float errorLength = 0;               // m, the same for parallel light
    bool impostors = false;              // they will do
    float meshLeeway = 1;                // so many times as far may meshes err, but not impostors
    std::optional<glm::dvec3> sortedFor; // what blends; none: for the eye
    glsl::Wind wind{};                   // speed 0: nothing sways
    float swayAngle = 0;                 // way / distance under which sway is left out
    float swayLength = 0;                // m, the same for parallel light
    std::uint32_t required = 0;          // flags
    std::uint32_t refused = 0;
    const glsl::CullRecord* leftOut = nullptr; // the one thing that is not looked at; known to the CPU only
};
glsl::CullView cullView(const CullRequest& request, std::size_t instances);

glsl::CullRecord cullRecord(const glm::dvec3& centre, double radius, std::uint32_t model, std::uint32_t flags);

struct Seen {
    std::uint32_t drawn = 0; // an entry of the instance list, as shared/drawn.h packs it
    std::uint32_t bin = 0;   // of the model library
    std::uint32_t slot() const { return drawn & DRAWN_SLOT_MASK; }
};

using InstanceTree = io::SceneTree<std::uint32_t>; // of rows or slots

struct CullScene {
    std::span<const glsl::CullRecord> records; // by slot
    std::span<const glsl::CullModel> models;
    const InstanceTree* tree = nullptr; // where there is one, cost follows what is inside
};

// One that fades is there twice. Answers the instances that passed each test.
glsl::CullCounts cull(const CullScene& scene, const CullRequest& request, std::vector<Seen>& seen);
void addTo(glsl::CullCounts& sum, const glsl::CullCounts& more);

} // namespace renderer
