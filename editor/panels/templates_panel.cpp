#include "editor/panels/templates_panel.h"

#include "editor/delete_template.h"
#include "editor/editor.h"
#include "editor/numbers_text.h"
#include "editor/search_text.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>

namespace editor {
namespace {

constexpr int kPicturesAFrame = 2; // more would be felt as a jerk
constexpr float kCaption = 24;     // pixels under a picture
constexpr float kCategories = 150;

} // namespace

void TemplatesPanel::follow(const Document& document, const io::Changes& changes)
{
    if (changes.everything) m_drawn.clear();
    for (const io::TemplateId id : changes.templates)
        m_drawn.erase(io::number(id));
    if (!changes.everything && changes.templates.empty()) return;
    m_categories.clear();
    for (const io::Scene::TemplateSlot& slot : document.scene().templates())
        if (slot.value) ++m_categories[slot.value->category];
    if (!m_categories.contains(m_category)) m_category.clear();
}

void TemplatesPanel::draw(Editor& editor)
{
    if (!editor.document()) return;
    m_newPictures = 0;
    categories(editor);
    ImGui::SameLine(0, 12);
    ImGui::BeginChild("##right", {0, 0});
    header(editor);
    grid(editor);
    ImGui::EndChild();
}

void TemplatesPanel::categories(Editor& editor)
{
    ImGui::BeginChild("##categories", {kCategories, 0});
    int total = 0;
    for (const auto& [name, count] : m_categories)
        total += count;
    const auto entry = [&](const std::string& category, const std::string& text, int count) {
        const ImVec2 min = ImGui::GetCursorScreenPos();
        const ImVec2 max{min.x + ImGui::GetContentRegionAvail().x, min.y + 26};
        if (ImGui::InvisibleButton(("category." + category).c_str(), {max.x - min.x, 26})) m_category = category;
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const bool on = m_category == category;
        if (on || ImGui::IsItemHovered())
            draw.AddRectFilled(min, max, on ? IM_COL32(98, 68, 184, 140) : IM_COL32(255, 255, 255, 12), 3);
        draw.AddText({min.x + 10, min.y + 5}, on ? IM_COL32_WHITE : palette::kText, text.c_str());
        const std::string number = std::to_string(count);
        draw.AddText({max.x - ImGui::CalcTextSize(number.c_str()).x - 8, min.y + 5}, palette::kFaintText,
                     number.c_str());
        mapItem("category", text, on);
    };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{0, 1});
    entry("", tr("templates.all"), total);
    for (const auto& [name, count] : m_categories)
        if (!name.empty()) entry(name, name, count);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    (void)editor;
}

void TemplatesPanel::header(Editor& editor)
{
    ImGui::SetNextItemWidth(std::min(280.f, ImGui::GetContentRegionAvail().x));
    ui::searchField("##search", tr("templates.search"), m_search);
    if (editor.viewport().placing() == io::TemplateId::None) return;
    ImGui::SameLine(0, 8);
    if (ui::button("stop", tr("templates.stop"), ui::Emphasis::Accent)) editor.viewport().stopPlacing();
}

bool TemplatesPanel::shown(const Document& document, io::TemplateId id) const
{
    const io::Template* what = document.scene().find(id);
    return what && (m_category.empty() || what->category == m_category) && holds(what->name, lowerCase(m_search));
}

void TemplatesPanel::grid(Editor& editor)
{
    const Document& document = *editor.document();
    std::vector<io::TemplateId> ids;
    for (std::size_t i = 0; i < document.scene().templates().size(); ++i)
        if (const io::TemplateId id{std::uint32_t(i + 1)}; shown(document, id)) ids.push_back(id);
    std::sort(ids.begin(), ids.end(), [&](io::TemplateId a, io::TemplateId b) {
        const io::Template &x = *document.scene().find(a), &y = *document.scene().find(b);
        return std::tie(x.category, x.name) < std::tie(y.category, y.name);
    });
    ImGui::BeginChild("##grid", {0, 0});
    if (ids.empty()) ui::emptyState(Icon::Tree, tr("templates.empty"), tr("templates.empty_text"));
    const int columns = std::max(1, int((ImGui::GetContentRegionAvail().x + 8) / (m_size + 8)));
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (i % std::size_t(columns) != 0) ImGui::SameLine(0, 8);
        card(editor, ids[i]);
    }
    ImGui::EndChild();
}

void TemplatesPanel::card(Editor& editor, io::TemplateId id)
{
    const Document& document = *editor.document();
    const std::string name{document.scene().templateName(id)};
    ImGui::PushID(int(io::number(id)));
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max{min.x + m_size, min.y + m_size + kCaption};
    if (ImGui::InvisibleButton("card", {m_size, m_size + kCaption})) {
        editor.chosenTemplate = id;
        editor.inspectTemplate = true;
        editor.viewport().beginPlacing(id);
    }
    const bool hovered = ImGui::IsItemHovered();
    const bool placing = editor.viewport().placing() == id;
    const bool chosen = placing || editor.chosenTemplate == id;
    mapItem("template", name, placing);
    if (ImGui::BeginDragDropSource()) {
        ImGui::SetDragDropPayload("template", &id, sizeof id);
        ImGui::TextUnformatted(name.c_str());
        ImGui::EndDragDropSource();
    } else if (hovered && !ImGui::IsMouseDown(0)) {
        ui::tooltip(cardTip(document, id).c_str());
    }
    cardMenu(editor, id);

    if (ImGui::IsRectVisible(min, max)) {
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.AddRectFilled(min, max, hovered ? palette::kHover : palette::kRaised, 5);
        picture(editor, id, min, m_size);
        const std::string caption = ui::fitted(name, m_size - 12);
        const float width = ImGui::CalcTextSize(caption.c_str()).x;
        draw.AddText({min.x + std::floor((m_size - width) / 2), max.y - kCaption + 4}, palette::kText, caption.c_str());
        if (chosen)
            draw.AddRect(min, max, placing ? palette::kAccent : palette::kAccentDeep, 5, 0, placing ? 2.f : 1.5f);
    }
    ImGui::PopID();
}

void TemplatesPanel::picture(Editor& editor, io::TemplateId id, ImVec2 min, float size)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 max{min.x + size, min.y + size};
    const bool ready = m_drawn.contains(io::number(id));
    if (!editor.renderer() || (!ready && m_newPictures >= kPicturesAFrame)) {
        draw.AddRectFilled(min, max, palette::kField, 5, ImDrawFlags_RoundCornersTop);
        return drawIcon(draw, Icon::Cube, {min.x + size / 2 - 14, min.y + size / 2 - 14}, 28, palette::kFaintText);
    }
    if (!ready) ++m_newPictures;
    m_drawn.insert(io::number(id));
    const renderer::Picture shown = editor.renderer()->thumbnail(id, int(128 * pixelsPerPoint()));
    draw.AddImageRounded(reinterpret_cast<ImTextureID>(shown.texture), min, max, {0, 1}, {1, 0}, IM_COL32_WHITE, 5,
                         ImDrawFlags_RoundCornersTop);
}

std::string TemplatesPanel::cardTip(const Document& document, io::TemplateId id) const
{
    std::size_t placed = 0;
    for (const io::Object& object : document.scene().objects())
        placed += object.templateId == id;
    const io::Model* model = document.assets().model(id);
    return trf("templates.tip", document.scene().templateName(id), grouped(model ? model->triangles() : 0),
               grouped(placed));
}

void TemplatesPanel::cardMenu(Editor& editor, io::TemplateId id)
{
    if (!ImGui::BeginPopupContextItem("menu")) return;
    const MapPanel map{"popup"};
    editor.chosenTemplate = id;
    if (ui::menuItem(tr("templates.place"), nullptr, false, true, Icon::Place)) editor.viewport().beginPlacing(id);
    if (ui::menuItem(tr("templates.edit"), nullptr, false, true, Icon::Sliders)) {
        editor.inspectTemplate = true;
        editor.workspace().bringToFront("inspector");
    }
    if (ui::menuItem(tr("templates.select_all"), nullptr, false, true, Icon::Select)) {
        std::vector<io::ObjectId> ids;
        for (const io::Object& object : editor.document()->scene().objects())
            if (object.templateId == id) ids.push_back(object.id);
        editor.inspectTemplate = false;
        editor.selection().set(ids);
    }
    ImGui::Separator();
    if (ui::menuItem(tr("templates.delete"), nullptr, false, true, Icon::Trash)) askToDelete(editor, id);
    ImGui::EndPopup();
}

// Without objects of it there is nothing to ask: Undo brings it back.
void TemplatesPanel::askToDelete(Editor& editor, io::TemplateId id)
{
    const std::string name{editor.document()->scene().templateName(id)};
    const TemplateUse use = useOf(*editor.document(), id);
    const auto remove = [&editor, id, name] {
        editor.step("undo.delete_template", [&](Document& document) { (void)deleteTemplate(document, id, true); });
        editor.toasts().add(io::log::Level::Info, trf("templates.deleted", name));
    };
    if (!use.scenes.empty())
        return editor.dialogs().showMessage(trf("templates.cannot_delete", name),
                                            trf("templates.used_elsewhere", fmt::join(use.scenes, ", ")));
    if (use.objects.empty()) return remove();
    editor.dialogs().confirm(trf("templates.delete_title", name),
                             trf("templates.delete_text", grouped(use.objects.size())), tr("templates.delete_accept"),
                             remove);
}

} // namespace editor
