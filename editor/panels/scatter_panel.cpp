#include "editor/panels/scatter_panel.h"

#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/instance_edits.h"
#include "editor/numbers_text.h"
#include "editor/scatter_steps.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>

namespace editor {
namespace {

constexpr float kGap = 4; // pixels between buttons

std::vector<io::ScatterLayer> listOf(const Document& document)
{
    return {document.scene().scatterLayers().begin(), document.scene().scatterLayers().end()};
}

// change(layer) on the one of that id; the step is the caller's.
void change(Document& document, const std::string& name, io::ScatterId id, auto&& changeLayer)
{
    std::vector<io::ScatterLayer> list = listOf(document);
    const auto layer = std::ranges::find(list, id, &io::ScatterLayer::id);
    if (layer == list.end()) return;
    changeLayer(*layer);
    setScatterLayers(document, name, std::move(list));
}

std::string freeName(const io::Scene& scene)
{
    std::string name = tr("plants.new_name");
    for (int i = 2; scene.findScatterLayer(name); ++i)
        name = std::string{tr("plants.new_name")} + " " + std::to_string(i);
    return name;
}

std::vector<std::string> templateNames(const io::Scene& scene)
{
    std::vector<std::string> names;
    for (const io::Scene::TemplateSlot& slot : scene.templates())
        if (slot.value) names.push_back(slot.name);
    std::ranges::sort(names);
    return names;
}

void addSpecies(Editor& editor, io::ScatterId id, io::TemplateId what)
{
    const std::string name{editor.document()->scene().templateName(what)};
    if (name.empty()) return;
    editor.step("undo.add_species", [&](Document& document) {
        change(document, tr("undo.add_species"), id, [&](io::ScatterLayer& layer) {
            if (layer.species.size() < io::kMostSpecies && std::ranges::find(layer.species, name, &io::Species::templateName) == layer.species.end())
                layer.species.push_back({.templateName = name});
        });
    });
}

void removeSpecies(Document& document, const std::string& name, const io::ScatterLayer& layer, std::size_t index)
{
    std::vector<io::Species> species = layer.species;
    species.erase(species.begin() + std::ptrdiff_t(index));
    setSpecies(document, name, layer.id, std::move(species));
}

void speciesChoice(const io::ScatterLayer& layer, const char* key, int& chosen, bool withAll)
{
    std::vector<std::string> names;
    if (withAll) names.push_back(tr("plants.all_species"));
    for (const io::Species& species : layer.species)
        names.push_back(species.templateName);
    if (names.empty()) return;
    int shown = std::clamp(chosen + int(withAll), 0, int(names.size()) - 1);
    ui::propertyLabel(tr(key));
    ImGui::PushID(key);
    ui::combo("##species", tr(key), names, shown);
    ImGui::PopID();
    chosen = shown - int(withAll);
}

} // namespace

void ScatterPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    Viewport& viewport = editor.viewport();
    if (!viewport.scatterTarget(*editor.document()) && !editor.document()->scene().scatterLayers().empty())
        viewport.scatterLayer = editor.document()->scene().scatterLayers().front().id;
    const bool open = ui::section("plants", tr("plants.layers"));
    if (open) layers(editor);
    const io::ScatterLayer* chosen = viewport.scatterTarget(*editor.document());
    if (!chosen) return;
    const io::ScatterLayer layer = *chosen;
    if (open) grow(editor, layer);
    brush(editor, layer);
    species(editor, layer);
    settings(editor, layer);
    conversion(editor, layer);
}

void ScatterPanel::layers(Editor& editor)
{
    const Document& document = *editor.document();
    Viewport& viewport = editor.viewport();
    for (const io::ScatterLayer& layer : listOf(document)) {
        ImGui::PushID(int(io::number(layer.id)));
        if (ui::iconButton({.id = "shown", .icon = Icon::Eye, .label = tr("plants.shown"), .on = layer.shown, .size = 24}))
            editor.step("undo.show_plants", [&](Document& d) { change(d, tr("undo.show_plants"), layer.id, [](io::ScatterLayer& l) { l.shown = !l.shown; }); });
        ImGui::SameLine(0, kGap);
        const std::string text = layer.name + "   " + grouped(io::instanceCount(document.scene().instances(layer.id)));
        const float width = ImGui::GetContentRegionAvail().x - 24 - kGap;
        if (ui::button("layer", ui::fitted(text, width - 16).c_str(), layer.id == viewport.scatterLayer ? ui::Emphasis::Accent : ui::Emphasis::Normal, {width, 0}))
            viewport.scatterLayer = layer.id;
        ImGui::SameLine(0, kGap);
        if (ui::iconButton({.id = "remove", .icon = Icon::Trash, .label = tr("plants.remove"), .size = 24}))
            editor.step("undo.remove_plants", [&](Document& d) { removeScatterLayer(d, tr("undo.remove_plants"), layer.id); });
        ImGui::PopID();
    }
    if (!ui::button("add", tr("plants.add"))) return;
    editor.step("undo.add_plants", [&](Document& d) {
        std::vector<io::ScatterLayer> list = listOf(d);
        list.push_back({.id = d.freshScatterId(), .name = freeName(d.scene())});
        if (d.scene().find(editor.chosenTemplate)) list.back().species = {{.templateName = std::string{d.scene().templateName(editor.chosenTemplate)}}};
        viewport.scatterLayer = list.back().id;
        setScatterLayers(d, tr("undo.add_plants"), std::move(list));
    });
}

// A mode takes the brush in hand; pressed again it is put down.
void ScatterPanel::brush(Editor& editor, const io::ScatterLayer& layer)
{
    if (!ui::section("scatter_brush", tr("plants.brush"))) return;
    Viewport& viewport = editor.viewport();
    ScatterBrush& brush = viewport.scatterBrush;
    constexpr int kColumns = 3;
    const auto names = enumNames(brush.mode);
    const float width = (ImGui::GetContentRegionAvail().x - kGap * (kColumns - 1)) / kColumns;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bool on = viewport.scattering && brush.mode == ScatterMode(i);
        if (i % kColumns > 0) ImGui::SameLine(0, kGap);
        if (!ui::button(names[i].data(), tr("scatter_mode." + std::string{names[i]}), on ? ui::Emphasis::Accent : ui::Emphasis::Normal, {width, 0})) continue;
        if (on) viewport.scattering = false;
        else viewport.scatterWith(editor, ScatterMode(i));
    }
    FieldUi ui{{.prefix = "scatter_brush.", .defaults = scalarsOf(ScatterBrush{.mode = brush.mode})}};
    fields(ui, brush);
    if (brush.mode == ScatterMode::Erase || brush.mode == ScatterMode::Thin) speciesChoice(layer, "plants.only", brush.species, true);
    else if (brush.mode != ScatterMode::Replace) brush.species = -1;
    if (brush.mode == ScatterMode::Replace) {
        brush.species = std::max(brush.species, 0);
        speciesChoice(layer, "plants.replaced", brush.species, false);
        speciesChoice(layer, "plants.instead", brush.instead, false);
    }
    ui::softText(tr("plants.brush_keys"));
}

void ScatterPanel::species(Editor& editor, const io::ScatterLayer& layer)
{
    if (!ui::section("species", tr("plants.species"))) return;
    const std::vector<std::string> names = templateNames(editor.document()->scene());
    for (std::size_t i = 0; i < layer.species.size(); ++i) {
        ImGui::PushID(int(i));
        io::Species shown = layer.species[i];
        FieldUi ui{{.prefix = "species.", .defaults = scalarsOf(io::Species{}), .files = [&](std::string_view) { return names; }}};
        fields(ui, shown);
        if (!ui.changes().empty()) {
            editor.beginEdit(ui.changedKey() + std::to_string(i), trf("undo.edit", ui.changedLabel()));
            change(*editor.document(), ui.changedLabel(), layer.id, [&](io::ScatterLayer& l) { l.species[i] = shown; });
        }
        const bool gone = ui::button("remove", tr("plants.remove_species"));
        ImGui::PopID();
        if (!gone) continue;
        editor.step("undo.remove_species", [&](Document& d) { removeSpecies(d, tr("undo.remove_species"), layer, i); });
        return;
    }
    if (ui::button("add_species", tr("plants.add_species"))) {
        const auto unused = std::ranges::find_if(names, [&](const std::string& name) { return std::ranges::find(layer.species, name, &io::Species::templateName) == layer.species.end(); });
        io::TemplateId what = editor.chosenTemplate;
        if (!editor.document()->scene().find(what) && unused != names.end()) what = editor.document()->scene().findTemplate(*unused);
        addSpecies(editor, layer.id, what);
    }
    if (ImGui::BeginDragDropTarget()) {
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload("template")) addSpecies(editor, layer.id, *static_cast<const io::TemplateId*>(payload->Data));
        ImGui::EndDragDropTarget();
    }
    ui::softText(tr("plants.drag_here"));
}

void ScatterPanel::settings(Editor& editor, const io::ScatterLayer& layer)
{
    if (!ui::section("plant_rules", tr("plants.settings"))) return;
    io::ScatterLayer shown = layer;
    std::vector<std::string> grounds{""};
    for (const io::TerrainLayer& ground : editor.document()->scene().terrain().layers)
        grounds.push_back(ground.name);
    FieldUi ui{{.prefix = "scatter.",
                .defaults = scalarsOf(io::ScatterLayer{.name = layer.name}),
                .files = [&](std::string_view key) { return key == "scatter.ground" ? grounds : std::vector<std::string>{}; }}};
    fields(ui, shown);
    if (ui.changes().empty()) return;
    const io::ScatterLayer* other = editor.document()->scene().findScatterLayer(shown.name);
    if (shown.name.empty() || (other && other->id != layer.id)) shown.name = layer.name;
    editor.beginEdit(ui.changedKey() + std::to_string(io::number(layer.id)), trf("undo.edit", ui.changedLabel()));
    change(*editor.document(), ui.changedLabel(), layer.id, [&](io::ScatterLayer& l) { l = shown; });
}

void ScatterPanel::conversion(Editor& editor, const io::ScatterLayer& layer)
{
    if (!ui::section("convert", tr("plants.convert"))) return;
    const float half = (ImGui::GetContentRegionAvail().x - kGap) / 2;
    if (ui::button("to_objects", tr("plants.to_objects"), ui::Emphasis::Normal, {half, 0}))
        editor.step("undo.plants_to_objects", [&](Document& d) { plantsToObjects(d, tr("undo.plants_to_objects"), layer.id, PlantRegion::everywhere()); });
    ImGui::SameLine(0, kGap);
    if (ui::button("to_plants", tr("plants.to_plants"), ui::Emphasis::Normal, {half, 0}))
        editor.step("undo.objects_to_plants", [&](Document& d) { demote(d, tr("undo.objects_to_plants"), editor.selection().ids(), layer.id); });
    ui::softText(tr("plants.convert_tip"));
}

// All over the ground at once.
void ScatterPanel::grow(Editor& editor, const io::ScatterLayer& layer)
{
    const float half = (ImGui::GetContentRegionAvail().x - kGap) / 2;
    if (ui::button("grow", tr(layer.rule ? "plants.evaluate" : "plants.fill"), ui::Emphasis::Accent, {half, 0})) editor.growPlants(layer);
    ImGui::SameLine(0, kGap);
    if (ui::button("clear", tr("plants.clear"), ui::Emphasis::Normal, {half, 0}))
        editor.step("undo.clear_plants", [&](Document& d) { clearPlants(d, tr("undo.clear_plants"), layer.id); });
    work(editor);
}

void ScatterPanel::work(Editor& editor)
{
    if (!editor.plantsWork().busy()) return;
    ui::progressBar(editor.plantsWork().fraction(), ImGui::GetContentRegionAvail().x - 90);
    ImGui::SameLine(0, kGap);
    if (ui::button("stop", tr("plants.stop"))) editor.plantsWork().cancel();
}

} // namespace editor
