// Lines that show what is not to be seen otherwise: boxes, and what a view sees.
#pragma once

#include "io/scene/bounds.h"
#include "renderer/cascades.h"
#include "renderer/cull.h"
#include "renderer/lamps.h"

#include <optional>
#include <span>
#include <vector>

namespace renderer {

void addBox(std::vector<Line>& lines, const io::WorldBox& box, const glm::vec4& colour); // its twelve edges

void addBox(std::vector<Line>& lines, const glm::dvec3& middle, const glm::dmat3& halfAxes, const glm::vec4& colour); // turned
void addSphere(std::vector<Line>& lines, const glm::dvec3& middle, double radius, const glm::vec4& colour); // three circles

// How far a lamp reaches: three circles at its range, or a spot's cone with the circle where it begins to fade.
void addLamp(std::vector<Line>& lines, const Lamp& lamp, const glm::vec4& colour);

// The edges of the eye's view, as far as `world` goes, with a frame at each power of ten metres. Faint where they are hidden.
void addFrustum(std::vector<Line>& lines, const Eye& eye, const io::WorldBox& world);

// Boxes of the trees' nodes that the eye sees and that look largest from there, coloured by depth, leaves strongly; a ring runs
// around those that split in height. Faint where `culledTo`, if there is one, does not reach.
void addNodes(std::vector<Line>& lines, std::span<const InstanceTree* const> trees, const Eye& eye,
              const std::optional<Volume>& culledTo);

// The boxes of what an eye's cascades hold, in the cascades' colours, and the ends of its slices. Faint where they are hidden,
// and all of them faint unless `strong`.
void addCascades(std::vector<Line>& lines, std::span<const Cascade> cascades, const Eye& eye, const glm::dvec3& towardSun, bool strong);

} // namespace renderer
