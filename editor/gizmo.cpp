#include "editor/gizmo.h"

#include "editor/gizmo_shape.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr double kFarthest = 1e7;     // m, of any coordinate
constexpr double kLeastFactor = 0.01; // of a scale drag
constexpr float kLeastScale = 1e-6f, kMostScale = 1e6f;
constexpr double kEdgeOn = 0.05; // sine of the angle between a ray and a plane below which it says nothing

bool finite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double snapped(double value, double step)
{
    return step > 0 ? std::round(value / step) * step : value;
}

// Where the ray through the pixel meets the plane; nothing when it is edge-on or behind.
std::optional<glm::dvec3> onPlane(const View& view, glm::dvec2 pixel, const glm::dvec3& point, const glm::dvec3& normal)
{
    const io::Ray ray = rayThrough(view, pixel);
    const double fall = glm::dot(ray.direction, normal);
    if (!(std::abs(fall) > kEdgeOn * glm::length(normal))) return std::nullopt;
    const double t = glm::dot(point - ray.origin, normal) / fall;
    if (!(t > 0 && t < kFarthest)) return std::nullopt;
    const glm::dvec3 hit = ray.origin + ray.direction * t;
    return finite(hit) ? std::optional{hit} : std::nullopt;
}

// The plane in which a handle is dragged: for an axis, the one through it that faces the eye most.
glm::dvec3 dragNormal(const View& view, const GizmoFrame& frame, GizmoHandle handle)
{
    const glm::dvec3 sight = frame.pivot - view.camera.eye;
    if (const int normal = planeNormalOf(handle); normal >= 0) return frame.axes * unitAxis(normal);
    if (const int axis = axisOf(handle); axis >= 0) {
        const glm::dvec3 along = frame.axes * unitAxis(axis);
        const glm::dvec3 facing = glm::cross(along, glm::cross(glm::normalize(sight), along));
        if (glm::length(facing) > 1e-6) return glm::normalize(facing);
    }
    return -io::forward(view.camera);
}

// Keeps of a delta in the gizmo's axes what the handle moves.
glm::dvec3 masked(GizmoHandle handle, glm::dvec3 delta)
{
    const int axis = axisOf(handle), normal = planeNormalOf(handle);
    for (int i = 0; i < 3; ++i)
        if ((axis >= 0 && i != axis) || i == normal) delta[i] = 0;
    return delta;
}

bool sound(const io::Transform& transform)
{
    return finite(transform.position) && finite(glm::dvec3{transform.rotation}) &&
           finite(glm::dvec3{transform.scale}) &&
           glm::all(glm::lessThanEqual(glm::abs(transform.position), glm::dvec3{kFarthest}));
}

float scaledBy(float scale, double factor)
{
    const double size = glm::clamp(std::abs(double(scale) * factor), double(kLeastScale), double(kMostScale));
    return float(scale < 0 ? -size : size);
}

} // namespace

std::optional<GizmoFrame> Gizmo::frame(std::span<const io::Transform> transforms) const
{
    if (transforms.empty()) return std::nullopt;
    GizmoFrame result{.pivot = transforms.back().position};
    if (pivot == GizmoPivot::Median) {
        result.pivot = glm::dvec3{0};
        for (const io::Transform& transform : transforms)
            result.pivot += transform.position / double(transforms.size());
    }
    // A scale along the world's axes would shear what is turned, so scaling always follows the object.
    if (space == GizmoSpace::Local || mode == GizmoMode::Scale)
        result.axes = io::orientation(transforms.back().rotation);
    return result;
}

std::vector<GizmoShape> Gizmo::shapes(const View& view, const GizmoFrame& frame) const
{
    std::vector<GizmoShape> shapes = gizmoShapes(mode, view, frame);
    const GizmoHandle lit = m_drag ? m_drag->handle : m_hovered;
    for (GizmoShape& shape : shapes)
        shape.hovered = shape.handle == lit && lit != GizmoHandle::None;
    return shapes;
}

GizmoHandle Gizmo::hit(const View& view, const GizmoFrame& frame, glm::dvec2 pixel) const
{
    return hitHandle(gizmoShapes(mode, view, frame), pixel, kReach);
}

bool Gizmo::begin(const View& view, GizmoHandle handle, glm::dvec2 pixel, std::vector<io::Transform> start)
{
    const std::optional<GizmoFrame> at = frame(start);
    if (!at || handle == GizmoHandle::None || metresPerPixel(view, at->pivot) <= 0) return false;
    m_drag = Drag{.handle = handle, .pixel = pixel, .lastPixel = pixel, .frame = *at, .start = std::move(start)};
    m_drag->grabbed = onPlane(view, pixel, at->pivot, dragNormal(view, *at, handle)).value_or(at->pivot);
    if (mode == GizmoMode::Scale) m_drag->amount = glm::dvec3{1};
    return true;
}

std::vector<io::Transform> Gizmo::update(const View& view, glm::dvec2 pixel, bool snapping)
{
    if (!m_drag) return {};
    std::vector<io::Transform> result = mode == GizmoMode::Translate ? translated(view, pixel, snapping)
                                        : mode == GizmoMode::Rotate  ? rotated(view, pixel, snapping)
                                                                     : scaled(view, pixel, snapping);
    m_drag->lastPixel = pixel;
    return std::ranges::all_of(result, sound) ? result : m_drag->start;
}

GizmoFrame Gizmo::activeFrame() const
{
    if (!m_drag) return {};
    GizmoFrame now = m_drag->frame;
    if (mode == GizmoMode::Translate) now.pivot += now.axes * m_drag->amount;
    return now;
}

std::vector<io::Transform> Gizmo::translated(const View& view, glm::dvec2 pixel, bool snapping)
{
    Drag& drag = *m_drag;
    std::vector<io::Transform> result = drag.start;
    if (const auto now = onPlane(view, pixel, drag.grabbed, dragNormal(view, drag.frame, drag.handle))) {
        const glm::dvec3 delta = glm::inverse(drag.frame.axes) * (*now - drag.grabbed);
        drag.amount = masked(drag.handle, delta);
        if (snapping)
            for (int axis = 0; axis < 3; ++axis)
                drag.amount[axis] = snapped(drag.amount[axis], snap.translate);
    }
    const glm::dvec3 delta = drag.frame.axes * drag.amount;
    for (io::Transform& transform : result)
        transform.position += delta;
    return result;
}

std::vector<io::Transform> Gizmo::rotated(const View& view, glm::dvec2 pixel, bool snapping)
{
    Drag& drag = *m_drag;
    const int ring = axisOf(drag.handle);
    const glm::dvec3 axis = ring >= 0 ? drag.frame.axes * unitAxis(ring) : -io::forward(view.camera);
    drag.angle += turnedBy(view, drag.frame.pivot, axis, drag.grabbed, drag.lastPixel, pixel);
    const double angle = snapping ? snapped(drag.angle, snap.rotate) : drag.angle;
    drag.amount = {angle, 0, 0};
    std::vector<io::Transform> result = drag.start;
    if (angle == 0) return result;

    const glm::dquat turn = glm::angleAxis(glm::radians(angle), axis);
    for (io::Transform& transform : result) {
        transform.position = drag.frame.pivot + turn * (transform.position - drag.frame.pivot);
        transform.rotation = io::eulerDegrees(turn * io::orientation(transform.rotation));
    }
    if (result.size() == 1) result.front().position = drag.start.front().position; // it is the pivot
    return result;
}

std::vector<io::Transform> Gizmo::scaled(const View& view, glm::dvec2 pixel, bool snapping)
{
    Drag& drag = *m_drag;
    const double length = kLength * metresPerPixel(view, drag.frame.pivot); // m, of a handle
    glm::dvec3 factors = drag.amount;
    if (drag.handle == GizmoHandle::Centre) {
        const glm::dvec2 moved = pixel - drag.pixel; // right and up grow
        factors = glm::dvec3{1 + (moved.x - moved.y) / kLength};
    } else if (const auto now = onPlane(view, pixel, drag.grabbed, dragNormal(view, drag.frame, drag.handle));
               now && length > 0) {
        glm::dvec3 delta = masked(drag.handle, glm::inverse(drag.frame.axes) * (*now - drag.grabbed)) / length;
        if (planeNormalOf(drag.handle) >= 0) { // both axes of a plane alike
            const double both = (delta.x + delta.y + delta.z) / 2;
            delta = masked(drag.handle, glm::dvec3{both});
        }
        factors = glm::dvec3{1} + delta;
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (snapping) factors[axis] = std::max(snapped(factors[axis], snap.scale), snap.scale);
        factors[axis] = std::max(factors[axis], kLeastFactor);
    }
    drag.amount = factors;

    std::vector<io::Transform> result = drag.start;
    for (io::Transform& transform : result) {
        const glm::dvec3 offset = glm::inverse(drag.frame.axes) * (transform.position - drag.frame.pivot);
        if (result.size() > 1) transform.position = drag.frame.pivot + drag.frame.axes * (offset * factors);
        for (int axis = 0; axis < 3; ++axis)
            if (factors[axis] != 1) transform.scale[axis] = scaledBy(transform.scale[axis], factors[axis]);
    }
    return result;
}

} // namespace editor
