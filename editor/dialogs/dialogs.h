// Dialogs: what asks a person before going on: open, new, save as, heights in and out, what to keep of a play, unsaved changes, messages,
// the list of keys.
// One is shown at a time; messages wait their turn.
#pragma once

#include "editor/dialogs/height_dialogs.h"
#include "editor/play_changes.h"

#include <deque>
#include <functional>
#include <string>

namespace editor {

class Editor;

class Dialogs {
public:
    void showOpen(Editor& editor);
    void showNew();
    void showSaveAs(Editor& editor);
    void showImportHeights(Editor& editor);
    void showExportHeights(Editor& editor);
    void showKeepPlay(Editor& editor);
    void showKeys() { m_which = Which::Keys; }
    void showMessage(std::string title, std::string text) { m_messages.push_back({std::move(title), std::move(text)}); }
    // Runs `then` at once when nothing is unsaved; otherwise after Save or Discard, and not at all after Cancel.
    void askToSave(Editor& editor, std::function<void()> then);

    // Runs `then` when the person agrees.
    void confirm(std::string title, std::string text, std::string accept, std::function<void()> then);

    void draw(Editor& editor);
    bool any() const { return m_which != Which::None || !m_messages.empty(); }

private:
    enum class Which { None, Open, New, SaveAs, ImportHeights, ExportHeights, KeepPlay, Keys, Message, AskToSave, Confirm };
    struct Message {
        std::string title, text;
    };
    bool begin(const char* title, float width);
    void end();
    void close();
    void drawOpen(Editor& editor);
    void drawNew(Editor& editor);
    void drawSaveAs(Editor& editor);
    void drawImportHeights(Editor& editor);
    void drawExportHeights(Editor& editor);
    void drawKeepPlay(Editor& editor);
    void drawKeepRow(Editor& editor, PlayRow& row);
    void drawKeys(Editor& editor);
    void drawMessage();
    void drawAskToSave(Editor& editor);
    void drawConfirm();
    void openChosen(Editor& editor, const std::filesystem::path& project);
    bool buttons(const char* accept, bool enabled); // and Cancel, which closes

    Which m_which = Which::None;
    FolderBrowser m_browser;
    HeightImportForm m_import;
    HeightExportForm m_export;
    std::vector<PlayRow> m_rows; // of what to keep
    std::string m_name; // of the folder to make
    int m_starter = 0;
    std::string m_fault; // shown in the dialog
    std::deque<Message> m_messages;
    Message m_question;
    std::string m_accept;
    std::function<void()> m_then;
};

} // namespace editor
