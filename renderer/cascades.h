// Where the shadow maps lie. Each cascade is a window onto a shadow map of the whole world that knows no edge: its texels
// stand still in the light's plane, and the texture holds those of the window, wrapped around (Tanner et al., "The
// Clipmap", 1998). So what the window keeps when it moves need not be drawn again, and shadows stand still while the camera
// moves. Cascades begin and end at distances from the eye rather than depths: nothing changes when the camera turns, and the
// sphere around a slice is hardly more than half as wide.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"
#include "io/scene/texel_rect.h"

#include <vector>

namespace renderer {

struct Cascade {
    double begin = 0, end = 0; // m from the eye
    double radius = 0;         // m, half the window's width
    double texel = 0;          // m
    int resolution = 0;        // texels, of window and texture
    io::Texel low{0};          // the window's first texel
    double bottom = 0;         // m towards the light, where depth is 1
    double depthRange = 0;     // m from there to where it is 0; what is nearer to the light is pressed onto that
    double penumbra = 0;       // texels to either side for each m to what blocks the light; 0: the same everywhere
    double contactReach = 0;   // m to what blocks the light that count of it
    glm::dmat4 textureFromRelative{1}; // to a texture that repeats, and depth: 0 towards the light, 1 away from it

    io::TexelRect window() const { return {low, low + std::int64_t(resolution)}; }
};

// Rows: the light's right, up and towards it.
glm::dmat3 lightAxes(const glm::dvec3& towardSun);

std::vector<double> cascadeEnds(const io::Shadows& shadows); // m, rising, one a cascade
double cascadeBlend(const io::Shadows& shadows);             // share of a cascade
float filterReach(const io::Shadows& shadows);               // half the filter's width, texels; at least 1

// `lightRadius` is half the light's apparent size, radians.
std::vector<Cascade> cascadesOf(const Eye& eye, const io::Shadows& shadows, const glm::dvec3& towardSun, double lightRadius);

// Part of a window that lies in one piece in the texture.
struct CascadePiece {
    glm::ivec2 at{0}, size{0};      // of the texture, texels
    glm::dmat4 clipFromRelative{1}; // to the whole texture
    Volume casters;                 // open towards the light
};
std::vector<CascadePiece> piecesOf(const Cascade& cascade, const io::TexelRect& part, const glm::dvec3& eye, const glm::dvec3& towardSun);

// The texels that the shadow of what is in a sphere can reach; empty where the map does not reach that deep.
io::TexelRect shadowOf(const Cascade& cascade, const glm::dvec4& sphere, const glm::dvec3& towardSun);

} // namespace renderer
