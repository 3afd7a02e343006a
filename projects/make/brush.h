// What the textures are painted with: strokes that taper and leaves with a midrib, laid one over another.
#pragma once

#include "projects/make/canvas.h"

#include <functional>

namespace make {

void lay(Texel& under, glm::vec3 colour, float coverage); // "over" compositing

struct Stroke {
    glm::vec2 from{0}, to{0}; // texels
    float widthFrom = 2;      // texels
    float widthTo = 2;
    glm::vec3 colourFrom{0};
    glm::vec3 colourTo{0};
    float height = 0; // texels that its middle rises above what lies under it
    bool tiles = false;
};
void paint(Canvas& canvas, const Stroke& stroke);

enum class Leaf { Oak, Birch, Beech, Simple };

struct LeafMark {
    Leaf kind = Leaf::Simple;
    glm::vec2 base{0}; // texels, where the stalk joins
    float angle = 0;   // radians, 0 points up the picture, positive to the right
    float length = 40; // texels
    float squash = 1;  // of the width: a leaf seen from the side
    glm::vec3 colour{0};
    float shade = 0.35f; // how much it darkens what lies under its edge
    bool tiles = false;
    float height = 0;
};
void paint(Canvas& canvas, const LeafMark& leaf);

// Half of a leaf's width at `t` from stalk (0) to tip (1), as a share of its length.
float halfWidth(Leaf kind, float t);

} // namespace make
