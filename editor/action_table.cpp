// The table of everything that a person can tell the window to do.
#include "editor/actions.h"
#include "editor/arrange.h"
#include "editor/editor.h"
#include "editor/instance_edits.h"
#include "editor/placement.h"
#include "editor/text.h"

namespace editor {
namespace {

// The objects of the selection.
std::vector<io::ObjectId> selected(Editor& e)
{
    return withoutInstances(e.selection().ids());
}

std::vector<io::ObjectId> selectedInstances(Editor& e)
{
    return instancesAmong(e.document()->scene(), e.selection().ids());
}

void select(Editor& e, std::span<const io::ObjectId> ids)
{
    e.follow(); // what was just made is known from now on
    e.selection().set(ids);
}

void removeSelected(Editor& e, const char* textKey)
{
    const std::vector<io::ObjectId> objects = selected(e), instances = selectedInstances(e);
    e.step(textKey, [&](Document& d) {
        removeObjects(d, tr(textKey), objects);
        removeInstances(d, tr(textKey), instances);
    });
}

void promoteSelected(Editor& e)
{
    std::vector<io::ObjectId> made = selected(e);
    e.step("undo.promote", [&](Document& d) {
        const std::vector<io::ObjectId> objects = promote(d, tr("undo.promote"), selectedInstances(e));
        made.insert(made.end(), objects.begin(), objects.end());
    });
    select(e, made);
}

void demoteSelected(Editor& e)
{
    Demoted done;
    e.step("undo.demote", [&](Document& d) { done = demote(d, tr("undo.demote"), selected(e)); });
    if (done.left > 0) e.toasts().add(io::log::Level::Warning, trf("message.not_demoted", done.left));
    std::vector<io::ObjectId> made;
    for (const io::InstanceRef& instance : done.instances)
        made.push_back(e.document()->scene().idOf(instance));
    if (!made.empty()) select(e, made);
}

void copySelected(Editor& e)
{
    ImGui::SetClipboardText(copyAsText(*e.document(), selected(e)).c_str());
}

void pasteClipboard(Editor& e)
{
    const char* clipboard = ImGui::GetClipboardText();
    const std::string text = clipboard ? clipboard : "";
    const io::Camera& camera = e.viewport().camera.camera();
    const glm::dvec3 at = e.viewport().pointUnderPointer(e).value_or(camera.eye + 10.0 * io::forward(camera));
    std::vector<io::ObjectId> made;
    io::Status done;
    e.step("undo.paste", [&](Document& d) {
        auto pasted = paste(d, text, at);
        if (pasted)
            made = std::move(*pasted);
        else
            done = pasted.error();
    });
    if (!done) return e.toasts().add(io::log::Level::Warning, trf("message.cannot_paste", done.error().what));
    select(e, made);
}

void duplicateSelected(Editor& e)
{
    std::vector<io::ObjectId> made;
    e.step("undo.duplicate", [&](Document& d) { made = duplicate(d, selected(e), {1, 0, 1}); });
    select(e, made);
}

void drop(Editor& e, DropTurn turn)
{
    e.follow();
    e.step("undo.drop", [&](Document& d) { dropToGround(d, e.picker(), selected(e), turn); });
}

void groupSelected(Editor& e)
{
    io::ObjectId made = io::ObjectId::None;
    e.step("undo.group", [&](Document& d) { made = group(d, selected(e)); });
    if (made != io::ObjectId::None) select(e, {&made, 1});
}

void ungroupSelected(Editor& e)
{
    std::vector<io::ObjectId> members;
    e.step("undo.ungroup", [&](Document& d) { members = ungroup(d, selected(e)); });
    select(e, members);
}

void askToRevert(Editor& e)
{
    e.dialogs().confirm(tr("dialog.revert"), tr("dialog.revert_text"), tr("dialog.discard"), [&e] { e.revert(); });
}

void storeCamera(Editor& e)
{
    e.step("undo.store_camera", [&](Document& d) {
        std::vector<io::Camera> cameras{d.scene().cameras().begin(), d.scene().cameras().end()};
        io::Camera camera = e.viewport().camera.camera();
        for (std::size_t n = cameras.size() + 1; n == cameras.size() + 1 || d.scene().findCamera(camera.name); ++n)
            camera.name = trf("camera.name", n);
        cameras.push_back(camera);
        setCameras(d, tr("undo.store_camera"), std::move(cameras));
    });
}

void undo(Editor& e)
{
    if (e.live().turning()) e.live().stopTurning(); // it is what was done last
    else e.document()->undo();
}

std::string nextUndo(Editor& e)
{
    if (e.live().turning()) return e.live().turningName();
    if (!e.document() || !e.document()->history().canUndo()) return {};
    return e.document()->history().names()[e.document()->history().position() - 1];
}

std::string nextRedo(Editor& e)
{
    if (!e.document() || !e.document()->history().canRedo()) return {};
    return e.document()->history().names()[e.document()->history().position()];
}

bool hasGroup(Editor& e)
{
    for (const io::ObjectId id : e.selection().ids())
        if (const io::Object* o = e.document()->scene().find(id); o && o->templateId == io::TemplateId::None)
            return true;
    return false;
}

void chooseTool(Editor& e, GizmoMode mode)
{
    e.viewport().gizmo.mode = mode;
    e.viewport().gizmoShown = true;
    e.viewport().sculpting = e.viewport().scattering = false;
}

void chooseScattering(Editor& e)
{
    if (e.viewport().scattering) e.viewport().scattering = false;
    else e.viewport().scatterWith(e, e.viewport().scatterBrush.mode);
}

void chooseSculpting(Editor& e)
{
    if (e.viewport().sculpting) e.viewport().sculpting = false;
    else e.viewport().sculptWith(e, e.viewport().brush.tool);
}

void place(Editor& e)
{
    if (e.viewport().placing() != io::TemplateId::None) return e.viewport().stopPlacing();
    e.workspace().bringToFront("templates");
    if (e.document()->scene().find(e.chosenTemplate)) e.viewport().beginPlacing(e.chosenTemplate);
}

void fileActions(Actions& a, Editor& e)
{
    const auto open = [&e] { return e.document() != nullptr; };
    a.add({.id = "new", .icon = Icon::New, .keys = ctrl(Key::N), .run = [&e] {
               e.dialogs().askToSave(e, [&e] { e.dialogs().showNew(); });
           }});
    a.add({.id = "open", .icon = Icon::Open, .keys = ctrl(Key::O), .run = [&e] {
               e.dialogs().askToSave(e, [&e] { e.dialogs().showOpen(e); });
           }});
    a.add({.id = "save", .icon = Icon::Save, .keys = ctrl(Key::S), .run = [&e] { e.save(); }, .enabled = open});
    a.add({.id = "import_heights", .run = [&e] { e.dialogs().showImportHeights(e); }, .enabled = open});
    a.add({.id = "export_heights",
           .run = [&e] { e.dialogs().showExportHeights(e); },
           .enabled = [&e] { return e.document() && e.document()->scene().heights(); }});
    a.add({.id = "save_as", .keys = ctrlShift(Key::S), .run = [&e] { e.dialogs().showSaveAs(e); }, .enabled = open});
    a.add({.id = "revert",
           .icon = Icon::Reset,
           .run = [&e] { askToRevert(e); },
           .enabled = [&e] { return e.modified(); }});
    a.add({.id = "close",
           .icon = Icon::Home,
           .keys = ctrl(Key::W),
           .run = [&e] { e.dialogs().askToSave(e, [&e] { e.closeProject(); }); },
           .enabled = open});
    a.add({.id = "quit", .keys = ctrl(Key::Q), .run = [&e] { e.requestClose(); }});
}

void editActions(Actions& a, Editor& e)
{
    const auto open = [&e] { return e.document() != nullptr; };
    const auto any = [&e] { return e.document() && !e.selection().empty(); };
    const auto anyObject = [&e] { return e.document() && !selected(e).empty(); };
    a.add({.id = "undo",
           .icon = Icon::Undo,
           .keys = ctrl(Key::Z),
           .run = [&e] { undo(e); },
           .enabled = [&e] { return e.document() && (e.live().turning() || e.document()->history().canUndo()); },
           .detail = [&e] { return nextUndo(e); },
           .repeats = true});
    a.add({.id = "redo",
           .icon = Icon::Redo,
           .keys = ctrlShift(Key::Z),
           .otherKeys = ctrl(Key::Y),
           .run = [&e] { e.document()->redo(); },
           .enabled = [&e] { return e.document() && e.document()->history().canRedo(); },
           .detail = [&e] { return nextRedo(e); },
           .repeats = true});
    a.add({.id = "cut",
           .keys = ctrl(Key::X),
           .run = [&e] { copySelected(e), removeSelected(e, "undo.cut"); },
           .enabled = anyObject});
    a.add({.id = "copy", .icon = Icon::Copy, .keys = ctrl(Key::C), .run = [&e] { copySelected(e); }, .enabled = anyObject});
    a.add({.id = "paste", .keys = ctrl(Key::V), .run = [&e] { pasteClipboard(e); }, .enabled = open});
    a.add({.id = "duplicate",
           .icon = Icon::Copy,
           .keys = ctrl(Key::D),
           .run = [&e] { duplicateSelected(e); },
           .enabled = anyObject});
    a.add({.id = "delete",
           .icon = Icon::Trash,
           .keys = {.key = Key::Delete},
           .run = [&e] { removeSelected(e, "undo.delete"); },
           .enabled = any});
    a.add({.id = "select_all",
           .keys = ctrl(Key::A),
           .run = [&e] { e.selection().set(allObjects(e.document()->scene(), e.document()->hierarchy())); },
           .enabled = open});
    a.add({.id = "select_none", .keys = ctrlShift(Key::A), .run = [&e] { e.selection().clear(); }, .enabled = any});
    a.add(
        {.id = "invert",
         .keys = ctrl(Key::I),
         .run = [&e] { e.selection().set(inverted(e.document()->scene(), e.document()->hierarchy(), e.selection())); },
         .enabled = open});
    a.add({.id = "select_same",
           .keys = {.key = Key::G, .shift = true},
           .run = [&e] { e.selection().set(sameTemplate(e.document()->scene(), selected(e))); },
           .enabled = any});
    a.add(
        {.id = "group", .icon = Icon::Group, .keys = ctrl(Key::G), .run = [&e] { groupSelected(e); }, .enabled = anyObject});
    a.add({.id = "ungroup",
           .keys = ctrlShift(Key::G),
           .run = [&e] { ungroupSelected(e); },
           .enabled = [any, &e] { return any() && hasGroup(e); }});
    a.add({.id = "promote", .run = [&e] { promoteSelected(e); }, .enabled = [&e] { return e.document() && !selectedInstances(e).empty(); }});
    a.add({.id = "demote",
           .run = [&e] { demoteSelected(e); },
           .enabled = [&e] { return e.document() && !e.document()->scene().scatterLayers().empty() && !selected(e).empty(); }});
}

void viewActions(Actions& a, Editor& e)
{
    const auto open = [&e] { return e.document() != nullptr; };
    a.add({.id = "frame",
           .icon = Icon::Frame,
           .keys = {.key = Key::F},
           .run = [&e] { e.viewport().frameSelection(e); },
           .enabled = open});
    a.add({.id = "look_played",
           .run = [&e] { e.viewport().camera.setCamera(*e.cameras().find(kPlayCamera)); },
           .enabled = [&e, open] { return open() && e.cameras().find(kPlayCamera); }});
    a.add({.id = "store_camera", .icon = Icon::Plus, .run = [&e] { storeCamera(e); }, .enabled = open});
    a.add({.id = "overlays",
           .keys = {.key = Key::F1},
           .run = [&e] { e.viewport().showOverlays = !e.viewport().showOverlays; },
           .checked = [&e] { return e.viewport().showOverlays; }});
    a.add({.id = "statistics",
           .icon = Icon::Chart,
           .keys = {.key = Key::F3},
           .run = [&e] { e.viewport().showStatistics = !e.viewport().showStatistics; },
           .checked = [&e] { return e.viewport().showStatistics; }});
    a.add({.id = "freeze_culling",
           .keys = {.key = Key::F7},
           .run = [&e] { e.viewport().freezeCulling = !e.viewport().freezeCulling; },
           .enabled = open,
           .checked = [&e] { return e.viewport().freezeCulling; }});
    a.add({.id = "tree_nodes",
           .keys = {.key = Key::F6},
           .run =
               [&e] {
                   const bool shown = e.show == renderer::Show::Nodes;
                   e.show = shown ? renderer::Show::Final : renderer::Show::Nodes;
               },
           .enabled = open,
           .checked = [&e] { return e.show == renderer::Show::Nodes; }});
    a.add({.id = "animate",
           .keys = {.key = Key::F4},
           .run = [&e] { e.setAnimates(!e.animates()); },
           .checked = [&e] { return e.animates(); }});
    a.add({.id = "rendering", .run = [&e] { e.workspace().bringToFront("rendering"); }});
    a.add({.id = "reset_layout", .icon = Icon::Reset, .run = [&e] { e.workspace().reset(); }});
    a.add({.id = "play", .keys = {.key = Key::F5}, .run = [&e] { e.host().play(false); }, .enabled = open});
    a.add({.id = "play_start", .keys = {.key = Key::F5, .shift = true}, .run = [&e] { e.host().play(true); }, .enabled = open});
    a.add({.id = "controls", .icon = Icon::Pad, .run = [&e] { e.controlsDialog().show(); }, .enabled = open});
    a.add({.id = "hear",
           .icon = Icon::Speaker,
           .keys = {.key = Key::M},
           .run = [&e] { e.sound.hear = !e.sound.hear; },
           .enabled = open,
           .checked = [&e] { return e.sound.hear; }});
    a.add({.id = "keep_play",
           .run = [&e] { e.dialogs().showKeepPlay(e); },
           .enabled = [&e] { return e.document() && !playRows(*e.document(), e.playChanges()).empty(); }});
    a.add({.id = "reload_shaders",
           .keys = {.key = Key::F5, .ctrl = true},
           .run = [&e] { e.renderer()->reloadShaders(); },
           .enabled = [&e] { return e.renderer() != nullptr; }});
    a.add({.id = "keys", .icon = Icon::Info, .run = [&e] { e.dialogs().showKeys(); }});
}

void toolActions(Actions& a, Editor& e)
{
    const auto open = [&e] { return e.document() != nullptr; };
    const auto any = [&e] { return e.document() && !e.selection().empty(); };
    const auto tool = [&](std::string_view id, Icon icon, Key key, Key digit, GizmoMode mode) {
        a.add({.id = id,
               .icon = icon,
               .keys = {.key = key},
               .otherKeys = {.key = digit},
               .run = [&e, mode] { chooseTool(e, mode); },
               .checked = [&e, mode] { return e.viewport().gizmoShown && !e.viewport().sculpting && !e.viewport().scattering && e.viewport().gizmo.mode == mode; }});
    };
    a.add({.id = "tool_select",
           .icon = Icon::Select,
           .keys = {.key = Key::Q},
           .run = [&e] { e.viewport().gizmoShown = e.viewport().sculpting = e.viewport().scattering = false; },
           .checked = [&e] { return !e.viewport().gizmoShown && !e.viewport().sculpting && !e.viewport().scattering; }});
    tool("tool_move", Icon::Translate, Key::W, Key::Digit1, GizmoMode::Translate);
    tool("tool_rotate", Icon::Rotate, Key::E, Key::Digit2, GizmoMode::Rotate);
    tool("tool_scale", Icon::Scale, Key::R, Key::Digit3, GizmoMode::Scale);
    a.add({.id = "tool_sculpt",
           .icon = Icon::Terrain,
           .keys = {.key = Key::B},
           .otherKeys = {.key = Key::Digit4},
           .run = [&e] { chooseSculpting(e); },
           .enabled = [&e] { return e.document() && e.document()->scene().heights(); },
           .checked = [&e] { return e.viewport().sculpting; }});
    a.add({.id = "tool_scatter",
           .icon = Icon::Tree,
           .keys = {.key = Key::V},
           .otherKeys = {.key = Key::Digit5},
           .run = [&e] { chooseScattering(e); },
           .enabled = open,
           .checked = [&e] { return e.viewport().scattering; }});
    const auto resize = [&](std::string_view id, Key key, float factor) {
        a.add({.id = id,
               .keys = {.key = key},
               .run = [&e, factor] { e.viewport().resizeBrush(factor); },
               .enabled = [&e] { return e.viewport().sculpting || e.viewport().scattering; },
               .repeats = true});
    };
    resize("brush_smaller", Key::LeftBracket, 1 / 1.15f);
    resize("brush_larger", Key::RightBracket, 1.15f);
    a.add({.id = "generate_ground", .run = [&e] { e.groundDialogs().showGenerate(e); }, .enabled = open});
    a.add({.id = "reshape_ground",
           .run = [&e] { e.groundDialogs().showReshape(e); },
           .enabled = [&e] { return e.document() && e.document()->scene().heights(); }});
    a.add({.id = "space",
           .icon = Icon::Local,
           .keys = {.key = Key::X},
           .run =
               [&e] {
                   GizmoSpace& space = e.viewport().gizmo.space;
                   space = space == GizmoSpace::World ? GizmoSpace::Local : GizmoSpace::World;
               },
           .checked = [&e] { return e.viewport().gizmo.space == GizmoSpace::Local; }});
    a.add({.id = "snap",
           .icon = Icon::Snap,
           .keys = {.key = Key::N},
           .run = [&e] { e.viewport().snapping = !e.viewport().snapping; },
           .checked = [&e] { return e.viewport().snapping; }});
    a.add({.id = "place",
           .icon = Icon::Place,
           .keys = {.key = Key::P},
           .run = [&e] { place(e); },
           .enabled = open,
           .checked = [&e] { return e.viewport().placing() != io::TemplateId::None; }});
    a.add({.id = "place_camera",
           .icon = Icon::PlaceHere,
           .keys = {.key = Key::P, .shift = true},
           .run = [&e] { e.viewport().placeAtCamera(e, e.chosenTemplate); },
           .enabled = [&e] { return e.document() && e.document()->scene().find(e.chosenTemplate); }});
    a.add({.id = "drop",
           .icon = Icon::Drop,
           .keys = {.key = Key::End},
           .run = [&e] { drop(e, DropTurn::Keep); },
           .enabled = any});
    a.add({.id = "drop_align",
           .keys = {.key = Key::End, .shift = true},
           .run = [&e] { drop(e, DropTurn::Align); },
           .enabled = any});
    a.add({.id = "pick_boxes",
           .run = [&e] { e.picker().setBoxesOnly(!e.picker().boxesOnly()); },
           .checked = [&e] { return e.picker().boxesOnly(); }});
}

} // namespace

Actions makeActions(Editor& editor)
{
    Actions actions;
    fileActions(actions, editor);
    editActions(actions, editor);
    viewActions(actions, editor);
    toolActions(actions, editor);
    return actions;
}

} // namespace editor
