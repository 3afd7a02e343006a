// EditView: the editor in its window: what it asks of the program around it (settings, languages), and its project.
#pragma once

#include "app/options.h"
#include "app/settings.h"
#include "app/views/play_view.h"
#include "app/views/world_sound.h"
#include "editor/editor.h"

#include <memory>
#include <optional>

namespace app {

class EditView final : public View, private editor::Host {
public:
    // `document` is one that is open already (a replay's); otherwise the project that is asked for, or the last one,
    // is opened in the window, where a fault is a message.
    EditView(const Options& options, renderer::Renderer& renderer, Settings& settings, const Pads& pads,
             std::unique_ptr<editor::Document> document = {});
    ~EditView() override;

    io::Status init() override;
    void wake() override { m_editor->wake(); }
    void run(double seconds) override { m_seconds = seconds; }
    void runImGui() override;
    void stop() override;
    void burn() override;

    editor::Editor& editor() { return *m_editor; }
    std::optional<PlayBegin> takePlay(); // once, after the person asked to play
    void playAtOnce(); // as asked on the command line: from the start marker, unless that names a view; nobody comes back to the editor
    void frameTook(double seconds); // in the window: quality "auto" steps down while drawing is too slow to work with
    bool hears() const { return m_sound.on(); } // hear() is to be called, though nothing is drawn
    void hear();
    void openDropped(const std::vector<std::filesystem::path>& files); // a project dropped on the window

private:
    std::vector<editor::Language> languages() const override;
    std::string language() const override { return m_language; }
    void setLanguage(const std::string& code) override;
    float uiScale() const override { return m_settings.uiScale(); }
    void setUiScale(float scale) override;
    double frameRate() const override { return m_settings.frameRate(); }
    void setFrameRate(double rate) override;
    std::vector<std::filesystem::path> recentProjects() const override;
    void addRecentProject(const std::filesystem::path& project) override;
    std::vector<std::filesystem::path> shippedWorlds() const override;
    bool repeatable() const override { return !m_options.replay.empty(); }
    void play(bool fromMarker) override { m_play = fromMarker; }
    editor::Held padsHeld() const override { return m_pads.held(); }
    void worldChanged(const io::Changes& changes) override { m_sound.note(changes); }
    io::Value settings() const override { return m_settings.editor(); }
    void saveSettings(const io::Value& settings) override;

    void chooseQuality();
    io::Status chooseLanguage();
    void openProject();
    void lookAsAsked();

    const Options& m_options;
    renderer::Renderer& m_renderer;
    Settings& m_settings;
    const Pads& m_pads;
    std::unique_ptr<editor::Document> m_given;
    std::string m_language = "en";
    std::unique_ptr<editor::Editor> m_editor;
    WorldSound m_sound; // goes before the editor whose world it is
    double m_seconds = 0;
    std::optional<Quality> m_lower; // the next step down of "auto"
    int m_slowFrames = 0;
    bool m_alone = false; // it is only played
    std::optional<bool> m_play; // asked for; whether from the start marker
};

} // namespace app
