// Where the shadow maps lie. Each cascade is a window onto a shadow map of the whole world that knows no edge: its texels
// stand still in the light's plane, and the texture holds those of the window, wrapped around (Tanner et al., "The
// Clipmap", 1998). So what the window keeps when it moves need not be drawn again, and shadows stand still while the camera
// moves and turns.
#pragma once

#include "io/scene/environment.h"
#include "renderer/eye.h"
#include "io/scene/texel_rect.h"

#include <vector>

namespace renderer {

struct Cascade {
    double beginDepth = 0, endDepth = 0; // m along the camera's axis
    double radius = 0;                   // m, half the window's width
    double texel = 0;                    // m
    int resolution = 0;                  // texels, of window and texture
    io::Texel low{0};                        // the window's first texel
    double middle = 0;                   // m towards the sun, where depth is one half
    glm::dmat4 textureFromRelative{1};   // to a texture that repeats, and depth: 0 towards the sun, 1 away from it

    io::TexelRect window() const { return {low, low + std::int64_t(resolution)}; }
};

// Rows: the light's right, up and towards the sun.
glm::dmat3 lightAxes(const glm::dvec3& towardSun);

std::vector<double> cascadeEnds(const io::Shadows& shadows); // m, one a cascade

std::vector<Cascade> cascadesOf(const Eye& eye, const io::Shadows& shadows, const glm::dvec3& towardSun);

// Part of a window that lies in one piece in the texture.
struct CascadePiece {
    glm::ivec2 at{0}, size{0};      // of the texture, texels
    glm::dmat4 clipFromRelative{1}; // to the whole texture
    Volume casters;                 // open towards the sun
};
std::vector<CascadePiece> piecesOf(const Cascade& cascade, const io::TexelRect& part, const glm::dvec3& eye, const glm::dvec3& towardSun);

// The texels that the shadow of what is in a sphere can reach; empty where the map does not reach that deep.
io::TexelRect shadowOf(const Cascade& cascade, const glm::dvec4& sphere, const glm::dvec3& towardSun);

} // namespace renderer
