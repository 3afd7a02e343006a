// Placing in the viewport: the ghost under the pointer, and what a click makes of it.
#include "editor/editor.h"
#include "editor/placement.h"
#include "editor/text.h"
#include "editor/viewport.h"

namespace editor {
namespace {

constexpr double kFarthest = 5000; // m, that a thing is placed from the eye
constexpr double kAhead = 10;      // m before the eye where there is no ground

std::uint64_t nextSeed(std::uint64_t seed)
{
    return seed * 6364136223846793005u + 1442695040888963407u;
}

} // namespace

void Viewport::beginPlacing(io::TemplateId id)
{
    m_placing = id;
    sculpting = false;
    m_yaw.reset();
    m_anchor.reset();
    m_seed = nextSeed(m_seed);
}

void Viewport::stopPlacing()
{
    m_placing = io::TemplateId::None;
    m_ghost.reset();
    m_anchor.reset();
}

void Viewport::updateGhost(Editor& editor)
{
    m_ghost.reset();
    const io::TemplateId id = m_dropping != io::TemplateId::None ? m_dropping : m_placing;
    if (id == io::TemplateId::None || !editor.document()->scene().find(id)) return stopPlacing();
    if (pressed(Key::Escape)) return stopPlacing();
    if (m_drag != Drag::None && m_drag != Drag::Place) return;
    const bool inside = m_hovered || m_dropping != io::TemplateId::None || m_drag == Drag::Place;
    if (!inside) return;
    PickHit hit = m_anchor ? *m_anchor : editor.picker().pick(view(), pointer(), {.maxDistance = kFarthest});
    if (!hit) return;
    PlaceOptions options{.seed = m_seed, .yaw = m_yaw};
    if (m_drag == Drag::Place && clickDistance()) // held and dragged: turns it
        options.yaw = m_yaw = m_anchorYaw + float(pointer().x - m_pressed.x) * 0.5f;
    m_ghost = renderer::Ghost{id, placedOn(*editor.document(), id, hit, options)};
}

void Viewport::placeGhost(Editor& editor)
{
    m_anchor.reset();
    if (!m_ghost) return;
    const renderer::Ghost ghost = *m_ghost;
    io::ObjectId placed = io::ObjectId::None;
    editor.step("undo.place", [&](Document& document) { placed = place(document, ghost.templateId, ghost.transform); });
    if (placed != io::ObjectId::None) editor.selection().set(placed);
    editor.inspectTemplate = false;
    m_seed = nextSeed(m_seed);
    m_yaw.reset();
    if (!ImGui::GetIO().KeyShift) stopPlacing();
}

void Viewport::takeDrop(Editor& editor)
{
    m_dropping = io::TemplateId::None;
    if (!ImGui::BeginDragDropTarget()) return;
    const ImGuiDragDropFlags flags =
        ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect;
    if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload("template", flags)) {
        m_dropping = *static_cast<const io::TemplateId*>(payload->Data);
        if (payload->IsDelivery()) {
            updateGhost(editor);
            placeGhost(editor);
            m_dropping = io::TemplateId::None;
        }
    }
    ImGui::EndDragDropTarget();
}

// On what is in the middle of the view, or in the air before the eye.
void Viewport::placeAtCamera(Editor& editor, io::TemplateId id)
{
    const View from = view();
    PickHit hit = editor.picker().pick(from, glm::dvec2{from.size} / 2.0, {.maxDistance = kFarthest});
    if (!hit) hit.position = from.camera.eye + io::forward(from.camera) * kAhead;
    m_seed = nextSeed(m_seed);
    io::ObjectId placed = io::ObjectId::None;
    editor.step("undo.place", [&](Document& document) {
        placed = place(document, id, placedOn(document, id, hit, {.seed = m_seed}));
    });
    if (placed != io::ObjectId::None) editor.selection().set(placed);
}

} // namespace editor
