// Footsteps: when a foot comes down, and what it comes down on.
#pragma once

#include "app/sound/sound.h"
#include "io/scene/ground_layers.h"

#include <memory>
#include <string>

namespace app {

class Footsteps {
public:
    // The file of a step that comes down now; empty: none does, or it makes no sound.
    std::string walk(const io::Scene& scene, const Feet& feet);
    // What a step there sounds like: the template's, else that of the layer of which most shows.
    std::string soundUnder(const io::Scene& scene, const Feet& feet);

private:
    const io::GroundLayers* layersOf(const io::Scene& scene);

    double m_left = 0.35; // m to the next step: the first comes soon
    std::unique_ptr<const io::GroundLayers> m_layers;
    // What they were made of; other ground makes them anew.
    std::shared_ptr<const io::HeightMap> m_heights;
    std::shared_ptr<const io::CoverMap> m_cover;
    std::vector<io::TerrainLayer> m_of;
};

double strideAt(float speed); // m from one step to the next

} // namespace app
