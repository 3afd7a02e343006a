// Editor: the whole content of the window, once a frame: menus, toolbar, panels, viewport, dialogs. It owns the open
// document and everything a person does with it; who opens the window, feeds ImGuiIO and shows its draw data is the
// host.
#pragma once

#include "editor/actions.h"
#include "editor/cameras.h"
#include "editor/dialogs/controls_dialog.h"
#include "editor/dialogs/dialogs.h"
#include "editor/dialogs/ground_dialogs.h"
#include "editor/document.h"
#include "editor/host.h"
#include "editor/live_environment.h"
#include "editor/loading.h"
#include "editor/picker.h"
#include "editor/scatter_work.h"
#include "editor/selection.h"
#include "editor/sound_settings.h"
#include "editor/start_page.h"
#include "editor/toasts.h"
#include "editor/viewport.h"
#include "editor/workspace.h"
#include "renderer/renderer.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

class Editor {
public:
    // Both need a current ImGui context whose fonts are loaded; without a renderer the viewport stays empty.
    Editor(renderer::Renderer& renderer, Host& host);
    explicit Editor(Host& host);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    // Between ImGui::NewFrame() and ImGui::Render(); fills the display. `seconds` have passed since the last one.
    void frame(double seconds);

    // Opens a project in place of the one that is open (asking about changes is the caller's). What cannot be opened
    // is said in a dialog and in the log, and what was open stays open.
    bool open(const std::filesystem::path& project, std::string_view scene = {});
    // The same as a person asks for it: where the host allows, in the background with a dialog that can cancel it.
    void openLater(const std::filesystem::path& project, const std::string& scene = {});
    void adopt(std::unique_ptr<Document> document);
    void closeProject(); // back to the start page
    void listProjects(); // that the start page shows, anew
    const StartLists& startLists() const { return m_startLists; }
    bool save();
    bool saveAs(const std::filesystem::path& folder);
    void revert(); // to what is on disk

    bool modified() const;     // against what is on disk; a look that is still coming counts
    std::string title() const; // "Valley – main * – Wold"
    // What a play left other than it was: said in passing, and kept for when the person asks for it.
    void offerPlayChanges(std::vector<PlayChange> changes);
    const std::vector<PlayChange>& playChanges() const { return m_playChanges; }

    void requestClose();       // as by the window's cross: asks when there are unsaved changes
    bool wantsClose() const { return m_wantsClose; }
    bool pointerHidden() const { return m_viewport.pointerHidden(); } // while looking around: hide and hold it
    // s after the last frame at which the window would look different by itself: 0 while something moves or was just
    // touched, infinity when only a person's input, or wake(), can change it.
    double nextFrameIn() const;
    void wake() { m_quiet = 0; }

    Document* document() { return m_document.get(); } // null: the start page
    const Document* document() const { return m_document.get(); }
    Selection& selection() { return m_selection; }
    Picker& picker() { return m_picker; }
    Viewport& viewport() { return m_viewport; }
    Workspace& workspace() { return m_workspace; }
    Actions& actions() { return m_actions; }
    Dialogs& dialogs() { return m_dialogs; }
    ControlsDialog& controlsDialog() { return m_controlsDialog; }
    GroundDialogs& groundDialogs() { return m_groundDialogs; }
    Toasts& toasts() { return m_toasts; }
    LiveEnvironment& live() { return m_live; }
    Cameras& cameras() { return m_cameras; }
    Host& host() { return m_host; }
    renderer::Renderer* renderer() { return m_renderer; }

    renderer::Settings renderSettings;
    renderer::Show show = renderer::Show::Final;
    SoundSettings sound;

    // Opens an undo step that lasts until the widget in use is let go; `what` tells one widget from another.
    void beginEdit(const std::string& what, std::string name);
    // Runs something that is one undo step of this name.
    void step(const char* textKey, const std::function<void(Document&)>& change);
    void follow(); // hands what changed to selection, picker, renderer

    // Fills a layer, or evaluates its rules: beside the window where the host and the layer allow, one undo step when done.
    void growPlants(const io::ScatterLayer& layer);
    ScatterWork& plantsWork() { return m_plantsWork; }

    // The template chosen in the Templates panel, shown by the Inspector while `inspectTemplate`.
    io::TemplateId chosenTemplate = io::TemplateId::None;
    bool inspectTemplate = false;

    // What drifts by itself (clouds, plants in the wind) does so only while this is on: otherwise an untouched window draws nothing.
    bool animates() const { return m_animates.value_or(animateByDefault); }
    void setAnimates(bool on) { m_animates = on; }
    bool animateByDefault = false; // until a person has chosen

    double time() const { return m_time; } // s that what drifts by itself has drifted
    double frameSeconds() const { return m_frameSeconds; } // since the last frame
    bool rested() const { return m_rested; }               // nothing was drawn meanwhile, for nothing happened

    void saveLayout();

private:
    Editor(renderer::Renderer* renderer, Host& host);
    bool adoptOpened(Loading::Opened opened);
    void addPanels();
    void restoreSettings();
    void sayWhatWasSaved(const io::FileTransaction::Report& report);
    void closeMenusByEscape();
    void drawWindow();
    void endEdit();
    void takePlants();
    void noteActivity(double seconds);
    bool drifts() const;

    renderer::Renderer* m_renderer;
    Host& m_host;
    std::unique_ptr<Document> m_document;
    Selection m_selection;
    Picker m_picker;
    Viewport m_viewport;
    Workspace m_workspace;
    std::vector<std::unique_ptr<Panel>> m_panels;
    Actions m_actions;
    Dialogs m_dialogs;
    ControlsDialog m_controlsDialog;
    GroundDialogs m_groundDialogs;
    Toasts m_toasts;
    LiveEnvironment m_live;
    Cameras m_cameras;
    StartLists m_startLists;
    Loading m_loading;
    ScatterWork m_plantsWork;
    std::string m_plantsName;
    std::vector<PlayChange> m_playChanges;
    io::Value m_savedSettings;
    std::string m_editing;
    std::optional<bool> m_animates;
    double m_time = 0;
    double m_frameSeconds = 0;
    bool m_resting = false, m_rested = false; // since this frame; until it
    double m_quiet = 0; // s since anything happened
    bool m_wantsClose = false;
};

} // namespace editor
