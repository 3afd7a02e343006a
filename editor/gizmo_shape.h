// The gizmo's handles on the screen: where their strokes and areas lie, which one a pixel hits, how far a ring turned.
#pragma once

#include "editor/gizmo.h"

namespace editor {

inline glm::dvec3 unitAxis(int axis)
{
    return {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
}
int axisOf(GizmoHandle handle);        // 0, 1, 2 of X, Y, Z; -1
int planeNormalOf(GizmoHandle handle); // of YZ, ZX, XY the axis that they leave out; -1

// Metres that a pixel covers at that point; 0 when it is not in front of the eye.
double metresPerPixel(const View& view, const glm::dvec3& point);

std::vector<GizmoShape> gizmoShapes(GizmoMode mode, const View& view, const GizmoFrame& frame);
GizmoHandle hitHandle(std::span<const GizmoShape> shapes, glm::dvec2 pixel, double reach);

// Degrees that a drag from one pixel to another turns about the axis. `grabbed` is the point taken hold of: where a
// ring is seen edge-on, the drag along its tangent there counts.
double turnedBy(const View& view, const glm::dvec3& pivot, const glm::dvec3& axis, const glm::dvec3& grabbed,
                glm::dvec2 from, glm::dvec2 to);

} // namespace editor
