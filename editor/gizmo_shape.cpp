#include "editor/gizmo_shape.h"

#include "renderer/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace editor {
namespace {

constexpr double kLength = Gizmo::kLength;
constexpr double kTip = 14, kTipHalf = 5;           // pixels, an arrow's head
constexpr double kBox = 5;                          // pixels, half a side of a scale handle's box
constexpr double kCentre = 8;                       // pixels, radius of the middle
constexpr double kViewRing = 1.2;                   // of kLength
constexpr double kPlaneFrom = 0.3, kPlaneTo = 0.55; // of kLength
constexpr double kClickable = 0.25;                 // fade below which a handle is not hit
constexpr int kRingPoints = 64;
constexpr std::array kAxisHandles{GizmoHandle::X, GizmoHandle::Y, GizmoHandle::Z};
constexpr std::array kPlaneHandles{GizmoHandle::YZ, GizmoHandle::ZX, GizmoHandle::XY};

struct Screen {
    const View& view;
    const GizmoFrame& frame;
    double metres;     // of a pixel at the pivot
    glm::dvec2 centre; // pixel of the pivot

    glm::dvec3 axis(int i) const { return frame.axes * unitAxis(i); }
    std::optional<glm::dvec2> pixel(const glm::dvec3& world) const { return project(view, world); }
};

std::vector<glm::dvec2> square(glm::dvec2 at, double half)
{
    return {at + glm::dvec2{-half, -half}, at + glm::dvec2{half, -half}, at + glm::dvec2{half, half},
            at + glm::dvec2{-half, half}};
}

std::vector<glm::dvec2> circle(glm::dvec2 at, double radius, int points)
{
    std::vector<glm::dvec2> result;
    for (int i = 0; i < points; ++i) {
        const double angle = glm::two_pi<double>() * i / points;
        result.push_back(at + radius * glm::dvec2{std::cos(angle), std::sin(angle)});
    }
    return result;
}

void addAxis(std::vector<GizmoShape>& shapes, const Screen& screen, int axis, bool boxes)
{
    const auto tip = screen.pixel(screen.frame.pivot + screen.axis(axis) * (kLength * screen.metres));
    if (!tip) return;
    const glm::dvec2 along = *tip - screen.centre;
    const double length = glm::length(along);
    const double fade = glm::clamp((length / kLength - 0.08) / 0.12, 0.0, 1.0); // pointing at the eye
    if (fade <= 0) return;
    const glm::dvec2 unit = along / length;
    const glm::dvec2 side{-unit.y, unit.x};
    shapes.push_back({.handle = kAxisHandles[axis],
                      .points = {screen.centre + unit * std::min(kCentre + 2, length), *tip},
                      .axis = axis,
                      .fade = fade});
    shapes.push_back(
        {.handle = kAxisHandles[axis],
         .points = boxes ? square(*tip, kBox)
                         : std::vector<glm::dvec2>{*tip + unit * kTip, *tip + side * kTipHalf, *tip - side * kTipHalf},
         .closed = true,
         .filled = true,
         .axis = axis,
         .fade = fade});
}

void addPlane(std::vector<GizmoShape>& shapes, const Screen& screen, int normal)
{
    const glm::dvec3 sight = glm::normalize(screen.frame.pivot - screen.view.camera.eye);
    const double fade = glm::clamp((std::abs(glm::dot(sight, screen.axis(normal))) - 0.1) / 0.15, 0.0, 1.0);
    if (fade <= 0) return;
    const glm::dvec3 u = screen.axis((normal + 1) % 3) * (kLength * screen.metres);
    const glm::dvec3 v = screen.axis((normal + 2) % 3) * (kLength * screen.metres);
    GizmoShape shape{.handle = kPlaneHandles[normal], .closed = true, .filled = true, .axis = normal, .fade = fade};
    for (const glm::dvec2 at :
         {glm::dvec2{kPlaneFrom, kPlaneFrom}, {kPlaneTo, kPlaneFrom}, {kPlaneTo, kPlaneTo}, {kPlaneFrom, kPlaneTo}}) {
        const auto pixel = screen.pixel(screen.frame.pivot + u * at.x + v * at.y);
        if (!pixel) return;
        shape.points.push_back(*pixel);
    }
    shapes.push_back(std::move(shape));
}

// The half of a ring that faces the eye, as one line.
void addRing(std::vector<GizmoShape>& shapes, const Screen& screen, int axis)
{
    const glm::dvec3 n = screen.axis(axis);
    const glm::dvec3 sight = glm::normalize(screen.frame.pivot - screen.view.camera.eye);
    glm::dvec3 across = glm::cross(n, sight); // where the facing half begins and ends
    const bool whole = glm::length(across) < 0.1;
    across = whole ? screen.axis((axis + 1) % 3) : glm::normalize(across);
    const glm::dvec3 towards = glm::cross(across, n) * (glm::dot(glm::cross(across, n), sight) > 0 ? -1.0 : 1.0);
    GizmoShape shape{.handle = kAxisHandles[axis], .closed = whole, .axis = axis};
    const double arc = whole ? glm::two_pi<double>() : glm::pi<double>();
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle = arc * i / kRingPoints;
        const auto pixel = screen.pixel(screen.frame.pivot + (across * std::cos(angle) + towards * std::sin(angle)) *
                                                                 (kLength * screen.metres));
        if (pixel) shape.points.push_back(*pixel);
    }
    shapes.push_back(std::move(shape));
}

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b)
{
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? glm::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
    return glm::distance(p, a + along * t);
}

double distanceToShape(const GizmoShape& shape, glm::dvec2 pixel)
{
    double nearest = 1e9;
    bool inside = false; // by the crossings of a line to the right
    const std::size_t n = shape.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const bool last = i + 1 == n;
        if (last && !shape.closed) break;
        const glm::dvec2 a = shape.points[i], b = shape.points[last ? 0 : i + 1];
        nearest = std::min(nearest, distanceToSegment(pixel, a, b));
        if ((a.y > pixel.y) != (b.y > pixel.y) && pixel.x < (b.x - a.x) * (pixel.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return shape.filled && inside ? 0 : nearest;
}

} // namespace

int axisOf(GizmoHandle handle)
{
    return handle >= GizmoHandle::X && handle <= GizmoHandle::Z ? int(handle) - int(GizmoHandle::X) : -1;
}

int planeNormalOf(GizmoHandle handle)
{
    return handle >= GizmoHandle::YZ && handle <= GizmoHandle::XY ? int(handle) - int(GizmoHandle::YZ) : -1;
}

double metresPerPixel(const View& view, const glm::dvec3& point)
{
    const double depth = glm::dot(point - view.camera.eye, io::forward(view.camera));
    if (!(depth > renderer::kNear)) return 0;
    return 2 * depth * std::tan(glm::radians(double(view.camera.fov)) / 2) / std::max(view.size.y, 1);
}

std::vector<GizmoShape> gizmoShapes(GizmoMode mode, const View& view, const GizmoFrame& frame)
{
    std::vector<GizmoShape> shapes;
    const double metres = metresPerPixel(view, frame.pivot);
    const auto centre = project(view, frame.pivot);
    if (metres <= 0 || !centre) return shapes;
    const Screen screen{view, frame, metres, *centre};
    std::array order{0, 1, 2}; // far ones first
    std::ranges::sort(order, {}, [&](int axis) { return -glm::dot(screen.axis(axis), io::forward(view.camera)); });
    if (mode == GizmoMode::Rotate) {
        for (const int axis : order)
            addRing(shapes, screen, axis);
        shapes.push_back(
            {.handle = GizmoHandle::View, .points = circle(*centre, kViewRing * kLength, kRingPoints), .closed = true});
        return shapes;
    }
    for (int normal = 0; normal < 3; ++normal)
        addPlane(shapes, screen, normal);
    for (const int axis : order)
        addAxis(shapes, screen, axis, mode == GizmoMode::Scale);
    const bool box = mode == GizmoMode::Scale;
    shapes.push_back({.handle = GizmoHandle::Centre,
                      .points = box ? square(*centre, kCentre * 0.8) : circle(*centre, kCentre, 16),
                      .closed = true,
                      .filled = true});
    return shapes;
}

GizmoHandle hitHandle(std::span<const GizmoShape> shapes, glm::dvec2 pixel, double reach)
{
    GizmoHandle best = GizmoHandle::None;
    double bestDistance = reach;
    // From the top of the picture down; what lies higher wins a draw. An area counts by being in it, a line by
    // nearness.
    for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) {
        const double distance = distanceToShape(*shape, pixel);
        if (shape->fade < kClickable || distance >= bestDistance) continue;
        best = shape->handle;
        bestDistance = distance;
    }
    return best;
}

double turnedBy(const View& view, const glm::dvec3& pivot, const glm::dvec3& axis, const glm::dvec3& grabbed,
                glm::dvec2 from, glm::dvec2 to)
{
    constexpr double kFaceOn = 0.25; // cosine of the ring's normal and the line of sight
    const auto centre = project(view, pivot);
    if (!centre || from == to) return 0;
    const glm::dvec3 sight = glm::normalize(pivot - view.camera.eye);
    const double facing = -glm::dot(sight, axis);
    if (std::abs(facing) < kFaceOn) {
        glm::dvec3 arm = grabbed - pivot - axis * glm::dot(grabbed - pivot, axis);
        if (!(glm::length(arm) > 1e-9)) arm = -sight;
        const double reach = kLength * metresPerPixel(view, pivot);
        const glm::dvec3 tangent = glm::cross(axis, glm::normalize(arm)) * reach;
        const auto ahead = project(view, pivot + tangent);
        const glm::dvec2 along = ahead ? *ahead - *centre : glm::dvec2{0};
        const double length = glm::length(along);
        return length > 1 ? glm::degrees(glm::dot(to - from, along / length) / kLength) : 0;
    }
    // Angles in the ring's own plane, so that the point taken hold of stays under the cursor.
    const auto angleAt = [&](glm::dvec2 pixel) -> std::optional<double> {
        const io::Ray ray = rayThrough(view, pixel);
        const double fall = glm::dot(ray.direction, axis);
        const double t = glm::dot(pivot - ray.origin, axis) / fall;
        if (!(std::abs(fall) > 1e-3 && t > 0)) return std::nullopt;
        const glm::dvec3 arm = ray.origin + ray.direction * t - pivot;
        const glm::dvec3 u =
            glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3{0, 1, 0} : glm::dvec3{1, 0, 0}));
        return std::atan2(glm::dot(arm, glm::cross(axis, u)), glm::dot(arm, u));
    };
    const auto a = angleAt(from), b = angleAt(to);
    return a && b ? std::remainder(glm::degrees(*b - *a), 360.0) : 0;
}

} // namespace editor
