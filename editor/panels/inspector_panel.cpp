#include "editor/panels/inspector_panel.h"

#include "editor/arrange.h"
#include "editor/editor.h"
#include "editor/instance_edits.h"
#include "editor/field_ui.h"
#include "editor/numbers_text.h"
#include "editor/panels/falloff_curve.h"
#include "editor/panels/trigger_actions.h"
#include "editor/placement.h"
#include "editor/project_files.h"
#include "editor/text.h"
#include "editor/undo_names.h"
#include "editor/widgets.h"

#include <algorithm>

namespace editor {
namespace {

// Groups stand where their members do: a change of a group's place moves all of them.
void applyToSelection(Editor& editor, const FieldUi& ui, const std::vector<ScalarChange>& changes)
{
    Document& document = *editor.document();
    const std::size_t count = editor.selection().size();
    editor.beginEdit("object." + ui.changedKey(), count == 1 ? trf("undo.edit", ui.changedLabel())
                                                             : trf("undo.edit_many", ui.changedLabel(), count));
    std::vector<io::ObjectId> things;
    for (const io::ObjectId id : editor.selection().ids()) {
        const io::Object* object = document.scene().find(id);
        if (!object) continue;
        if (object->templateId != io::TemplateId::None) {
            things.push_back(id);
            continue;
        }
        io::Transform moved = object->transform;
        applyChanges(moved, changes);
        moveBy(document, tr("undo.move"), {{id}}, moved.position - object->transform.position);
    }
    edit(document, ui.changedLabel(), things, [&](io::Object& object) { applyChanges(object.transform, changes); });
}

} // namespace

void InspectorPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    if (editor.inspectTemplate && editor.document()->scene().find(editor.chosenTemplate))
        return drawTemplate(editor, editor.chosenTemplate);
    if (!editor.selection().empty()) return drawObjects(editor);
    ui::emptyState(Icon::Select, tr("inspector.empty"), tr("inspector.empty_text"));
}

void InspectorPanel::drawObjects(Editor& editor)
{
    const io::Object* found = editor.document()->scene().find(editor.selection().primary());
    if (const auto instance = editor.document()->scene().findInstance(editor.selection().primary())) return drawInstance(editor, *instance);
    if (!found) return;
    const io::Object primary = *found; // a copy: an edit below moves what it refers to
    refresh(editor, primary);
    drawHeader(editor, primary);
    drawTemplateChoice(editor, primary);
    drawGroupRow(editor, primary);
    ImGui::Dummy({0, 2});
    if (ui::section("transform", tr("section.transform"))) drawTransform(editor, primary);
    ImGui::Dummy({0, 2});
    if (ui::section("facts", tr("section.facts"))) drawFacts(primary);
}

void InspectorPanel::drawInstance(Editor& editor, const io::InstanceRef& instance)
{
    const std::size_t count = editor.selection().size();
    ui::heading(count > 1 ? trf("inspector.many", grouped(count)).c_str() : instanceName(editor.document()->scene(), instance).c_str());
    ImGui::TextWrapped("%s", tr("inspector.instance_text"));
    if (ui::button("promote", tr("action.promote"), ui::Emphasis::Normal, {-1, 0})) editor.actions().run("promote");
}

void InspectorPanel::refresh(Editor& editor, const io::Object& primary)
{
    const Document& document = *editor.document();
    if (m_revision == document.revision() && m_selection == editor.selection().revision()) return;
    m_revision = document.revision();
    m_selection = editor.selection().revision();
    m_bounds = boundsOf(document, editor.selection().ids());
    m_members = document.hierarchy().withMembers({{primary.id}}).size() - 1;
    m_triangles = 0;
    for (const io::ObjectId id : document.hierarchy().withMembers(editor.selection().ids()))
        if (const io::Object* object = document.scene().find(id))
            if (const io::Model* model = document.assets().model(object->templateId)) m_triangles += model->triangles();
    const std::vector<Scalar> own = scalarsOf(primary.transform);
    m_mixed.assign(own.size(), false);
    m_mixedTemplates = m_mixedNames = false;
    for (const io::ObjectId id : editor.selection().ids()) {
        const io::Object* object = document.scene().find(id);
        if (!object || id == primary.id) continue;
        m_mixedTemplates |= object->templateId != primary.templateId;
        m_mixedNames |= object->name != primary.name;
        if (std::find(m_mixed.begin(), m_mixed.end(), false) == m_mixed.end()) continue;
        const std::vector<Scalar> other = scalarsOf(object->transform);
        for (std::size_t i = 0; i < own.size(); ++i)
            m_mixed[i] = m_mixed[i] || other[i] != own[i];
    }
}

void InspectorPanel::drawHeader(Editor& editor, const io::Object& primary)
{
    const Document& document = *editor.document();
    const std::size_t count = editor.selection().size();
    const bool isGroup = primary.templateId == io::TemplateId::None;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    drawIcon(*ImGui::GetWindowDrawList(), isGroup ? Icon::Group : Icon::Cube, {at.x, at.y + 2}, 18,
             isGroup ? palette::kAmber : palette::kAccent);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 28);
    ui::heading(
        count > 1 ? trf("inspector.many", grouped(count)).c_str()
                  : ui::fitted(displayName(document.scene(), primary), ImGui::GetContentRegionAvail().x - 80).c_str());
    const std::string id = trf("inspector.id", io::number(primary.id));
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(id.c_str()).x);
    ImGui::TextDisabled("%s", id.c_str());
    mapItem("label", id, io::number(primary.id));
    ImGui::Dummy({0, 2});

    std::string name = m_mixedNames ? std::string{} : primary.name;
    ui::propertyLabel(tr("field.object.name"));
    const std::string hint = m_mixedNames ? std::string{tr("common.mixed")} : displayName(document.scene(), primary);
    if (!ui::textField("##name", hint.c_str(), name)) return;
    editor.beginEdit("object.name", stepName("undo.rename", count));
    edit(*editor.document(), tr("undo.rename"), editor.selection().ids(), [&](io::Object& o) { o.name = name; });
}

void InspectorPanel::drawTemplateChoice(Editor& editor, const io::Object& primary)
{
    if (primary.templateId == io::TemplateId::None) return;
    const io::Scene& scene = editor.document()->scene();
    std::vector<std::pair<std::string, io::TemplateId>> choices;
    for (std::size_t i = 0; i < scene.templates().size(); ++i) {
        const io::TemplateId id{std::uint32_t(i + 1)};
        if (scene.find(id) || id == primary.templateId) choices.emplace_back(scene.templates()[i].name, id);
    }
    std::sort(choices.begin(), choices.end());
    std::vector<std::string> names;
    int chosen = -1;
    for (const auto& [name, id] : choices) {
        if (id == primary.templateId) chosen = int(names.size());
        names.push_back(name);
    }
    ui::propertyLabel(tr("field.object.template"));
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 30);
    if (ui::combo("##template", tr("field.object.template"), names, chosen, m_mixedTemplates)) {
        const io::TemplateId id = choices[std::size_t(chosen)].second;
        editor.step("undo.assign", [&](Document& document) {
            edit(document, tr("undo.assign"), editor.selection().ids(), [id](io::Object& o) {
                if (o.templateId != io::TemplateId::None) o.templateId = id;
            });
        });
    }
    ImGui::SameLine(0, 4);
    if (ui::iconButton(
            {.id = "to_template", .icon = Icon::ChevronRight, .label = tr("inspector.to_template"), .size = 26})) {
        editor.chosenTemplate = primary.templateId;
        editor.inspectTemplate = true;
    }
}

void InspectorPanel::drawGroupRow(Editor& editor, const io::Object& primary)
{
    const io::Object* group = editor.document()->scene().find(primary.parent);
    if (!group) return;
    ui::propertyLabel(tr("field.object.parent"));
    const std::string name = displayName(editor.document()->scene(), *group);
    if (ui::button("parent", name.c_str(), ui::Emphasis::Normal, {-1, 0})) editor.selection().set(group->id);
}

void InspectorPanel::drawTransform(Editor& editor, const io::Object& primary)
{
    const bool isGroup = primary.templateId == io::TemplateId::None;
    FieldUiOptions options{.prefix = "object.", .mixed = m_mixed};
    if (isGroup) options.enabled = [](std::string_view key) { return key == "object.position"; };
    FieldUi ui{std::move(options)};
    io::Transform shown = primary.transform;
    fields(ui, shown);
    if (ui.changes().empty()) return;
    std::vector<ScalarChange> changes = ui.changes();
    for (ScalarChange& change : changes)
        change.relative = change.relative && editor.selection().size() > 1; // one takes exactly what is shown
    applyToSelection(editor, ui, changes);
}

void InspectorPanel::drawFacts(const io::Object& primary) const
{
    const auto fact = [](const char* key, const std::string& value) {
        ui::propertyLabel(tr(key));
        ui::softText(value);
        mapItem("label", tr(key), value);
    };
    const glm::dvec3 size = m_bounds.size();
    if (!m_bounds.empty()) fact("inspector.size", trf("inspector.size_text", size.x, size.y, size.z));
    fact("inspector.triangles", grouped(m_triangles));
    if (primary.templateId == io::TemplateId::None) fact("inspector.members", grouped(m_members));
}

void InspectorPanel::drawTemplate(Editor& editor, io::TemplateId id)
{
    const io::Template& what = *editor.document()->scene().find(id);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    constexpr float kPicture = 84;
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + kPicture, at.y + kPicture}, palette::kField, 4);
    if (editor.renderer()) {
        const renderer::Picture picture = editor.renderer()->thumbnail(id, int(128 * pixelsPerPoint()));
        ImGui::GetWindowDrawList()->AddImageRounded(reinterpret_cast<ImTextureID>(picture.texture), at,
                                                    {at.x + kPicture, at.y + kPicture}, {0, 1}, {1, 0}, IM_COL32_WHITE,
                                                    4);
    }
    ImGui::Dummy({kPicture, kPicture});
    ImGui::SameLine(0, 12);
    ImGui::BeginGroup();
    ui::heading(what.name.c_str());
    ui::softText(tr("inspector.is_template"));
    const bool back = ui::button("back", tr("inspector.back"));
    ImGui::EndGroup();
    ImGui::Dummy({0, 2});

    io::Template shown = what;
    std::string listKey, listWhat; // of a list that was changed
    const auto lists = [&](std::string_view key) {
        const bool actions = key == "template.trigger.actions" && triggerActions(*editor.document(), shown.trigger.actions, listWhat);
        const bool curve = key == "template.sound.falloff" && falloffCurve(shown.sound.falloff, shown.sound.radius);
        if (actions || curve) listKey = key;
    };
    const auto files = [&](std::string_view key) {
        const bool sound = key == "template.sound.file" || key == "template.steps";
        return sound ? filesIn(editor.document()->project().folder, "sounds") : std::vector<std::string>{};
    };
    FieldUi ui{{.prefix = "template.", .defaults = scalarsOf(io::Template{}), .lists = lists, .files = files}};
    if (ui::section("template", tr("section.template"))) fields(ui, shown);
    if (!ui.changes().empty()) {
        editor.beginEdit("template." + ui.changedKey(), trf("undo.edit", ui.changedLabel()));
        setTemplate(*editor.document(), ui.changedLabel(), id, std::move(shown));
    } else if (!listKey.empty()) {
        const std::string name = trf("undo.edit", tr(listKey.ends_with("falloff") ? "falloff.curve" : "triggers.actions"));
        editor.beginEdit(listKey + listWhat, name);
        setTemplate(*editor.document(), name, id, std::move(shown));
    }
    if (back) editor.inspectTemplate = false;
}

} // namespace editor
