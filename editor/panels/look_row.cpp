#include "editor/panels/look_row.h"

#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/files/kept_looks.h"
#include "io/scene/environment_presets.h"

#include <algorithm>

namespace editor {
namespace {

constexpr float kSecondsWidth = 64; // pixels
constexpr double kLongest = 600;    // s

struct LookNames {
    std::vector<std::string> names, shown; // as files and scripts have them; as a person reads them
};

LookNames lookNames(const std::vector<std::string>& own)
{
    LookNames looks{.names = {""}, .shown = {tr("environment.look_none")}};
    for (const std::string_view name : enumNames(io::Preset{})) {
        looks.names.emplace_back(name);
        looks.shown.emplace_back(tr("look." + std::string{name}));
    }
    looks.names.insert(looks.names.end(), own.begin(), own.end());
    looks.shown.insert(looks.shown.end(), own.begin(), own.end());
    return looks;
}

std::vector<std::string> ownLooks()
{
    return io::KeptLooks{io::looksFolder()}.names();
}

} // namespace

void LookRow::choose(Editor& editor, const std::string& name)
{
    Document& document = *editor.document();
    const auto look = io::lookNamed(name, document.scene().environment(), io::KeptLooks{io::looksFolder()});
    if (!look) return editor.toasts().add(io::log::Level::Error, look.error().text());
    m_chosen = name;
    editor.live().turnInto(document, *look, m_seconds, tr("undo.look"));
}

void LookRow::draw(Editor& editor)
{
    Document& document = *editor.document();
    const float between = ImGui::GetStyle().ItemSpacing.x;
    const float rest = kSecondsWidth + ui::kToolSize * 2 + between * 3;
    if (!m_own) m_own = ownLooks();
    const LookNames looks = lookNames(*m_own);
    int chosen = 0;
    if (const auto at = std::ranges::find(looks.names, m_chosen); at != looks.names.end()) chosen = int(at - looks.names.begin());
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - rest, 60.0f));
    if (ui::combo("##look", tr("environment.look"), looks.shown, chosen) && chosen > 0) choose(editor, looks.names[std::size_t(chosen)]);
    if (ImGui::IsItemClicked()) m_own = ownLooks();
    if (ImGui::IsItemHovered()) ui::tooltip(tr("environment.look_tip"));
    ImGui::SameLine();
    ui::number({.id = "##over", .label = tr("environment.over"), .min = 0, .max = kLongest, .speed = 0.1, .decimals = 0, .unit = "s", .width = kSecondsWidth}, m_seconds);
    if (ImGui::IsItemHovered()) ui::tooltip(tr("environment.over_tip"));
    ImGui::SameLine();
    if (ui::iconButton({.id = "keep_look", .icon = Icon::Save, .label = tr("environment.keep")})) {
        m_name.clear();
        ImGui::OpenPopup("keep look");
    }
    keepLook(editor);
    ImGui::SameLine();
    const bool byTime = document.scene().environment().sun.mode == io::SunMode::Time;
    const bool runs = editor.live().dayRuns();
    if (ui::iconButton({.id = "run_day", .icon = Icon::Clock, .label = tr("environment.run_day"), .tooltip = byTime ? "" : tr("environment.run_day_by_hand"), .on = runs, .enabled = byTime || runs}))
        editor.live().runDay(document, !runs);
}

void LookRow::keepLook(Editor& editor)
{
    if (!ImGui::BeginPopup("keep look")) return;
    io::KeptLooks kept{io::looksFolder()};
    ImGui::SetNextItemWidth(220);
    ui::textField("##name", tr("environment.look_name"), m_name);
    const auto close = [&](const io::Status& done) {
        if (!done) return editor.toasts().add(io::log::Level::Error, done.error().text());
        m_own = ownLooks();
        ImGui::CloseCurrentPopup();
    };
    if (ui::button("keep", tr("environment.keep_now"), ui::Emphasis::Accent)) {
        const io::Environment& own = editor.document()->scene().environment();
        const io::Status done = kept.save(m_name, editor.live().shown(own).value_or(own));
        if (done) m_chosen = m_name;
        close(done);
    }
    const std::string& meant = m_name.empty() ? m_chosen : m_name;
    if (std::ranges::find(*m_own, meant) != m_own->end()) {
        ImGui::SameLine();
        if (ui::button("remove", trf("environment.remove", meant).c_str())) close(kept.remove(meant));
    }
    ImGui::EndPopup();
}

} // namespace editor
