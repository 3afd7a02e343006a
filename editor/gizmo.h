// Gizmo: the handles with which objects are moved, turned and scaled, as geometry in pixels and as mathematics;
// who draws them is not its business.
#pragma once

#include "editor/view.h"
#include "io/scene/transform.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <vector>

namespace editor {

enum class GizmoMode { Translate, Rotate, Scale };
enum class GizmoSpace { World, Local };
enum class GizmoPivot { Median, Primary };

// Centre: in the plane of the screen (translate), all axes at once (scale). View: the ring that faces the eye (rotate).
enum class GizmoHandle { None, X, Y, Z, YZ, ZX, XY, Centre, View };

struct GizmoSnap {
    double translate = 1; // m
    double rotate = 15;   // degrees
    double scale = 0.1;   // factor
};

// One stroke or area to draw, in pixels from the top left, far ones first.
struct GizmoShape {
    GizmoHandle handle = GizmoHandle::None;
    std::vector<glm::dvec2> points;
    bool closed = false;
    bool filled = false;  // an area; otherwise a line
    bool hovered = false; // or being dragged
    int axis = -1;        // 0 x, 1 y, 2 z for its colour; -1 neutral
    double fade = 1;      // 0..1, opacity: an axis that points at the eye fades out
};

// Where the gizmo stands and how it is turned.
struct GizmoFrame {
    glm::dvec3 pivot{0};         // m, world
    glm::dquat axes{1, 0, 0, 0}; // its axes in the world
};

class Gizmo {
public:
    static constexpr double kLength = 90; // pixels, of an axis
    static constexpr double kReach = 8;   // pixels around a handle that hit it

    GizmoMode mode = GizmoMode::Translate;
    GizmoSpace space = GizmoSpace::World;
    GizmoPivot pivot = GizmoPivot::Median;
    GizmoSnap snap;

    // The frame for these transforms, the primary last. Nothing for none.
    std::optional<GizmoFrame> frame(std::span<const io::Transform> transforms) const;

    std::vector<GizmoShape> shapes(const View& view, const GizmoFrame& frame) const;
    GizmoHandle hit(const View& view, const GizmoFrame& frame, glm::dvec2 pixel) const;
    void hover(GizmoHandle handle) { m_hovered = handle; }
    GizmoHandle hovered() const { return m_hovered; }

    // A drag: begin, then any number of updates from the transforms at its beginning, then end. Update answers the
    // new transforms in the same order; always finite, whatever the view.
    bool begin(const View& view, GizmoHandle handle, glm::dvec2 pixel, std::vector<io::Transform> start);
    std::vector<io::Transform> update(const View& view, glm::dvec2 pixel, bool snapping);
    void end() { m_drag.reset(); }
    bool dragging() const { return m_drag.has_value(); }
    GizmoHandle active() const { return m_drag ? m_drag->handle : GizmoHandle::None; }
    GizmoFrame activeFrame() const; // while dragging: follows what is dragged

    // What the drag amounts to so far: metres along the gizmo's axes, degrees about the handle's axis (in x), factors.
    glm::dvec3 amount() const { return m_drag ? m_drag->amount : glm::dvec3{0}; }

private:
    struct Drag {
        GizmoHandle handle = GizmoHandle::None;
        glm::dvec2 pixel{0}; // where it began
        glm::dvec2 lastPixel{0};
        GizmoFrame frame; // at its beginning
        std::vector<io::Transform> start;
        glm::dvec3 grabbed{0}; // the point of the handle's line or plane under the cursor
        double angle = 0;      // degrees turned so far, past full turns too
        glm::dvec3 amount{0};
    };
    std::vector<io::Transform> translated(const View& view, glm::dvec2 pixel, bool snapping);
    std::vector<io::Transform> rotated(const View& view, glm::dvec2 pixel, bool snapping);
    std::vector<io::Transform> scaled(const View& view, glm::dvec2 pixel, bool snapping);

    GizmoHandle m_hovered = GizmoHandle::None;
    std::optional<Drag> m_drag;
};

} // namespace editor
