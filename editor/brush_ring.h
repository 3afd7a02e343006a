// The ring that shows where a brush falls.
#pragma once

#include "io/scene/height_map.h"
#include "renderer/renderer.h"

#include <vector>

namespace editor {

// A circle that lies on the ground (null, and beside it: level), a little above it so that it is seen whole from afar.
void addRing(std::vector<renderer::Line>& lines, const io::HeightMap* map, const glm::dvec3& eye, const glm::dvec3& middle, double radius, const glm::vec4& colour);

} // namespace editor
