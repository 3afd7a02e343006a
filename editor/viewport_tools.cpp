// What the left button does in the viewport: click, box, gizmo.
#include "editor/editor.h"
#include "editor/instance_edits.h"
#include "editor/text.h"
#include "editor/undo_names.h"
#include "editor/viewport.h"
#include "editor/widgets.h"

#include <algorithm>

namespace editor {
namespace {

const char* dragName(GizmoMode mode)
{
    return mode == GizmoMode::Translate ? "undo.move" : mode == GizmoMode::Rotate ? "undo.rotate" : "undo.scale";
}

} // namespace

void Viewport::click(Editor& editor)
{
    const std::vector<PickHit> hits = editor.picker().pickAll(view(), pointer());
    const PickHit hit = m_cycle.next(hits, pointer());
    Selection& selection = editor.selection();
    editor.inspectTemplate = false;
    if (hit.id == io::ObjectId::None) {
        if (!ImGui::GetIO().KeyCtrl && !ImGui::GetIO().KeyShift) selection.clear();
        return;
    }
    const std::vector<io::ObjectId> ids = wholeGroups(editor.document()->hierarchy(), {&hit.id, 1});
    const ImGuiIO& io = ImGui::GetIO();
    selection.apply(io.KeyCtrl ? SelectMode::Toggle : io.KeyShift ? SelectMode::Add : SelectMode::Set, ids);
}

void Viewport::selectBox(Editor& editor)
{
    const PixelRect rect{m_pressed, glm::clamp(pointer(), glm::dvec2{0}, glm::dvec2{m_size})};
    const double scale = pixelsPerPoint();
    const glm::ivec2 from = glm::max(glm::ivec2{glm::min(rect.from, rect.to) * scale}, glm::ivec2{0});
    const glm::ivec2 to = glm::min(glm::ivec2{glm::ceil(glm::max(rect.from, rect.to) * scale)},
                                   glm::ivec2{glm::dvec2{m_size} * scale});
    std::vector<io::ObjectId> ids;
    if (editor.renderer() && from.x < to.x && from.y < to.y) {
        const std::vector<std::uint32_t> seen = editor.renderer()->readIds(from, to - from);
        ids = editor.picker().pickBox(view(), rect, std::span<const std::uint32_t>{seen});
    } else {
        ids = editor.picker().pickBox(view(), rect);
    }
    editor.inspectTemplate = false;
    const ImGuiIO& io = ImGui::GetIO();
    editor.selection().apply(io.KeyCtrl    ? SelectMode::Remove
                             : io.KeyShift ? SelectMode::Add
                                           : SelectMode::Set,
                             wholeGroups(editor.document()->hierarchy(), ids));
}

bool Viewport::beginGizmo(Editor& editor)
{
    if (!gizmoShown || gizmo.hovered() == GizmoHandle::None) return false;
    refreshSelectionShown(editor);
    if (!gizmo.begin(view(), gizmo.hovered(), pointer(), m_transforms)) return false;
    editor.document()->beginGesture(stepName(dragName(gizmo.mode), editor.selection().size()));
    promoteSelection(editor);
    m_dragIds = m_tinted;
    return true;
}

// Instances become objects when they are moved: one step with the move, and gone again when it is cancelled.
void Viewport::promoteSelection(Editor& editor)
{
    const std::vector<io::ObjectId> before{editor.selection().ids().begin(), editor.selection().ids().end()};
    const std::vector<io::ObjectId> instances = instancesAmong(editor.document()->scene(), before);
    if (instances.empty()) return;
    const std::vector<io::ObjectId> objects = promote(*editor.document(), tr("undo.promote"), instances);
    std::vector<io::ObjectId> now = before;
    for (std::size_t i = 0; i < instances.size(); ++i)
        std::ranges::replace(now, instances[i], objects[i]);
    editor.follow();
    editor.selection().set(now);
    refreshSelectionShown(editor);
}

void Viewport::dragGizmo(Editor& editor)
{
    const std::vector<io::Transform> transforms = gizmo.update(view(), pointer(), ImGui::GetIO().KeyCtrl != snapping);
    std::size_t next = 0;
    if (transforms.size() != m_dragIds.size()) return; // something vanished meanwhile
    edit(*editor.document(), tr(dragName(gizmo.mode)), m_dragIds,
         [&](io::Object& object) { object.transform = transforms[next++]; });
}

void Viewport::endGizmo(Editor& editor, bool keep)
{
    gizmo.end();
    if (keep)
        editor.document()->endGesture();
    else
        editor.document()->cancelGesture();
}

// Of what was under the pointer when it was pressed: held for looking, a pointer is hidden and has no place. It is
// selected first, unless it is already.
void Viewport::openContextMenu(Editor& editor)
{
    const PickHit hit = editor.picker().pick(view(), m_pressed);
    if (hit.id != io::ObjectId::None) {
        const std::vector<io::ObjectId> ids = wholeGroups(editor.document()->hierarchy(), {&hit.id, 1});
        if (!ids.empty() && !editor.selection().contains(ids.front())) editor.selection().set(ids);
        editor.inspectTemplate = false;
    }
    ImGui::OpenPopup("##context");
}

void Viewport::contextMenu(Editor& editor)
{
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{8, 8});
    if (ImGui::BeginPopup("##context")) {
        const MapPanel map{"popup"};
        const Actions& actions = editor.actions();
        for (const char* id : {"cut", "copy", "paste", "duplicate", "delete"})
            actions.menuItem(id);
        ImGui::Separator();
        for (const char* id : {"group", "ungroup", "promote", "drop", "select_same"})
            actions.menuItem(id);
        ImGui::Separator();
        for (const char* id : {"frame", "place_camera"})
            actions.menuItem(id);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

} // namespace editor
