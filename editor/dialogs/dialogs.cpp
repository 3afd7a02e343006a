#include "editor/dialogs/dialogs.h"

#include "editor/dialogs/dialog_frame.h"
#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"

namespace editor {
namespace {

constexpr const char* kId = "##dialog";

} // namespace

void Dialogs::draw(Editor& editor)
{
    if (m_which == Which::None && !m_messages.empty()) m_which = Which::Message;
    if (m_which == Which::None) return;
    const MapPanel map{"dialog"};
    if (!ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
    switch (m_which) {
    case Which::Open:
        return drawOpen(editor);
    case Which::New:
        return drawNew(editor);
    case Which::SaveAs:
        return drawSaveAs(editor);
    case Which::ImportHeights:
        return drawImportHeights(editor);
    case Which::ExportHeights:
        return drawExportHeights(editor);
    case Which::KeepPlay:
        return drawKeepPlay(editor);
    case Which::Keys:
        return drawKeys(editor);
    case Which::Message:
        return drawMessage();
    case Which::AskToSave:
        return drawAskToSave(editor);
    case Which::Confirm:
        return drawConfirm();
    case Which::None:
        break;
    }
}

bool Dialogs::begin(const char* title, float width)
{
    if (!beginDialog(kId, title, width)) return false;
    if (pressed(Key::Escape)) close();
    return true;
}

void Dialogs::end()
{
    ImGui::EndPopup();
}

void Dialogs::close()
{
    if (m_which == Which::Message && !m_messages.empty()) m_messages.pop_front();
    m_which = Which::None;
    m_fault.clear();
    ImGui::CloseCurrentPopup();
}

bool Dialogs::buttons(const char* accept, bool enabled)
{
    if (!m_fault.empty()) {
        ImGui::PushTextWrapPos(0);
        ui::iconText(Icon::Error, palette::kRed, m_fault);
        ImGui::PopTextWrapPos();
    }
    ImGui::Dummy({0, 6});
    constexpr float kWide = 120;
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2 * kWide - 8);
    if (ui::button("cancel", tr("dialog.cancel"), ui::Emphasis::Normal, {kWide, 0})) close();
    ImGui::SameLine(0, 8);
    if (!enabled) ImGui::BeginDisabled();
    const bool accepted = ui::button("accept", accept, ui::Emphasis::Accent, {kWide, 0});
    if (!enabled) ImGui::EndDisabled();
    return enabled && accepted;
}

void Dialogs::askToSave(Editor& editor, std::function<void()> then)
{
    if (!editor.modified()) return then();
    m_then = std::move(then);
    m_which = Which::AskToSave;
}

void Dialogs::drawAskToSave(Editor& editor)
{
    if (!begin(tr("dialog.unsaved"), 460)) return;
    ui::softText(trf("dialog.unsaved_text", editor.document() ? editor.document()->project().name : ""));
    ImGui::Dummy({0, 10});
    const auto go = [&] {
        const std::function<void()> then = std::move(m_then);
        close();
        then();
    };
    if (ui::button("discard", tr("dialog.discard"))) go();
    constexpr float kWide = 120;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 2 * kWide - 8);
    if (ui::button("cancel", tr("dialog.cancel"), ui::Emphasis::Normal, {kWide, 0})) close();
    ImGui::SameLine(0, 8);
    if (ui::button("save", tr("dialog.save"), ui::Emphasis::Accent, {kWide, 0}) || pressed(Key::Enter)) {
        if (editor.save())
            go();
        else
            close();
    }
    end();
}

void Dialogs::confirm(std::string title, std::string text, std::string accept, std::function<void()> then)
{
    m_question = {std::move(title), std::move(text)};
    m_accept = std::move(accept);
    m_then = std::move(then);
    m_which = Which::Confirm;
}

void Dialogs::drawConfirm()
{
    if (!begin(m_question.title.c_str(), 460)) return;
    ui::softText(m_question.text);
    if (buttons(m_accept.c_str(), true)) {
        const std::function<void()> then = std::move(m_then);
        close();
        then();
    }
    end();
}

void Dialogs::drawMessage()
{
    if (m_messages.empty()) return close();
    const Message message = m_messages.front();
    if (!begin(message.title.c_str(), 520)) return;
    ImGui::BeginChild("##text",
                      {0, std::min(260.f, ImGui::CalcTextSize(message.text.c_str(), nullptr, false, 470).y + 8)});
    ui::softText(message.text);
    mapItem("label", message.text);
    ImGui::EndChild();
    ImGui::Dummy({0, 4});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 120);
    if (ui::button("ok", tr("dialog.ok"), ui::Emphasis::Accent, {120, 0}) || pressed(Key::Enter)) close();
    end();
}

void Dialogs::drawKeys(Editor& editor)
{
    if (!begin(tr("dialog.keys"), 620)) return;
    ImGui::BeginChild("##keys", {0, 420});
    const auto line = [](const std::string& what, const std::string& keys) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(what.c_str());
        ImGui::TableNextColumn();
        ui::softText(keys);
        mapItem("label", what, keys);
    };
    if (ImGui::BeginTable("##table", 2, ImGuiTableFlags_RowBg)) {
        constexpr const char* kMouse[] = {"look",  "fly",    "speed",  "dolly", "orbit", "pan",
                                          "click", "behind", "toggle", "box",   "snap",  "cancel"};
        for (const char* entry : kMouse)
            line(tr(std::string{"keys."} + entry), tr(std::string{"keys."} + entry + "_how"));
        for (const Action& action : editor.actions().all())
            if (action.keys != Chord{}) line(tr("action." + std::string{action.id}), name(action.keys));
        ImGui::EndTable();
    }
    ImGui::EndChild();
    ImGui::Dummy({0, 4});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 120);
    if (ui::button("ok", tr("dialog.close"), ui::Emphasis::Accent, {120, 0})) close();
    end();
}

} // namespace editor
