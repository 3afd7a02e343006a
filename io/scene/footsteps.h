// Footsteps: when a foot comes down, and what it comes down on.
#pragma once

#include "io/scene/ground_layers.h"
#include "io/scene/scene.h"

#include <memory>
#include <string>

namespace io {

struct Feet {
    glm::dvec3 at{0};  // m
    double walked = 0; // m over ground since the last time; 0 in the air, in water and at rest
    float speed = 0;   // m/s
    TemplateId on = TemplateId::None; // what they stand on; None: the ground
};

class Footsteps {
public:
    // The file of a step that comes down now; empty: none does, or it makes no sound.
    std::string walk(const Scene& scene, const Feet& feet);
    // What a step there sounds like: the template's, else that of the layer of which most shows.
    std::string soundUnder(const Scene& scene, const Feet& feet);

private:
    const GroundLayers* layersOf(const Scene& scene);

    double m_left = 0.35; // m to the next step: the first comes soon
    std::unique_ptr<const GroundLayers> m_layers;
    // What they were made of; other ground makes them anew.
    std::shared_ptr<const HeightMap> m_heights;
    std::shared_ptr<const CoverMap> m_cover;
    std::vector<TerrainLayer> m_of;
};

double strideAt(float speed); // m from one step to the next

} // namespace io
