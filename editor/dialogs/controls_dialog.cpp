#include "editor/dialogs/controls_dialog.h"

#include "editor/dialogs/dialog_frame.h"
#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/files/usual_controls.h"

#include <algorithm>

namespace editor {
namespace {

constexpr const char* kId = "##controls";
constexpr double kPressed = 0.6; // share of the way of a stick or trigger that was meant

Held allHeld(Editor& editor)
{
    Held held = heldKeys();
    held.merge(editor.host().padsHeld());
    return held;
}

// As a person reads it: "Pad: left stick up".
std::string shown(const std::string& by)
{
    if (by.starts_with("mouse ")) return trf("control.mouse", by.substr(6));
    if (!by.starts_with("pad ")) return by;
    const std::string name = by.substr(4), way = name.substr(name.find(' ') + 1);
    const char* to = way == "-y" ? "control.up" : way == "+y" ? "control.down" : way == "-x" ? "control.to_left" : way == "+x" ? "control.to_right" : nullptr;
    if (!to) return trf("control.pad", name);
    return trf("control.pad", trf(name.starts_with("left") ? "control.left_stick" : "control.right_stick", tr(to)));
}

std::string actionText(std::string_view action)
{
    return tr("control." + std::string{action});
}

// The other actions that it does as well.
std::vector<std::string_view> othersOf(const io::Project& project, std::string_view action, const std::string& by)
{
    std::vector<std::string_view> others;
    for (const std::string_view other : io::playActions()) {
        const std::vector<std::string> controls = io::controlsOf(project.controls, other);
        if (other != action && std::ranges::find(controls, by) != controls.end()) others.push_back(other);
    }
    return others;
}

void change(Editor& editor, std::string_view action, std::vector<std::string> by)
{
    editor.step("undo.controls", [&](Document& document) {
        setControls(document, tr("undo.controls"), io::withControls(document.project().controls, action, by));
    });
}

void set(Editor& editor, std::string_view action, std::size_t place, const std::string& control)
{
    std::vector<std::string> by = io::controlsOf(editor.document()->project().controls, action);
    if (std::ranges::find(by, control) != by.end()) return; // it does that already
    if (place < by.size()) by[place] = control;
    else by.push_back(control);
    change(editor, action, std::move(by));
}

} // namespace

void ControlsDialog::listen(Editor& editor, std::string action, std::size_t place)
{
    m_listening = Listening{std::move(action), place, allHeld(editor)};
}

void ControlsDialog::takeHeld(Editor& editor)
{
    if (pressed(Key::Escape)) return m_listening.reset();
    const Held held = allHeld(editor);
    for (const auto& [name, share] : held) {
        if (share < kPressed || m_listening->before.contains(name) || name == "Escape") continue;
        const Listening done = *std::exchange(m_listening, std::nullopt);
        return set(editor, done.action, done.place, name);
    }
    std::erase_if(m_listening->before, [&](const auto& one) { return !held.contains(one.first); });
}

void ControlsDialog::close()
{
    m_open = false;
    m_listening.reset();
    ImGui::CloseCurrentPopup();
}

void ControlsDialog::draw(Editor& editor)
{
    if (!m_open) return;
    if (!editor.document()) return void(m_open = false);
    const MapPanel map{"dialog"};
    if (!ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
    if (!beginDialog(kId, tr("control.title"), 820)) return;
    const bool listened = listening();
    if (listened) takeHeld(editor);
    else if (pressed(Key::Escape)) close();
    ui::softText(tr(listened ? "control.press" : "control.text"));
    ImGui::Dummy({0, 4});
    if (listened) ImGui::BeginDisabled(); // a click is what is listened for
    ImGui::BeginChild("##actions", {0, 470});
    if (ImGui::BeginTable("##table", 2, ImGuiTableFlags_RowBg)) {
        ImGui::TableSetupColumn("##action", ImGuiTableColumnFlags_WidthFixed, 170);
        ImGui::TableSetupColumn("##by");
        for (const std::string_view action : io::playActions())
            row(editor, action);
        ImGui::EndTable();
    }
    ImGui::EndChild();
    sharedOnes(editor);
    ImGui::Dummy({0, 4});
    if (ui::button("usual", tr("control.all_usual")))
        editor.step("undo.controls", [](Document& document) {
            std::vector<io::Control> controls = document.project().controls;
            for (const std::string_view action : io::playActions())
                controls = io::withControls(controls, action, io::usualControls(action));
            setControls(document, tr("undo.controls"), std::move(controls));
        });
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 120);
    if (ui::button("close", tr("dialog.close"), ui::Emphasis::Accent, {120, 0})) close();
    if (listened) ImGui::EndDisabled();
    ImGui::EndPopup();
}

void ControlsDialog::row(Editor& editor, std::string_view action)
{
    const std::vector<std::string> by = io::controlsOf(editor.document()->project().controls, action);
    const bool adds = m_listening && m_listening->action == action && m_listening->place >= by.size();
    ImGui::PushID(action.data(), action.data() + action.size());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(actionText(action).c_str());
    ImGui::TableNextColumn();
    for (std::size_t i = 0; i < by.size(); ++i)
        control(editor, action, by, i);
    if (adds) {
        ImGui::EndDisabled(); // what waits for a key is the one thing that is bright
        ui::button("listens", tr("control.listens"), ui::Emphasis::Accent);
        ImGui::BeginDisabled();
        ImGui::SameLine(0, 6);
    }
    if (ui::iconButton({.id = "add", .icon = Icon::Plus, .label = trf("control.add", actionText(action)), .enabled = !listening(), .size = 28})) listen(editor, std::string{action}, by.size());
    if (by != io::usualControls(action)) {
        ImGui::SameLine(ImGui::GetContentRegionAvail().x - 34);
        if (ui::iconButton({.id = "reset", .icon = Icon::Reset, .label = trf("control.usual", actionText(action)), .enabled = !listening(), .size = 28, .colour = palette::kSoftText}))
            change(editor, action, io::usualControls(action));
    }
    ImGui::PopID();
}

// The name, which listens when it is clicked, and a cross that takes it away.
void ControlsDialog::control(Editor& editor, std::string_view action, const std::vector<std::string>& by, std::size_t place)
{
    ImGui::PushID(int(place));
    const bool replaced = m_listening && m_listening->action == action && m_listening->place == place;
    const bool shared = !othersOf(editor.document()->project(), action, by[place]).empty();
    const std::string text = replaced ? std::string{tr("control.listens")} : shown(by[place]);
    if (shared) ImGui::PushStyleColor(ImGuiCol_Border, palette::kAmber), ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.5f);
    if (replaced) ImGui::EndDisabled();
    if (ui::button(replaced ? "listens" : "control", text.c_str(), replaced ? ui::Emphasis::Accent : ui::Emphasis::Normal)) listen(editor, std::string{action}, place);
    if (replaced) ImGui::BeginDisabled();
    if (shared) ImGui::PopStyleVar(), ImGui::PopStyleColor();
    ImGui::SameLine(0, 0);
    const bool gone = ui::iconButton({.id = "remove", .icon = Icon::Close, .label = trf("control.remove", text, actionText(action)), .enabled = !listening(), .size = 24, .colour = palette::kFaintText});
    if (gone) {
        std::vector<std::string> rest = by;
        rest.erase(rest.begin() + std::ptrdiff_t(place));
        change(editor, action, std::move(rest));
    }
    ImGui::SameLine(0, 6);
    ImGui::PopID();
}

void ControlsDialog::sharedOnes(Editor& editor)
{
    const io::Project& project = editor.document()->project();
    std::vector<std::string> said;
    for (const std::string_view action : io::playActions())
        for (const std::string& by : io::controlsOf(project.controls, action)) {
            const std::vector<std::string_view> others = othersOf(project, action, by);
            if (others.empty() || std::ranges::find(said, by) != said.end()) continue;
            said.push_back(by);
            const std::string text = trf("control.shared", shown(by), actionText(action), actionText(others.front()));
            ui::iconText(Icon::Warning, palette::kAmber, text);
            mapItem("label", text);
        }
}

} // namespace editor
