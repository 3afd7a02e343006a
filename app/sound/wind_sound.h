// How the wind sounds at an ear: by its speed, by how high the ear is over the land, and by the storm.
#pragma once

#include "io/scene/scene.h"

namespace app {

struct WindSound {
    float level = 0;   // 0..1
    float pitch = 1;   // factor
    float treble = 1;  // share of what hisses, 0..1
};
WindSound windAt(const io::Scene& scene, const io::Environment& environment, const glm::dvec3& ear, double seconds);

// m above the land round about, which a ridge is and a hollow is not; at least 1.
double exposedHeight(const io::Scene& scene, const glm::dvec3& ear);

} // namespace app
