#include "editor/dialogs/ground_dialogs.h"

#include "editor/dialogs/dialog_frame.h"
#include "editor/editor.h"
#include "editor/field_ui.h"
#include "editor/ground_picture.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/base/random.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

constexpr const char* kId = "##ground";
constexpr int kPreview = 161;     // texels along its longer side
constexpr float kPicture = 322;   // pixels
constexpr float kWide = 120;      // of a button
constexpr float kFieldsHeight = 470;

std::uint32_t fingerprint(const std::vector<std::uint32_t>& colours)
{
    std::uint32_t value = 0;
    for (const std::uint32_t colour : colours)
        value = io::hash(value + colour);
    return value;
}

} // namespace

// As large as the ground that is there, with forms to match.
void GroundDialogs::showGenerate(Editor& editor)
{
    m_which = Which::Generate;
    m_shown.reset();
    m_fault.clear();
    const auto& heights = editor.document()->scene().heights();
    if (!heights || glm::max(heights->size.x, heights->size.y) > kMostSide) return;
    const double extent = std::max(heights->size.x, heights->size.y) * heights->metresPerTexel;
    m_recipe.width = heights->size.x;
    m_recipe.depth = heights->size.y;
    m_recipe.metresPerTexel = heights->metresPerTexel;
    const GroundRecipe usual;
    const auto share = float(extent / (usual.width * usual.metresPerTexel));
    m_recipe.continents = std::max(1.0f, std::round(usual.continents * share));
    m_recipe.ridgeScale = std::max(1.0f, std::round(usual.ridgeScale * share));
    m_recipe.lowest = 0;
    m_recipe.highest = std::max(1.0f, std::round(usual.highest * share / 10) * 10);
}

void GroundDialogs::showReshape(Editor& editor)
{
    const auto& heights = editor.document()->scene().heights();
    if (!heights) return;
    m_which = Which::Reshape;
    m_fault.clear();
    m_oldSize = heights->size;
    m_oldMetres = heights->metresPerTexel;
    m_origin = heights->origin;
    m_byWidth = true;
    m_reshaping = {.kind = m_reshaping.kind, .width = m_oldSize.x, .metresPerTexel = m_oldMetres, .from = m_origin, .to = m_origin + glm::dvec2{m_oldSize - 1} * m_oldMetres};
}

void GroundDialogs::draw(Editor& editor)
{
    takePreview();
    if (!m_making) m_work.finished(); // what was cancelled has come to its end
    if (m_which == Which::None) return;
    if (!editor.document()) return close();
    const MapPanel map{"dialog"};
    if (!ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
    if (m_which == Which::Generate) drawGenerate(editor);
    else drawReshape(editor);
}

void GroundDialogs::close()
{
    m_which = Which::None;
    m_making = false;
    m_work.cancel();
    m_preview.cancel();
    if (ImGui::IsPopupOpen(kId)) ImGui::CloseCurrentPopup();
}

bool GroundDialogs::buttons(const char* accept, bool enabled)
{
    if (!m_fault.empty()) {
        ImGui::PushTextWrapPos(0);
        ui::iconText(Icon::Error, palette::kRed, m_fault);
        ImGui::PopTextWrapPos();
        mapItem("label", m_fault);
    }
    ImGui::Dummy({0, 6});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2 * kWide - 8);
    const bool cancelled = ui::button("cancel", tr("dialog.cancel"), ui::Emphasis::Normal, {kWide, 0}) || pressed(Key::Escape);
    ImGui::SameLine(0, 8);
    if (!enabled) ImGui::BeginDisabled();
    const bool accepted = ui::button("accept", accept, ui::Emphasis::Accent, {kWide, 0});
    if (!enabled) ImGui::EndDisabled();
    if (cancelled) close();
    return enabled && accepted && !cancelled;
}

void GroundDialogs::drawGenerate(Editor& editor)
{
    if (!beginDialog(kId, tr("ground.generate_title"), 790)) return;
    takeGround(editor);
    if (m_making) ImGui::BeginDisabled();
    ImGui::BeginChild("##recipe", {400, std::min(kFieldsHeight, ImGui::GetIO().DisplaySize.y - 190)});
    recipe();
    ImGui::EndChild();
    if (m_making) ImGui::EndDisabled();
    ImGui::SameLine(0, 22);
    ImGui::BeginGroup();
    picture(kPicture);
    const glm::dvec2 extent = glm::dvec2{m_recipe.width - 1, m_recipe.depth - 1} * m_recipe.metresPerTexel;
    ui::softText(trf("ground.extent", extent.x / 1000, extent.y / 1000));
    if (editor.document()->scene().heights()) {
        ui::checkbox("follow", tr("ground.follow"), editor.viewport().objectsFollow);
        if (editor.document()->scene().cover()) ui::softText(tr("ground.paint_goes"));
    }
    if (m_making) ui::progressBar(m_work.fraction(), kPicture);
    ImGui::EndGroup();
    beginPreview(editor);
    if (const auto fault = faultOf(m_recipe)) m_fault = *fault;
    else m_fault.clear();
    if (buttons(tr("ground.generate"), m_fault.empty() && !m_making && !m_work.busy())) {
        m_making = true;
        m_work.start(m_recipe, !editor.host().repeatable());
    }
    ImGui::EndPopup();
}

void GroundDialogs::recipe()
{
    if (ui::button("seed", tr("ground.another"), ui::Emphasis::Normal, {-1, 0})) m_recipe.seed = int(io::hash(std::uint32_t(m_recipe.seed) + 1) % 1'000'000);
    FieldUi ui{{.prefix = "recipe.", .defaults = scalarsOf(GroundRecipe{})}};
    fields(ui, m_recipe);
}

// As a mesh of coloured points: no texture has to be made.
void GroundDialogs::picture(float side)
{
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    mapItem("picture", tr("ground.preview"), m_colours.empty() ? io::Value{} : io::Value{fingerprint(m_colours)});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + side, low.y + side}, palette::kField, 3);
    if (m_colours.empty()) return;
    const float texel = side / float(std::max(m_size.x, m_size.y) - 1);
    const ImVec2 corner{low.x + (side - texel * float(m_size.x - 1)) / 2, low.y + (side - texel * float(m_size.y - 1)) / 2};
    draw.PrimReserve((m_size.x - 1) * (m_size.y - 1) * 6, m_size.x * m_size.y);
    const auto first = ImDrawIdx(draw._VtxCurrentIdx);
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    for (int z = 0; z < m_size.y; ++z)
        for (int x = 0; x < m_size.x; ++x)
            draw.PrimWriteVtx({corner.x + float(x) * texel, corner.y + float(z) * texel}, white, m_colours[std::size_t(z) * std::size_t(m_size.x) + std::size_t(x)]);
    for (int z = 0; z + 1 < m_size.y; ++z)
        for (int x = 0; x + 1 < m_size.x; ++x) {
            const int at = first + z * m_size.x + x;
            for (const int corners : {at, at + 1, at + m_size.x, at + 1, at + m_size.x + 1, at + m_size.x})
                draw.PrimWriteIdx(ImDrawIdx(corners));
        }
}

void GroundDialogs::beginPreview(Editor& editor)
{
    const GroundRecipe wanted = coarser(m_recipe, kPreview);
    if (m_making || (m_shown && *m_shown == wanted) || faultOf(wanted)) return;
    m_shown = wanted;
    m_preview.start(wanted, !editor.host().repeatable());
    takePreview();
}

void GroundDialogs::takePreview()
{
    const auto made = m_preview.finished();
    if (!made || !*made || !m_shown) return;
    m_size = (*made)->size;
    m_colours = shadedRelief(**made, m_shown->lowest, m_shown->highest);
}

void GroundDialogs::takeGround(Editor& editor)
{
    auto made = m_work.finished();
    if (!made || !m_making) return;
    m_making = false;
    if (!*made) return void(m_fault = made->error().text());
    NewGround ground{.heights = *std::move(*made), .range = glm::dvec2{m_recipe.lowest, m_recipe.highest}};
    const std::shared_ptr<const io::HeightMap> before = editor.document()->scene().heights();
    if (before) ground.heights.origin += before->origin + glm::dvec2{before->size - 1} * (before->metresPerTexel / 2);
    editor.step("undo.generate", [&](Document& document) { replaceGround(document, tr("undo.generate"), std::move(ground), editor.viewport().objectsFollow); });
    editor.viewport().stayAbove(*editor.document());
    close();
}

void GroundDialogs::drawReshape(Editor& editor)
{
    if (!beginDialog(kId, tr("ground.reshape_title"), 470)) return;
    const std::vector<std::string> kinds{tr("ground.resample"), tr("ground.crop"), tr("ground.offset")};
    int kind = int(m_reshaping.kind);
    ui::propertyLabel(tr("ground.kind"));
    if (ui::combo("##kind", tr("ground.kind"), kinds, kind)) m_reshaping.kind = Reshape(kind);
    constexpr const char* kTips[] = {"ground.resample_tip", "ground.crop_tip", "ground.offset_tip"};
    ui::softText(tr(kTips[kind]));
    ImGui::Dummy({0, 4});
    reshapeFields();
    ui::checkbox("follow", tr("ground.follow"), editor.viewport().objectsFollow);
    if (buttons(tr("ground.apply"), true)) {
        Reshaping wanted = m_reshaping;
        if (m_byWidth) wanted.metresPerTexel = 0;
        else wanted.width = 0;
        io::Result<NewGround> ground = reshaped(editor.document()->scene(), wanted);
        if (ground) {
            editor.step("undo.reshape", [&](Document& document) { replaceGround(document, tr("undo.reshape"), *std::move(ground), editor.viewport().objectsFollow); });
            close();
        } else {
            m_fault = ground.error().text();
        }
    }
    ImGui::EndPopup();
}

void GroundDialogs::reshapeFields()
{
    FieldUi ui{{.prefix = "reshape."}};
    fields(ui, m_reshaping);
    const double across = (m_oldSize.x - 1) * m_oldMetres, along = (m_oldSize.y - 1) * m_oldMetres;
    if (ui.changedKey() == "reshape.width") {
        m_byWidth = true;
        m_reshaping.metresPerTexel = across / std::max(1, m_reshaping.width - 1);
    } else if (ui.changedKey() == "reshape.metres_per_texel") {
        m_byWidth = false;
        m_reshaping.width = int(std::clamp(std::round(across / m_reshaping.metresPerTexel) + 1, 2.0, double(kMostSide)));
    } else if (ui.changedKey() == "reshape.texels") { // the same places
        const double texel = m_reshaping.texels ? 1 / m_oldMetres : m_oldMetres;
        const glm::dvec2 from = m_reshaping.texels ? -m_origin * texel : m_origin;
        m_reshaping.from = m_reshaping.from * texel + from;
        m_reshaping.to = m_reshaping.to * texel + from;
        m_reshaping.by *= texel;
    }
    if (m_reshaping.kind == Reshape::Resample)
        ui::softText(trf("ground.will_be", m_reshaping.width, int(std::round(along / m_reshaping.metresPerTexel)) + 1, m_reshaping.metresPerTexel));
}

} // namespace editor
