#include "editor/panels/grass_kinds.h"

#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/painting.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <numeric>
#include <string_view>

namespace editor {
namespace {

std::string nameOf(const io::GrassKind& kind)
{
    return kind.name.empty() ? tr("grass.nameless") : kind.name;
}

void removeKind(Editor& editor, std::size_t index)
{
    std::vector<io::GrassKind> kinds = editor.document()->scene().grass().kinds;
    std::vector<int> numbers(kinds.size());
    std::iota(numbers.begin(), numbers.begin() + long(index), 0);
    numbers[index] = -1;
    std::iota(numbers.begin() + long(index) + 1, numbers.end(), int(index));
    kinds.erase(kinds.begin() + long(index));
    editor.step("undo.remove_grass", [&](Document& document) { setGrassKinds(document, tr("undo.remove_grass"), std::move(kinds), numbers); });
}

void addKind(Editor& editor)
{
    io::Grass grass = editor.document()->scene().grass();
    grass.kinds.push_back({.name = tr("grass.new_name")});
    editor.step("undo.add_grass", [&](Document& document) { setGrass(document, tr("undo.add_grass"), std::move(grass)); });
}

void kindFields(Editor& editor, std::size_t index)
{
    io::Grass shown = editor.document()->scene().grass();
    const auto templates = [&](std::string_view key) {
        std::vector<std::string> names;
        if (key != "grass_kind.plant") return names;
        for (const io::Scene::TemplateSlot& slot : editor.document()->scene().templates())
            if (slot.value && !slot.value->model.empty()) names.push_back(slot.name);
        std::ranges::sort(names);
        return names;
    };
    FieldUi ui{{.prefix = "grass_kind.", .defaults = scalarsOf(io::GrassKind{}), .files = templates}};
    fields(ui, shown.kinds[index]);
    if (ui.changes().empty()) return;
    editor.beginEdit(ui.changedKey() + std::to_string(index), trf("undo.edit", ui.changedLabel()));
    setGrass(*editor.document(), ui.changedLabel(), std::move(shown));
}

} // namespace

void grassChoice(Editor& editor, Brush& brush)
{
    std::vector<std::string> names;
    for (const io::GrassKind& kind : editor.document()->scene().grass().kinds)
        names.push_back(nameOf(kind));
    if (names.empty()) return ui::softText(tr("grass.none"));
    brush.kind = std::clamp(brush.kind, 0, int(names.size()) - 1);
    if (brush.tool == BrushTool::GrassHeight || (brush.tool == BrushTool::Mow && brush.everyKind)) return;
    ui::propertyLabel(tr("grass.kind"));
    ui::combo("##kind", tr("grass.kind"), names, brush.kind);
}

void drawGrassKinds(Editor& editor)
{
    ImGui::Dummy({0, 2});
    if (!ui::section("grass_kinds", tr("grass.kinds"))) return;
    for (std::size_t i = 0; i < editor.document()->scene().grass().kinds.size(); ++i) {
        ImGui::PushID(int(i));
        const std::string name = nameOf(editor.document()->scene().grass().kinds[i]);
        if (ui::section("kind", name.c_str(), false)) {
            const bool remove = ui::iconButton({.id = "remove", .icon = Icon::Trash, .label = tr("grass.remove"), .enabled = true, .size = 24});
            if (remove) removeKind(editor, i);
            else kindFields(editor, i);
        }
        ImGui::PopID();
    }
    ImGui::Dummy({0, 2});
    if (editor.document()->scene().grass().kinds.size() < io::kMostGrassKinds && ui::button("add_grass", tr("grass.add"))) addKind(editor);
}

} // namespace editor
