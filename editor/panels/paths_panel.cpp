#include "editor/panels/paths_panel.h"

#include "editor/camera_paths.h"
#include "editor/editor.h"
#include "editor/placement.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr float kGap = 4;    // pixels between buttons
constexpr float kSmall = 24; // pixels, side of a row's button
constexpr double kPicturesASecond = 60;

// changePath(path) on the one of that name.
void apply(Document& document, const char* textKey, const std::string& name, auto&& changePath)
{
    std::vector<io::CameraPath> paths = pathsOf(document.scene());
    const auto path = std::ranges::find(paths, name, &io::CameraPath::name);
    if (path == paths.end()) return;
    changePath(*path);
    setPaths(document, tr(textKey), std::move(paths));
}

void change(Editor& editor, const char* textKey, const std::string& name, auto&& changePath) // a step
{
    editor.step(textKey, [&](Document& document) { apply(document, textKey, name, changePath); });
}

// For a field that is dragged: one step until it is let go. `field` tells it from others.
void drag(Editor& editor, const char* textKey, const std::string& field, const std::string& name, auto&& changePath)
{
    editor.beginEdit("paths." + field, tr(textKey));
    apply(*editor.document(), textKey, name, changePath);
}

bool numberRow(const char* key, const ui::NumberField& field, double& value)
{
    ui::propertyLabel(tr(key), field.unit);
    return ui::number(field, value);
}

} // namespace

void PathsPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    list(editor);
    const io::CameraPath* chosen = editor.viewport().path.target(*editor.document());
    if (!chosen) return;
    const io::CameraPath path = *chosen;
    rename(editor, path);
    keys(editor, path);
    if (path.keys.size() > 1) {
        pace(editor, path);
        preview(editor, path);
    }
    aim(editor, path);
}

void PathsPanel::list(Editor& editor)
{
    PathTool& tool = editor.viewport().path;
    for (const io::CameraPath& path : pathsOf(editor.document()->scene())) {
        ImGui::PushID(path.name.c_str());
        const bool on = path.name == tool.path;
        const float width = ImGui::GetContentRegionAvail().x - kSmall - kGap;
        if (ui::button("path", ui::fitted(path.name, width - 16).c_str(), on ? ui::Emphasis::Accent : ui::Emphasis::Normal, {width, 0})) {
            tool.stop(editor.viewport().camera);
            tool.reset();
            if (!on) tool.path = path.name;
        }
        ImGui::SameLine(0, kGap);
        if (ui::iconButton({.id = "remove", .icon = Icon::Trash, .label = trf("paths.remove", path.name), .size = kSmall})) {
            if (on) tool.stop(editor.viewport().camera);
            editor.step("undo.remove_path", [&](Document& d) {
                std::vector<io::CameraPath> paths = pathsOf(d.scene());
                std::erase_if(paths, [&](const io::CameraPath& p) { return p.name == path.name; });
                setPaths(d, tr("undo.remove_path"), std::move(paths));
            });
        }
        ImGui::PopID();
    }
    if (!ui::button("add", tr("paths.add"))) return;
    const std::string name = freePathName(editor.document()->scene(), tr("paths.new_name"));
    editor.step("undo.add_path", [&](Document& d) {
        std::vector<io::CameraPath> paths = pathsOf(d.scene());
        paths.push_back({.name = name});
        addKey(paths.back(), editor.viewport().camera.camera());
        setPaths(d, tr("undo.add_path"), std::move(paths));
    });
    tool.reset();
    tool.path = name;
}

// A name that is taken or empty is not taken over.
void PathsPanel::rename(Editor& editor, const io::CameraPath& path)
{
    if (m_named != path.name) m_name = m_named = path.name;
    ui::propertyLabel(tr("paths.name"));
    ui::textField("##name", tr("paths.name"), m_name, ImGuiInputTextFlags_AutoSelectAll);
    if (!ImGui::IsItemDeactivatedAfterEdit()) return;
    m_named.clear(); // what is shown next is what it is called then
    if (m_name.empty() || editor.document()->scene().findPath(m_name)) return;
    change(editor, "undo.rename_path", path.name, [&](io::CameraPath& p) { p.name = m_name; });
    editor.viewport().path.path = m_name;
}

void PathsPanel::keys(Editor& editor, const io::CameraPath& path)
{
    if (!ui::section("keys", tr("paths.keys"))) return;
    Viewport& viewport = editor.viewport();
    for (std::size_t i = 0; i < path.keys.size(); ++i) {
        ImGui::PushID(int(i));
        const std::string number = std::to_string(i + 1);
        if (ui::iconButton({.id = "go", .icon = Icon::Eye, .label = trf("paths.go", number), .size = kSmall})) {
            viewport.path.stop(viewport.camera);
            viewport.camera.setCamera(io::sample(path, path.keys[i].time - path.keys.front().time));
        }
        ImGui::SameLine(0, kGap);
        double time = path.keys[i].time;
        if (ui::number({.id = "##time", .label = trf("paths.time_of", number), .min = 0, .max = 1e6, .speed = 0.02, .unit = "s",
                        .width = ImGui::GetContentRegionAvail().x - 2 * (kSmall + kGap)}, time))
            drag(editor, "undo.time_key", "time" + number, path.name, [&](io::CameraPath& p) { setTime(p, i, time); });
        ImGui::SameLine(0, kGap);
        if (ui::iconButton({.id = "set", .icon = Icon::Camera, .label = trf("paths.set", number), .size = kSmall}))
            change(editor, "undo.move_key", path.name, [&](io::CameraPath& p) { setKey(p, i, viewport.camera.camera()); });
        ImGui::SameLine(0, kGap);
        if (ui::iconButton({.id = "drop", .icon = Icon::Trash, .label = trf("paths.drop", number), .enabled = path.keys.size() > 1, .size = kSmall}))
            change(editor, "undo.remove_key", path.name, [&](io::CameraPath& p) { removeKey(p, i); });
        ImGui::PopID();
    }
    if (ui::button("add_key", tr("paths.add_key")))
        change(editor, "undo.add_key", path.name, [&](io::CameraPath& p) { addKey(p, viewport.camera.camera()); });
    ui::softText(tr("paths.keys_hint"));
}

void PathsPanel::pace(Editor& editor, const io::CameraPath& path)
{
    if (!ui::section("pace", tr("paths.pace"))) return;
    double seconds = io::duration(path);
    if (numberRow("paths.duration", {.id = "##duration", .label = tr("paths.duration"), .min = kShortestLeg, .max = 1e6, .speed = 0.05, .unit = "s"}, seconds))
        drag(editor, "undo.time_key", "duration", path.name, [&](io::CameraPath& p) { setDuration(p, seconds); });
    double speed = io::duration(path) > 0 ? io::length(path) / io::duration(path) : 0;
    if (numberRow("paths.speed", {.id = "##speed", .label = tr("paths.speed"), .min = 0.01, .max = 1e5, .speed = 0.05, .unit = "m/s"}, speed))
        drag(editor, "undo.time_key", "speed", path.name, [&](io::CameraPath& p) { setSpeed(p, speed); });
}

void PathsPanel::aim(Editor& editor, const io::CameraPath& path)
{
    if (!ui::section("aim", tr("paths.aim"))) return;
    bool on = path.lookAt;
    if (ui::checkbox("##look_at", tr("paths.look_at"), on))
        change(editor, "undo.aim_path", path.name, [&](io::CameraPath& p) {
            p.lookAt = on;
            if (on && p.target == glm::dvec3{0}) p.target = editor.viewport().camera.focus();
        });
    if (!path.lookAt) return;
    constexpr const char* kIds[] = {"##x", "##y", "##z"};
    constexpr const char* kAxes[] = {"paths.target_x", "paths.target_y", "paths.target_z"};
    const float width = (ImGui::GetContentRegionAvail().x - 2 * kGap) / 3;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) ImGui::SameLine(0, kGap);
        double value = path.target[axis];
        if (ui::number({.id = kIds[axis], .label = tr(kAxes[axis]), .min = -1e7, .max = 1e7, .unit = "m", .axis = axis, .width = width}, value))
            drag(editor, "undo.aim_path", kIds[axis], path.name, [&](io::CameraPath& p) { p.target[axis] = value; });
    }
    const io::WorldBox box = boundsOf(*editor.document(), editor.selection().ids());
    if (!box.empty() && ui::button("selected", tr("paths.at_selection")))
        change(editor, "undo.aim_path", path.name, [&](io::CameraPath& p) { p.target = box.centre(); });
}

void PathsPanel::preview(Editor& editor, const io::CameraPath& path)
{
    if (!ui::section("preview", tr("paths.preview"))) return;
    Viewport& viewport = editor.viewport();
    if (viewport.path.flying() ? ui::button("stop", tr("paths.stop"), ui::Emphasis::Accent) : ui::button("fly", tr("paths.fly"))) {
        if (viewport.path.flying()) viewport.path.stop(viewport.camera);
        else viewport.path.fly(viewport.camera);
    }
    double time = viewport.path.time;
    if (numberRow("paths.at", {.id = "##at", .label = tr("paths.at"), .min = 0, .max = io::duration(path), .unit = "s"}, time)) viewport.path.show(*editor.document(), viewport.camera, time);
    ui::softText(trf("paths.command", path.name, int(std::ceil(io::duration(path) * kPicturesASecond))));
}

} // namespace editor
