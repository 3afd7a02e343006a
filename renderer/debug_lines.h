// Lines that show what is not to be seen otherwise: boxes, and what a view sees.
#pragma once

#include "io/scene/bounds.h"
#include "renderer/eye.h"

#include <vector>

namespace renderer {

void addBox(std::vector<Line>& lines, const io::WorldBox& box, const glm::vec4& colour); // its twelve edges

// The edges of the eye's view, as far as `world` goes, with a frame at each power of ten metres. Faint where they are hidden.
void addFrustum(std::vector<Line>& lines, const Eye& eye, const io::WorldBox& world);

} // namespace renderer
