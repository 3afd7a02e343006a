// Sun, moon and stars of a frame, and which of them lights surfaces.
#pragma once

#include "io/scene/celestial.h"
#include "renderer/shaders/shared/atmosphere.h"
#include "renderer/shaders/shared/heavens.h"

namespace renderer {

// Night is brighter here than it is: a full moon gives a 400,000th of the sun's light, and no exposure shows both. Its light on
// surfaces and the glow of the sky are as an eye that is used to the dark finds them beside a day at the same exposure. The
// sky's own radiance stays what it is until the sun stands 6 degrees below the horizon, overhead until 18.
struct Bodies {
    glm::dvec3 towardSun{0, 1, 0};
    io::MoonPlace moon;
    glm::vec3 moonlight{0};     // irradiance outside the air; 0 while the sun is too near the horizon
    double night = 0;           // for surfaces: grows until the sun is 8 degrees below the horizon
    double glow = 0;            // of the sky along the horizon and of stars: grows from 6 to 11 degrees
    double deepNight = 0;       // overhead: from 18 to 22
    bool moonLights = false;    // rather than the sun
    glm::dvec3 towardLight() const { return moonLights ? moon.toward : towardSun; }
};
Bodies bodiesOf(const io::Environment& environment);

// The nearest of directions that stand about 0.05 degrees apart. Shadows are drawn for those: else all their edges would
// shimmer, and all maps be drawn, in each frame of a running day.
glm::dvec3 inSteps(const glm::dvec3& direction);

glm::vec3 nightOnSurfaces(const Bodies& bodies); // radiance from all around, about: what shapes are seen by

glsl::Heavens heavensOf(const io::Environment& environment, const Bodies& bodies);

// How bright a moon of a phase is beside a full one (Allen, Astrophysical Quantities, as in Krisciunas and Schaefer 1991).
double moonPhaseLight(double phase);

} // namespace renderer
