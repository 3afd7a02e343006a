#include "editor/panels/terrain_panel.h"

#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/painting.h"
#include "editor/panels/grass_kinds.h"
#include "editor/stamp_file.h"
#include "editor/project_files.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/base/contract.h"
#include "io/base/log.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace editor {
namespace {

namespace fs = std::filesystem;

constexpr double kLookEvery = 2; // s

// change(layers, numbers): which one each was; what was painted goes with them.
void changeLayers(Editor& editor, const char* stepKey, auto&& change)
{
    std::vector<io::TerrainLayer> layers = editor.document()->scene().terrain().layers;
    std::vector<int> numbers(layers.size()), newNumbers(layers.size(), -1);
    std::iota(numbers.begin(), numbers.end(), 0);
    change(layers, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        newNumbers[std::size_t(numbers[i])] = int(i);
    editor.step(stepKey, [&](Document& document) { setLayers(document, tr(stepKey), std::move(layers), newNumbers); });
}

std::vector<std::string> layerNames(const Document& document)
{
    std::vector<std::string> names;
    for (const io::TerrainLayer& layer : document.scene().terrain().layers)
        names.push_back(layer.name.empty() ? tr("ground.nameless") : layer.name);
    return names;
}

void layerChoice(const Document& document, const char* key, int& layer)
{
    std::vector<std::string> names = layerNames(document);
    if (names.empty()) return;
    names.resize(std::min<std::size_t>(names.size(), io::kMostLayers));
    layer = std::clamp(layer, 0, int(names.size()) - 1);
    ui::propertyLabel(tr(key));
    ImGui::PushID(key);
    ui::combo("##layer", tr(key), names, layer);
    ImGui::PopID();
}

} // namespace

void TerrainPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    refreshFiles(editor);
    wholeGround(editor);
    sculpting(editor);
    measures(editor);
    layers(editor);
    if (editor.document()->scene().heights()) drawGrassKinds(editor);
}

void TerrainPanel::refreshFiles(Editor& editor)
{
    if (editor.time() < m_nextLook) return;
    m_nextLook = editor.time() + kLookEvery;
    const fs::path& project = editor.document()->project().folder;
    m_heightMaps = filesIn(project, "terrain");
    m_textures = filesIn(project, "textures");
}

const std::vector<std::string>& TerrainPanel::filesFor(std::string_view key) const
{
    static const std::vector<std::string> none;
    if (key == "terrain.height_map") return m_heightMaps;
    return key.ends_with("texture") ? m_textures : none;
}

void TerrainPanel::wholeGround(Editor& editor)
{
    const float half = (ImGui::GetContentRegionAvail().x - 4) / 2;
    if (ui::button("generate", tr("action.generate_ground"), ui::Emphasis::Normal, {half, 0})) editor.groundDialogs().showGenerate(editor);
    if (!editor.document()->scene().heights()) return;
    ImGui::SameLine(0, 4);
    if (ui::button("reshape", tr("action.reshape_ground"), ui::Emphasis::Normal, {half, 0})) editor.groundDialogs().showReshape(editor);
}

// A tool takes the brush in hand; pressed again it is put down.
void TerrainPanel::sculpting(Editor& editor)
{
    if (!editor.document()->scene().heights() || !ui::section("sculpt", tr("section.sculpt"))) return;
    Viewport& viewport = editor.viewport();
    constexpr int kColumns = 3;
    const auto names = enumNames(viewport.brush.tool);
    const float width = (ImGui::GetContentRegionAvail().x - 4 * (kColumns - 1)) / kColumns;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bool on = viewport.sculpting && viewport.brush.tool == BrushTool(i);
        if (i % kColumns > 0) ImGui::SameLine(0, 4);
        if (!ui::button(names[i].data(), tr("brush." + std::string{names[i]}), on ? ui::Emphasis::Accent : ui::Emphasis::Normal, {width, 0}))
            continue;
        if (on) viewport.sculpting = false;
        else viewport.sculptWith(editor, BrushTool(i));
    }
    const bool layered = viewport.brush.tool == BrushTool::Paint || viewport.brush.tool == BrushTool::Replace;
    if (growsGrass(viewport.brush.tool)) grassChoice(editor, viewport.brush);
    if (layered) layerChoice(*editor.document(), "ground.layer", viewport.brush.layer);
    if (viewport.brush.tool == BrushTool::Replace) layerChoice(*editor.document(), "ground.replaced", viewport.brush.replaced);
    FieldUi ui{{.prefix = "brush.",
                .defaults = scalarsOf(Brush{.tool = viewport.brush.tool, .levelGiven = viewport.brush.levelGiven}),
                .files = [this](std::string_view key) { return key == "brush.stamp" ? m_textures : std::vector<std::string>{}; }}};
    fields(ui, viewport.brush);
    if (ui.changedKey() == "brush.stamp") viewport.readStamp(*editor.document());
    if (layered || viewport.brush.tool == BrushTool::Erase) {
        if (ui::button("fill", tr("ground.fill")))
            editor.step("undo.fill", [&](Document& document) { fillCover(document, tr("undo.fill"), viewport.brush); });
        if (ImGui::IsItemHovered()) ui::tooltip(tr("ground.fill_tip"));
    } else if (growsGrass(viewport.brush.tool)) {
        if (ui::button("fill_grass", tr("ground.fill")))
            editor.step("undo.fill_grass", [&](Document& document) { fillGrass(document, tr("undo.fill_grass"), viewport.brush); });
        if (ImGui::IsItemHovered()) ui::tooltip(tr("ground.fill_tip"));
    } else {
        ui::checkbox("follow", tr("ground.follow"), viewport.objectsFollow);
    }
    ui::softText(growsGrass(viewport.brush.tool) ? tr("grass.keys") : paints(viewport.brush.tool) ? tr("ground.paint_keys") : tr("ground.brush_keys"));
}

void TerrainPanel::measures(Editor& editor)
{
    io::Terrain shown = editor.document()->scene().terrain();
    FieldUi ui{{.prefix = "terrain.", .files = [this](std::string_view key) { return filesFor(key); }}};
    if (ui::section("terrain", tr("section.terrain"))) {
        fields(ui, shown);
        if (const io::HeightMap* map = editor.document()->scene().heights().get())
            ui::softText(trf("ground.facts", map->size.x, map->size.y, map->min, map->max));
        if (ui::button("import", tr("ground.import"))) editor.actions().run("import_heights");
        ImGui::SameLine(0, 4);
        if (editor.document()->scene().heights() && ui::button("export", tr("ground.export"))) editor.actions().run("export_heights");
    }
    if (!ui.changes().empty()) {
        editor.beginEdit(ui.changedKey(), trf("undo.edit", ui.changedLabel()));
        if (const io::Status set = setTerrain(*editor.document(), ui.changedLabel(), std::move(shown)); !set)
            editor.toasts().add(io::log::Level::Error, set.error().text());
    }
}

void TerrainPanel::layers(Editor& editor)
{
    ImGui::Dummy({0, 2});
    if (!ui::section("layers", tr("ground.layers"))) return;
    ui::softText(tr("ground.order"));
    for (std::size_t i = 0; i < editor.document()->scene().terrain().layers.size(); ++i) {
        ImGui::PushID(int(i));
        const std::string name = editor.document()->scene().terrain().layers[i].name;
        if (ui::section("layer", name.empty() ? tr("ground.nameless") : name.c_str(), false) &&
            layerButtons(editor, i))
            layerFields(editor, i);
        ImGui::PopID();
    }
    ImGui::Dummy({0, 2});
    if (editor.document()->scene().terrain().layers.size() < io::kMostLayers && ui::button("add", tr("ground.add")))
        changeLayers(editor, "undo.add_layer", [](std::vector<io::TerrainLayer>& list, std::vector<int>&) {
            list.push_back({.name = tr("ground.new_name")});
        });
}

bool TerrainPanel::layerButtons(Editor& editor, std::size_t index)
{
    const std::size_t last = editor.document()->scene().terrain().layers.size() - 1;
    const auto button = [](const char* id, Icon icon, const char* text, bool enabled) {
        const bool pressed =
            ui::iconButton({.id = id, .icon = icon, .label = tr(text), .enabled = enabled, .size = 24});
        ImGui::SameLine(0, 2);
        return pressed;
    };
    const bool up = button("up", Icon::Up, "ground.earlier", index > 0);
    const bool down = button("down", Icon::ChevronDown, "ground.later", index < last);
    const bool remove = button("remove", Icon::Trash, "ground.remove", true);
    ImGui::NewLine();
    const auto exchange = [&](std::size_t with) {
        changeLayers(editor, "undo.move_layer", [=](auto& list, auto& numbers) {
            std::swap(list[index], list[with]);
            std::swap(numbers[index], numbers[with]);
        });
    };
    if (up) exchange(index - 1);
    if (down) exchange(index + 1);
    if (remove)
        changeLayers(editor, "undo.remove_layer", [=](auto& list, auto& numbers) {
            list.erase(list.begin() + long(index));
            numbers.erase(numbers.begin() + long(index));
        });
    return !up && !down && !remove;
}

void TerrainPanel::layerFields(Editor& editor, std::size_t index)
{
    io::Terrain shown = editor.document()->scene().terrain();
    FieldUi ui{{.prefix = "layer.",
                .defaults = scalarsOf(io::TerrainLayer{}),
                .files = [this](std::string_view key) { return filesFor(key); }}};
    fields(ui, shown.layers[index]);
    if (ui.changes().empty()) return;
    editor.beginEdit(ui.changedKey() + std::to_string(index), trf("undo.edit", ui.changedLabel()));
    EXPECTS(setTerrain(*editor.document(), ui.changedLabel(), std::move(shown))); // the heights are the same
}

} // namespace editor
