#include "editor/viewport.h"

#include "editor/editor.h"
#include "editor/placement.h"
#include "editor/text.h"
#include "editor/ui_map.h"
#include "editor/widgets.h"

#include <algorithm>

namespace editor {
namespace {

constexpr double kSpeedShown = 1.5;   // s
constexpr double kLongestStep = 0.25; // s; a hitch does not fling the camera
constexpr double kClickSlack = 4;     // pixels a click may move

glm::dvec2 mouseDelta()
{
    return {ImGui::GetIO().MouseDelta.x, ImGui::GetIO().MouseDelta.y};
}

double axisOf(Key positive, Key negative)
{
    return double(down(positive)) - double(down(negative));
}

} // namespace

void Viewport::reset()
{
    m_drag = Drag::None;
    freezeCulling = false;
    m_cycle.reset();
    m_stroke.reset();
    m_scatterStroke.reset();
    scatterLayer = io::ScatterId::None;
    m_brushAt.reset();
    path.reset();
    m_soundHovered = {};
    m_soundDragged.reset();
    stopPlacing();
    m_tinted.clear();
    m_transforms.clear();
    m_lines.clear();
    m_shownRevision = m_shownSelection = 0;
}

void Viewport::lookFrom(const Document& document)
{
    if (!document.scene().cameras().empty()) return camera.setCamera(document.scene().cameras().front());
    io::WorldBox box;
    for (const io::Object& object : document.scene().objects())
        if (const io::WorldBox b = io::worldBounds(document.assets(), object); !b.empty()) box.add(b);
    if (const io::HeightMap* heights = document.scene().heights().get(); heights && box.empty()) {
        const glm::dvec2 size = glm::dvec2{heights->size - 1} * heights->metresPerTexel;
        box.add(glm::dvec3{heights->origin.x, heights->min, heights->origin.y});
        box.add(glm::dvec3{heights->origin.x + size.x, heights->max, heights->origin.y + size.y});
    }
    camera.setCamera({.eye = {0, 20, 40}, .pitch = -20});
    if (!box.empty()) camera.frame(box, double(m_size.x) / m_size.y, false);
}

void Viewport::frameSelection(Editor& editor)
{
    const Document* document = editor.document();
    if (!document) return;
    std::vector<io::ObjectId> ids{editor.selection().ids().begin(), editor.selection().ids().end()};
    if (ids.empty()) ids = allObjects(document->scene(), document->hierarchy());
    if (const io::WorldBox box = boundsOf(*document, ids); !box.empty()) camera.frame(box, double(m_size.x) / m_size.y);
}

glm::dvec2 Viewport::pointer() const
{
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {mouse.x - m_min.x, mouse.y - m_min.y};
}

bool Viewport::clickDistance() const
{
    return glm::distance(pointer(), m_pressed) > kClickSlack;
}

bool Viewport::busy() const
{
    return m_drag != Drag::None || camera.moving() || path.moving() || m_speedShown > 0;
}

std::optional<glm::dvec3> Viewport::pointUnderPointer(Editor& editor) const
{
    const glm::dvec2 at = m_hovered ? pointer() : glm::dvec2{m_size} / 2.0;
    const PickHit hit = editor.picker().pick(view(), at);
    if (!hit) return {};
    return hit.position;
}

void Viewport::draw(Editor& editor)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    m_min = ImGui::GetCursorScreenPos();
    if (room.x < 1 || room.y < 1 || !editor.document()) return;
    m_size = {int(room.x), int(room.y)};

    ImGui::SetCursorScreenPos(m_min);
    ImGui::InvisibleButton("##view", room,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    m_hovered = ImGui::IsItemHovered();
    mapItem("viewport", tr("panel.viewport"));
    takeDrop(editor);
    input(editor, editor.rested() ? 0 : std::min(editor.frameSeconds(), kLongestStep));
    drawPicture(editor);
    if (showOverlays) overlays(editor);
    if (showStatistics) drawStatistics(editor);
    contextMenu(editor);
}

// Ids are read from the picture only while the eye rests, so a coarse one is never asked.
void Viewport::chooseResolution(Editor& editor)
{
    const bool moving = m_drag == Drag::Look || m_drag == Drag::Orbit || m_drag == Drag::Pan || camera.moving();
    if (!moving || editor.host().repeatable())
        m_resolution.sharpen();
    else if (!editor.rested())
        m_resolution.note(editor.frameSeconds(), editor.host().frameRate());
}

void Viewport::drawPicture(Editor& editor)
{
    chooseResolution(editor);
    if (!editor.renderer()) return;
    editor.follow();
    renderer::FrameInput input = frameInput(editor);
    input.size = glm::max(glm::ivec2{glm::dvec2{m_size} * double(pixelsPerPoint()) * m_resolution.scale()}, glm::ivec2{1});
    const renderer::Picture picture = editor.renderer()->render(input);
    if (!editor.rested()) frames.note(editor.frameSeconds(), editor.renderer()->stats().passes);
    const ImVec2 max{m_min.x + float(m_size.x), m_min.y + float(m_size.y)};
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(picture.texture), m_min, max, {0, 1}, {1, 0});
}

void Viewport::input(Editor& editor, double seconds)
{
    m_speedShown = std::max(0.0, m_speedShown - seconds);
    const bool pressed = ImGui::IsItemActivated();
    updateBrush(editor);
    updateScatter(editor);
    if (pressed) press(editor);
    updateHover(editor);
    if (m_drag != Drag::None && !pressed) hold(editor, seconds); // the way to the press is no drag
    if (m_drag != Drag::None && !ImGui::IsItemActive()) release(editor);
    if (m_drag != Drag::Look && camera.moving()) camera.fly({0, 0, 0}, false, seconds);
    if (m_hovered || m_drag == Drag::Look) wheel(editor);
    camera.update(seconds);
    if (path.flying() && (m_drag == Drag::Look || editor::pressed(Key::Escape))) path.stop(camera);
    path.update(*editor.document(), camera, seconds);
    editor.cameras().look(kEditCamera, camera.camera());
    updateGhost(editor);
}

void Viewport::press(Editor& editor)
{
    const ImGuiIO& io = ImGui::GetIO();
    m_pressed = pointer();
    m_flew = false;
    if (io.MouseClicked[ImGuiMouseButton_Right]) {
        m_drag = Drag::Look;
    } else if (io.MouseClicked[ImGuiMouseButton_Middle]) {
        m_drag = Drag::Pan;
        focusUnderPointer(editor);
    } else {
        pressLeft(editor);
    }
}

void Viewport::pressLeft(Editor& editor)
{
    if (ImGui::GetIO().KeyAlt) {
        m_drag = Drag::Orbit;
        const io::WorldBox box = boundsOf(*editor.document(), editor.selection().ids());
        if (!box.empty())
            camera.focusOn(box.centre());
        else
            focusUnderPointer(editor);
    } else if (m_placing != io::TemplateId::None) {
        m_drag = Drag::Place;
        if (m_ghost) m_anchorYaw = m_ghost->transform.rotation.y;
        m_anchor = editor.picker().pick(view(), pointer());
    } else if (sculpting) {
        beginStroke(editor);
    } else if (scattering) {
        beginScatter(editor);
    } else if (showOverlays && path.begin(*editor.document(), view(), pointer())) {
        m_drag = Drag::PathKey;
    } else {
        m_drag = beginSound(editor) ? Drag::Sound : beginGizmo(editor) ? Drag::Gizmo : Drag::Click; // the smaller handles first
    }
}

void Viewport::focusUnderPointer(Editor& editor)
{
    if (const PickHit hit = editor.picker().pick(view(), pointer())) camera.focusOn(hit.position);
}

void Viewport::hold(Editor& editor, double seconds)
{
    switch (m_drag) {
    case Drag::None:
        break;
    case Drag::Look: {
        const glm::dvec3 keys{axisOf(Key::D, Key::A), axisOf(Key::E, Key::Q), axisOf(Key::W, Key::S)};
        m_flew |= keys != glm::dvec3{0};
        camera.look(mouseDelta());
        camera.fly(keys, ImGui::GetIO().KeyShift, seconds);
        break;
    }
    case Drag::Orbit:
        camera.orbit(mouseDelta());
        break;
    case Drag::Pan:
        camera.pan(mouseDelta(), m_size.y);
        break;
    case Drag::Click:
        if (clickDistance()) m_drag = Drag::Box;
        break;
    case Drag::Box:
        break;
    case Drag::Gizmo:
        dragGizmo(editor);
        break;
    case Drag::Sound:
        if (clickDistance()) dragSound(editor);
        break;
    case Drag::Place:
        break;
    case Drag::PathKey:
        path.drag(*editor.document(), view(), pointer());
        break;
    case Drag::Stroke:
        return holdStroke(editor, seconds);
    case Drag::Scatter:
        return holdScatter(editor);
    }
    if (!pressed(Key::Escape)) return;
    if (m_drag == Drag::Gizmo) endGizmo(editor, false);
    if (m_drag == Drag::Sound) endSound(editor, false);
    if (m_drag == Drag::PathKey) path.end(*editor.document(), false);
    if (m_drag == Drag::Box || m_drag == Drag::Gizmo || m_drag == Drag::Sound || m_drag == Drag::PathKey) m_drag = Drag::None;
}

void Viewport::release(Editor& editor)
{
    const Drag ended = std::exchange(m_drag, Drag::None);
    switch (ended) {
    case Drag::Look:
        if (m_flew || clickDistance()) break;
        if (m_placing != io::TemplateId::None)
            stopPlacing();
        else
            openContextMenu(editor);
        break;
    case Drag::Click:
        click(editor);
        break;
    case Drag::Box:
        selectBox(editor);
        break;
    case Drag::Gizmo:
        endGizmo(editor, true);
        break;
    case Drag::Sound:
        endSound(editor, true);
        break;
    case Drag::Place:
        placeGhost(editor);
        break;
    case Drag::PathKey:
        path.end(*editor.document(), true);
        break;
    case Drag::Stroke:
        endStroke();
        break;
    case Drag::Scatter:
        endScatter(editor);
        break;
    default:
        break;
    }
}

void Viewport::wheel(Editor& editor)
{
    const double steps = ImGui::GetIO().MouseWheel;
    if (steps == 0) return;
    if (m_drag == Drag::Look) {
        camera.changeSpeed(steps);
        m_flew = true;
        m_speedShown = kSpeedShown;
    } else if (m_placing != io::TemplateId::None && ImGui::GetIO().KeyCtrl && m_ghost) {
        m_yaw = m_ghost->transform.rotation.y + float(steps) * 15;
    } else {
        focusUnderPointer(editor);
        camera.dolly(steps);
    }
}

void Viewport::updateHover(Editor& editor)
{
    if (m_drag != Drag::None && m_drag != Drag::Click) return;
    GizmoHandle handle = GizmoHandle::None;
    refreshSelectionShown(editor);
    if (m_hovered && gizmoShown && !sculpting && !scattering && m_placing == io::TemplateId::None && !m_transforms.empty())
        if (const auto frame = gizmo.frame(m_transforms)) handle = gizmo.hit(view(), *frame, pointer());
    hoverSound(editor);
    gizmo.hover(m_soundHovered.kind == SoundHandle::Kind::None ? handle : GizmoHandle::None);
}

} // namespace editor
