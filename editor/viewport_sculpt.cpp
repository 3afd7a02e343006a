// The brush in the viewport: strokes over the ground, and the ring that shows where they fall.
#include "editor/brush_ring.h"
#include "editor/editor.h"
#include "editor/pointer_way.h"
#include "editor/stamp_file.h"
#include "editor/text.h"
#include "editor/viewport.h"
#include "io/base/log.h"

namespace editor {
namespace {

constexpr double kFarthest = 20000; // m, that ground is shaped from the eye
constexpr glm::vec4 kRing{1.0f, 0.86f, 0.42f, 1}, kCore{1.0f, 0.86f, 0.42f, 0.5f};

std::string stepNameOf(BrushTool tool)
{
    return tr("brush_step." + std::string{enumNames(tool)[std::size_t(tool)]});
}

} // namespace

void Viewport::beginStroke(Editor& editor)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (!m_brushAt) return;
    const StrokeKeys keys{.inverted = io.KeyCtrl, .smooths = io.KeyShift, .objectsFollow = objectsFollow};
    if (brush.tool == BrushTool::Stamp && !brush.stamp) return editor.toasts().add(io::log::Level::Warning, tr("message.no_stamp"));
    m_strokeGround = editor.picker().ground();
    m_stroke.emplace(*editor.document(), brush, keys, stepNameOf(toolWith(brush.tool, keys)));
    m_stroke->to(*m_brushAt);
    m_drag = Drag::Stroke;
}

void Viewport::holdStroke(Editor& editor, double seconds)
{
    if (m_stroke && !editor.document()->inGesture()) m_stroke.reset(); // undone or saved meanwhile: it is a step already
    if (!m_stroke) return;
    if (pressed(Key::Escape)) {
        m_stroke->cancel();
        m_stroke.reset();
        m_drag = Drag::None;
        return;
    }
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (moved.x != 0 || moved.y != 0) {
        glm::dvec2 last{-kFarthest};
        for (const glm::dvec2& at : pointerWay()) { // a slow frame sees much of the way at once
            last = at - glm::dvec2{m_min.x, m_min.y};
            if (const auto ground = strokeGroundAt(last)) m_stroke->to(*ground);
        }
        if (m_brushAt && glm::distance(last, pointer()) > 1.5) m_stroke->to(*m_brushAt); // ImGui's is in whole points
    } else {
        m_stroke->rest(seconds);
    }
    editor.follow();
}

void Viewport::endStroke()
{
    if (m_stroke) m_stroke->end();
    m_stroke.reset();
    m_strokeGround = {};
}

// Where the pointer is on the ground as it was when the stroke began: by the ground that the stroke makes its hill would run from
// under the brush, and how far depended on how many frames it took.
std::optional<glm::dvec3> Viewport::strokeGroundAt(const glm::dvec2& pixel) const
{
    const auto hit = m_strokeGround.hit(rayThrough(view(), pixel), kFarthest);
    return hit ? std::optional{hit->position} : std::nullopt;
}

void Viewport::updateBrush(Editor& editor)
{
    m_brushAt.reset();
    if (!editor.document()->scene().heights()) sculpting = false;
    if (!sculpting) return;
    if (m_drag != Drag::None && m_drag != Drag::Stroke) return;
    if (!m_hovered && m_drag != Drag::Stroke) return;
    if (m_drag == Drag::Stroke) {
        m_brushAt = strokeGroundAt(pointer());
        return;
    }
    const PickHit hit = editor.picker().pick(view(), pointer(), {.objects = false, .maxDistance = kFarthest});
    if (hit.surface == Surface::Terrain) m_brushAt = hit.position;
    if (m_drag == Drag::None && pressed(Key::Escape)) sculpting = false;
}

void Viewport::addBrushLines(const Editor& editor, std::vector<renderer::Line>& lines) const
{
    const auto& map = editor.document()->scene().heights();
    if (!sculpting || !m_brushAt || !map) return;
    const glm::dvec3 eye = camera.camera().eye;
    addRing(lines, map.get(), eye, *m_brushAt, brush.radius, kRing);
    if (brush.falloff > 0.02f && brush.falloff < 0.98f) addRing(lines, map.get(), eye, *m_brushAt, double(brush.radius) * (1 - double(brush.falloff)), kCore);
    if (m_stroke && brush.tool == BrushTool::Ramp && m_stroke->start()) {
        addRing(lines, map.get(), eye, *m_stroke->start(), brush.radius, kRing);
        lines.push_back({.from = *m_stroke->start(), .to = *m_brushAt, .colour = kRing, .onTop = true});
    }
}

void Viewport::resizeBrush(float factor)
{
    float& radius = scattering ? scatterBrush.radius : brush.radius;
    radius = std::clamp(radius * factor, 0.5f, 500.0f);
}

void Viewport::stayAbove(const Document& document)
{
    constexpr double kAbove = 2; // m
    io::Camera moved = camera.camera();
    const auto& map = document.scene().heights();
    const auto ground = map ? map->height(moved.eye.x, moved.eye.z) : std::nullopt;
    if (!ground || moved.eye.y >= *ground + kAbove) return;
    moved.eye.y = *ground + kAbove;
    camera.setCamera(moved);
}

void Viewport::readStamp(const Document& document)
{
    brush.stamp = nullptr;
    if (brush.stampFile.empty()) return;
    auto stamp = editor::readStamp(document.project().folder, brush.stampFile);
    if (stamp) brush.stamp = *std::move(stamp);
    else io::log::error("{}", stamp.error().text());
}

void Viewport::sculptWith(Editor& editor, BrushTool tool)
{
    brush.tool = tool;
    sculpting = true;
    scattering = false;
    stopPlacing();
    editor.workspace().bringToFront("terrain");
}

} // namespace editor
