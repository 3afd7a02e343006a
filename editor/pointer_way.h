// Where the pointer went within a frame. ImGui 1.86 only tells where it is at the end of one, and a stroke that is drawn slowly would be cut to
// straight pieces.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace editor {

void setPointerWay(std::vector<glm::dvec2> points); // by the program around the editor, before each frame
std::span<const glm::dvec2> pointerWay();           // ImGui's coordinates, in their order, before where it is now

} // namespace editor
