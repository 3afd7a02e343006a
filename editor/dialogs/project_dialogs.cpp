// Opening a project, making a new one, saving it elsewhere.
#include "editor/dialogs/dialogs.h"
#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/files/project.h"

#include <cstdlib>

namespace editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStarters[] = {"valley", "empty"};

fs::path homeFolder()
{
    const char* home = std::getenv("HOME");
    return home ? home : "/";
}

fs::path besideProject(Editor& editor)
{
    return editor.document() ? editor.document()->project().folder.parent_path() : homeFolder();
}

} // namespace

void Dialogs::showOpen(Editor& editor)
{
    m_which = Which::Open;
    m_browser.start(besideProject(editor));
}

void Dialogs::showNew()
{
    m_which = Which::New;
    m_browser.start(homeFolder());
    m_name = tr("dialog.new_name");
}

void Dialogs::showSaveAs(Editor& editor)
{
    m_which = Which::SaveAs;
    m_browser.start(besideProject(editor));
    m_name = editor.document() ? editor.document()->project().folder.filename().string() + "-2" : "";
}

void Dialogs::openChosen(Editor& editor, const fs::path& project)
{
    close();
    editor.openLater(project);
}

void Dialogs::drawOpen(Editor& editor)
{
    if (!begin(tr("dialog.open"), 720)) return;
    ImGui::BeginChild("##recent", {220, 380});
    ui::softText(tr("dialog.recent"));
    fs::path wanted;
    for (const fs::path& recent : editor.host().recentProjects()) {
        const std::string name = recent.filename().string();
        if (ui::button(recent.c_str(), ui::fitted(name, 180).c_str(), ui::Emphasis::Quiet, {-1, 0})) wanted = recent;
        if (ImGui::IsItemHovered()) ui::tooltip(recent.c_str());
    }
    ImGui::EndChild();
    ImGui::SameLine(0, 12);
    ImGui::BeginChild("##browser", {0, 380});
    m_browser.draw(0);
    ImGui::EndChild();
    const fs::path chosen = m_browser.chosen();
    const bool openable = isProject(chosen) || chosen.filename() == "project.json";
    if (buttons(tr("dialog.open_button"), openable) || m_browser.confirmed()) wanted = chosen;
    if (!wanted.empty()) openChosen(editor, wanted);
    end();
}

void Dialogs::drawNew(Editor& editor)
{
    if (!begin(tr("dialog.new"), 620)) return;
    ui::propertyLabel(tr("dialog.name"));
    ui::textField("##name", tr("dialog.name"), m_name);
    std::vector<std::string> starters;
    for (const char* starter : kStarters)
        starters.emplace_back(tr(std::string{"starter."} + starter));
    ui::propertyLabel(tr("dialog.starter"));
    ui::combo("##starter", tr("dialog.starter"), starters, m_starter);
    ImGui::Dummy({0, 4});
    ui::softText(tr("dialog.where"));
    m_browser.draw(240);
    const fs::path folder = m_browser.chosen() / m_name;
    if (buttons(tr("dialog.create"), !m_name.empty())) {
        if (const io::Status made = io::newProject(folder, kStarters[std::size_t(m_starter)]); !made)
            m_fault = made.error().text();
        else
            openChosen(editor, folder);
    }
    end();
}

void Dialogs::drawSaveAs(Editor& editor)
{
    if (!begin(tr("dialog.save_as"), 620)) return;
    ui::propertyLabel(tr("dialog.name"));
    ui::textField("##name", tr("dialog.name"), m_name);
    ui::softText(tr("dialog.where"));
    m_browser.draw(280);
    if (buttons(tr("dialog.save"), !m_name.empty() && editor.document())) {
        const fs::path folder = m_browser.chosen() / m_name;
        close();
        editor.saveAs(folder);
    }
    end();
}

} // namespace editor
