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

// Of a file with many faults the first few; the console has all.
void say(Editor& editor, const io::Complaints& complaints)
{
    constexpr std::size_t kMost = 3;
    for (std::size_t i = 0; i < complaints.size(); ++i) {
        const std::string text = complaints[i].where + ": " + complaints[i].what;
        if (i < kMost) editor.toasts().add(io::log::Level::Warning, text);
        else io::log::warning("{}", text);
    }
}

} // namespace

void LookRow::choose(Editor& editor, const std::string& name)
{
    Document& document = *editor.document();
    io::Complaints complaints;
    const auto look = io::lookNamed(name, document.scene().environment(), io::KeptLooks{io::looksFolder()}, complaints);
    if (!look) return editor.toasts().add(io::log::Level::Error, look.error().text());
    say(editor, complaints);
    m_chosen = name;
    m_look = *look;
    editor.live().turnInto(document, *look, m_seconds, tr("undo.look"));
}

// Undo, redo and edits come and go: the row names the chosen look while the scene has its light, or is getting it.
bool LookRow::stillChosen(Editor& editor) const
{
    const io::Environment& own = editor.document()->scene().environment();
    return editor.live().turning() || io::withLook(own, m_look) == own;
}

void LookRow::draw(Editor& editor)
{
    Document& document = *editor.document();
    const float between = ImGui::GetStyle().ItemSpacing.x;
    const float rest = kSecondsWidth + ui::kToolSize * 2 + between * 3;
    if (!m_own) m_own = ownLooks();
    const LookNames looks = lookNames(*m_own);
    int chosen = 0;
    if (const auto at = std::ranges::find(looks.names, m_chosen); at != looks.names.end() && stillChosen(editor)) chosen = int(at - looks.names.begin());
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - rest, 60.0f));
    if (ui::combo("##look", tr("environment.look"), looks.shown, chosen) && chosen > 0) choose(editor, looks.names[std::size_t(chosen)]);
    if (ImGui::IsItemClicked()) m_own = ownLooks();
    if (ImGui::IsItemHovered()) ui::tooltip(tr("environment.look_tip"));
    ImGui::SameLine();
    ui::number({.id = "##over", .label = tr("environment.over"), .min = 0, .max = kLongest, .speed = 0.1, .decimals = 0, .unit = "s", .width = kSecondsWidth}, m_seconds);
    if (ImGui::IsItemHovered()) ui::tooltip(tr("environment.over_tip"));
    ImGui::SameLine();
    if (ui::iconButton({.id = "keep_look", .icon = Icon::Save, .label = tr("environment.keep")})) {
        m_name = isOwn(m_chosen) ? m_chosen : std::string{}; // most likely that one again, as it is now
        ImGui::OpenPopup("keep look");
    }
    keepLook(editor);
    ImGui::SameLine();
    const bool byTime = document.scene().environment().sun.mode == io::SunMode::Time;
    const bool runs = editor.live().dayRuns();
    if (ui::iconButton({.id = "run_day", .icon = Icon::Clock, .label = tr("environment.run_day"), .tooltip = byTime ? "" : tr("environment.run_day_by_hand"), .on = runs, .enabled = byTime || runs}))
        editor.live().runDay(document, !runs);
}

bool LookRow::isOwn(const std::string& name) const
{
    return m_own && std::ranges::find(*m_own, name) != m_own->end();
}

void LookRow::keepLook(Editor& editor)
{
    if (!ImGui::BeginPopup("keep look")) return;
    io::KeptLooks looks{io::looksFolder()};
    ImGui::SetNextItemWidth(220);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered = ui::textField("##name", tr("environment.look_name"), m_name, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    const auto close = [&](const io::Status& done) {
        if (!done) return editor.toasts().add(io::log::Level::Error, done.error().text());
        m_own = ownLooks();
        ImGui::CloseCurrentPopup();
    };
    const bool there = isOwn(m_name);
    const bool kept = ui::button("keep", there ? tr("environment.replace") : tr("environment.keep_now"), ui::Emphasis::Accent);
    if (kept || entered) {
        const io::Environment& own = editor.document()->scene().environment();
        const io::Environment look = editor.live().shown(own).value_or(own);
        const io::Status done = looks.save(m_name, look);
        if (done) m_chosen = m_name, m_look = look;
        close(done);
    }
    if (there) {
        ImGui::SameLine();
        if (ui::button("remove", trf("environment.remove", m_name).c_str())) close(looks.remove(m_name));
    }
    ImGui::EndPopup();
}

} // namespace editor
