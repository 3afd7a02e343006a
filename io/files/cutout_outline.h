// Polygons around what is opaque of a picture of leaves, so that less of what is all transparent need be drawn (as
// particles are trimmed: Persson, "Graphics Gems for Games", SIGGRAPH 2011 courses).
#pragma once

#include "io/scene/image.h"

#include <glm/glm.hpp>
#include <vector>

namespace io {

using Polygon = std::vector<glm::vec2>; // corners in turn, the inside to their left

float areaOf(const Polygon& polygon); // negative when the inside lies to the right

bool hasAlpha(const Image& image);

struct OutlineRequest {
    glm::vec2 min{0}, max{1}; // the part of the picture, in texture coordinates: u to the right, v down, 0 to 1
    float cutoff = 0.5f;      // texels count whose alpha is at least this
    float margin = 0;         // kept around them, in texture coordinates
    float corner = 0.05f;     // share of the part's area that one more corner has to save
};

// Convex, around all texels that count and inside of min and max; near the least of area and corners. Empty when no texel
// counts.
Polygon cutoutOutline(const Image& image, const OutlineRequest& request);

} // namespace io
