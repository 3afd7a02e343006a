#include "editor/editor.h"

#include "editor/brush_settings.h"
#include "editor/menus.h"
#include "editor/numbers_text.h"
#include "editor/panels/console_panel.h"
#include "editor/panels/environment_panel.h"
#include "editor/panels/hierarchy_panel.h"
#include "editor/panels/history_panel.h"
#include "editor/panels/inspector_panel.h"
#include "editor/panels/paths_panel.h"
#include "editor/panels/rendering_panel.h"
#include "editor/panels/scatter_panel.h"
#include "editor/panels/sound_panel.h"
#include "editor/panels/statistics_panel.h"
#include "editor/panels/templates_panel.h"
#include "editor/panels/terrain_panel.h"
#include "editor/text.h"
#include "editor/theme.h"
#include "editor/ui_map.h"

#include <algorithm>
#include <imgui_internal.h>

namespace editor {
namespace {

constexpr double kQuietAfter = 0.5; // s without anything happening until the picture counts as at rest
constexpr double kProgress = 1 / 30.0; // s between frames of a progress bar
constexpr double kBlink = 0.4;      // s; divides the times a text cursor is seen and unseen
constexpr double kHitch = 0.25;     // s; a slow frame uses up no more of what is shown for a while
constexpr double kRest = 0.1;       // s of waiting that make a pause between two frames

bool sways(const io::Scene::TemplateSlot& slot)
{
    return slot.value && slot.value->wind > 0;
}

bool burns(const io::Scene::TemplateSlot& slot)
{
    return slot.value && slot.value->particles.kind != io::ParticleKind::None;
}

bool waves(const io::Water& water)
{
    return water.on && water.waves > 0;
}

} // namespace

Editor::Editor(renderer::Renderer& renderer, Host& host) : Editor{&renderer, host} {}

Editor::Editor(Host& host) : Editor{nullptr, host} {}

Editor::Editor(renderer::Renderer* renderer, Host& host) : m_renderer{renderer}, m_host{host}
{
    addPanels();
    m_actions = makeActions(*this);
    restoreSettings();
    listProjects();
}

Editor::~Editor()
{
    saveLayout();
}

void Editor::addPanels()
{
    const auto add = [this](std::unique_ptr<Panel> panel, Region home, bool shown = true) {
        m_workspace.add(*panel, home, shown);
        m_panels.push_back(std::move(panel));
    };
    m_workspace.setHomeSize(Region::Left, 260);
    m_workspace.setHomeSize(Region::Right, 350);
    m_workspace.setHomeSize(Region::Bottom, 230);
    m_workspace.add(m_viewport, Region::Centre);
    add(std::make_unique<HierarchyPanel>(), Region::Left);
    add(std::make_unique<InspectorPanel>(), Region::Right);
    add(std::make_unique<EnvironmentPanel>(), Region::Right);
    add(std::make_unique<RenderingPanel>(), Region::Right);
    add(std::make_unique<TerrainPanel>(), Region::Right);
    add(std::make_unique<ScatterPanel>(), Region::Right);
    add(std::make_unique<PathsPanel>(), Region::Right);
    add(std::make_unique<TemplatesPanel>(), Region::Bottom);
    add(std::make_unique<ConsolePanel>(), Region::Bottom);
    add(std::make_unique<StatisticsPanel>(), Region::Bottom);
    add(std::make_unique<HistoryPanel>(), Region::Bottom);
    add(std::make_unique<SoundPanel>(), Region::Bottom);
}

void Editor::restoreSettings()
{
    m_savedSettings = m_host.settings();
    if (const io::Value* layout = m_savedSettings.find("layout")) m_workspace.restore(*layout);
    const io::Value* animate = m_savedSettings.find("animate");
    if (const bool* on = animate ? animate->asBool() : nullptr) m_animates = *on;
    if (const io::Value* brush = m_savedSettings.find("brush")) restoreBrush(m_viewport.brush, *brush);
    if (const io::Value* heard = m_savedSettings.find("sound")) restore(sound, *heard);
    const io::Value* follow = m_savedSettings.find("objects_follow");
    if (const bool* on = follow ? follow->asBool() : nullptr) m_viewport.objectsFollow = *on;
}

void Editor::saveLayout()
{
    io::Value settings = m_savedSettings;
    settings["layout"] = toValue(m_workspace.layout());
    if (m_animates) settings["animate"] = *m_animates;
    settings["brush"] = brushSettings(m_viewport.brush);
    settings["sound"] = toValue(sound);
    settings["objects_follow"] = m_viewport.objectsFollow;
    if (settings == m_savedSettings) return;
    m_savedSettings = settings;
    m_host.saveSettings(settings);
}

bool Editor::open(const std::filesystem::path& project, std::string_view scene)
{
    return adoptOpened(Document::open(project, scene));
}

void Editor::openLater(const std::filesystem::path& project, const std::string& scene)
{
    if (m_host.repeatable())
        open(project, scene);
    else
        m_loading.start(project, scene);
}

bool Editor::adoptOpened(Loading::Opened opened)
{
    if (!opened) {
        io::log::error("{}", opened.error().text());
        m_dialogs.showMessage(tr("message.cannot_open"), opened.error().text());
        return false;
    }
    adopt(std::move(*opened));
    m_host.addRecentProject(m_document->project().folder);
    return true;
}

void Editor::adopt(std::unique_ptr<Document> document)
{
    m_editing.clear();
    m_viewport.reset(); // what it draws on is about to go
    m_plantsWork.cancel();
    m_document = std::move(document);
    m_playChanges.clear();
    m_live.forget();
    m_cameras.forget(kPlayCamera); // was in another world
    m_selection = {};
    wake();
    m_viewport.lookFrom(*m_document);
    m_viewport.brush.layer = m_viewport.brush.replaced = 0; // those were another world's
    if (std::error_code none; std::filesystem::exists(m_document->project().folder / m_viewport.brush.stampFile, none)) m_viewport.readStamp(*m_document);
    else m_viewport.brush.stamp = nullptr;
    chosenTemplate = io::TemplateId::None;
    inspectTemplate = false;
    int errors = 0;
    std::string first;
    for (const io::Complaint& complaint : m_document->complaints()) {
        const bool grave = complaint.severity == io::Severity::Error;
        const std::string text = complaint.where + ": " + complaint.what;
        if (grave && errors++ == 0) first = text;
        io::log::write(grave ? io::log::Level::Error : io::log::Level::Warning, text);
    }
    io::log::info("{}",
                  trf("message.opened", m_document->project().name, grouped(m_document->scene().objects().size())));
    if (errors) m_toasts.add(io::log::Level::Warning, errors == 1 ? first : trf("message.opened_with_errors", errors));
}

void Editor::closeProject()
{
    m_editing.clear();
    m_viewport.reset();
    m_selection = {};
    m_document.reset();
    m_playChanges.clear();
    m_live.forget();
    m_cameras.forget(kPlayCamera);
    listProjects();
}

void Editor::listProjects()
{
    m_startLists = {m_host.recentProjects(), m_host.shippedWorlds()};
}

bool Editor::save()
{
    if (!m_document) return false;
    endEdit();
    m_live.finish(*m_document);
    const auto report = m_document->save();
    if (!report) {
        io::log::error("{}", report.error().text());
        m_dialogs.showMessage(tr("message.cannot_save"), report.error().text());
        return false;
    }
    sayWhatWasSaved(*report);
    return true;
}

bool Editor::saveAs(const std::filesystem::path& folder)
{
    if (!m_document) return false;
    endEdit();
    m_live.finish(*m_document);
    const auto report = m_document->saveAs(folder);
    if (!report) {
        io::log::error("{}", report.error().text());
        m_dialogs.showMessage(tr("message.cannot_save"), report.error().text());
        return false;
    }
    m_host.addRecentProject(m_document->project().folder);
    sayWhatWasSaved(*report);
    return true;
}

void Editor::sayWhatWasSaved(const io::FileTransaction::Report& report)
{
    m_toasts.add(io::log::Level::Info, trf("message.saved", report.written.size(), byteText(report.bytes)));
    if (m_live.dayRuns()) m_toasts.add(io::log::Level::Info, tr("message.saved_while_day_runs"));
}

bool Editor::modified() const
{
    return m_document && (m_document->modified() || m_live.turning());
}

void Editor::revert()
{
    endEdit();
    m_live.stopTurning();
    const io::Status done = m_document->reload();
    if (!done) return m_dialogs.showMessage(tr("message.cannot_open"), done.error().text());
    m_selection.clear();
    m_toasts.add(io::log::Level::Info, tr("message.reverted"));
}

std::string Editor::title() const
{
    if (!m_document) return "Wold";
    return fmt::format("{} – {}{} – Wold", m_document->project().name, m_document->world().entry.name,
                       modified() ? " *" : "");
}

void Editor::offerPlayChanges(std::vector<PlayChange> changes)
{
    m_playChanges = std::move(changes);
    if (!m_document || playRows(*m_document, m_playChanges).empty()) return m_playChanges.clear();
    m_toasts.add(io::log::Level::Info, trf("message.play_changed", m_playChanges.size()));
}

void Editor::requestClose()
{
    m_dialogs.askToSave(*this, [this] { m_wantsClose = true; });
}

void Editor::beginEdit(const std::string& what, std::string name)
{
    if (m_editing == what && m_document->inGesture()) return;
    endEdit();
    m_document->beginGesture(std::move(name));
    m_editing = what;
}

void Editor::endEdit()
{
    if (!m_editing.empty() && m_document && m_document->inGesture()) m_document->endGesture();
    m_editing.clear();
}

void Editor::step(const char* textKey, const std::function<void(Document&)>& change)
{
    endEdit();
    const Gesture gesture{*m_document, tr(textKey)};
    change(*m_document);
}

void Editor::follow()
{
    if (!m_document) return;
    const io::Changes changes = m_document->takeChanges();
    if (changes.none()) return;
    m_quiet = 0;
    m_host.worldChanged(changes);
    m_selection.follow(m_document->scene(), changes);
    m_picker.update(m_document->scene(), m_document->assets(), changes);
    if (m_renderer) m_renderer->update(m_document->scene(), m_document->assets(), changes);
    for (const std::unique_ptr<Panel>& panel : m_panels)
        panel->follow(*m_document, changes);
}

void Editor::frame(double seconds)
{
    m_rested = m_resting;
    m_frameSeconds = seconds;
    if (drifts() && !m_rested) m_time += seconds;
    if (m_document && m_live.moves()) m_live.pass(*m_document, m_rested ? 0 : std::min(seconds, kHitch));
    m_toasts.pass(m_rested ? seconds : std::min(seconds, kHitch));
    clearMap();
    follow();
    if (!m_viewport.flying()) m_actions.shortcuts();
    closeMenusByEscape();
    drawWindow();
    m_dialogs.draw(*this);
    m_controlsDialog.draw(*this);
    m_groundDialogs.draw(*this);
    m_loading.draw();
    if (auto opened = m_loading.finished()) adoptOpened(std::move(*opened));
    m_toasts.draw();
    takePlants();
    if (!ImGui::IsAnyItemActive()) endEdit();
    noteActivity(seconds);
    m_resting = nextFrameIn() > kRest;
}

// ImGui does this by itself only with its keyboard navigation, whose keys are ours.
void Editor::closeMenusByEscape()
{
    if (!pressed(Key::Escape) || m_dialogs.any() || m_controlsDialog.any() || m_groundDialogs.any() || ImGui::GetIO().WantTextInput) return;
    if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) ImGui::ClosePopupToLevel(0, true);
    else if (!m_viewport.sculpting && !m_viewport.scattering && m_viewport.placing() == io::TemplateId::None) m_live.stopTurning();
}

void Editor::drawWindow()
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, display, palette::kBack);
    menuBar(*this);
    float top = ImGui::GetFrameHeight() + 6;
    if (!m_document) return startPage(*this, {0, top}, display);
    top = toolbar(*this, top);
    follow(); // what a key or a button did is seen by all panels at once
    const float bottom = statusBar(*this);
    m_workspace.draw(*this, {0, top + 3}, {display.x, bottom - 3});
}

void Editor::growPlants(const io::ScatterLayer& layer)
{
    m_plantsName = layer.rule ? tr("undo.evaluate_plants") : tr("undo.fill_plants");
    m_plantsWork.start(m_document->scene(), layerTiles(m_document->scene(), layer), plantingOf(*m_document, layer, &m_picker), !m_host.repeatable());
    takePlants();
}

void Editor::takePlants()
{
    if (!m_document || m_document->inGesture()) return;
    if (!m_plantsWork.ready()) return;
    if (auto slots = m_plantsWork.finished(m_document->scene())) setInstances(*m_document, m_plantsName, *std::move(slots));
    else if (m_plantsWork.late()) m_toasts.add(io::log::Level::Warning, tr("message.plants_late"));
}

void Editor::noteActivity(double seconds)
{
    const ImGuiIO& io = ImGui::GetIO();
    bool active = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0;
    active |= ImGui::IsAnyItemActive() && !io.WantTextInput; // a text that waits for keys only blinks
    for (const bool down : io.MouseDown)
        active |= down;
    for (const bool down : io.KeysDown)
        active |= down;
    active |= m_viewport.busy();
    m_quiet = active ? 0 : m_quiet + (m_rested ? 0 : std::min(seconds, kHitch));
}

bool Editor::drifts() const
{
    if (!m_document) return false;
    if (m_live.moves()) return true;
    if (!animates()) return false;
    const io::Environment& environment = m_document->scene().environment();
    const bool drift = environment.clouds.speed != 0 || environment.clouds.change != 0;
    const bool clouds = renderSettings.clouds && environment.clouds.on && drift && environment.clouds.coverage > 0;
    const bool wind = renderSettings.wind && environment.wind.speed > 0;
    const bool water = renderSettings.water && waves(environment.water);
    const bool falls = renderSettings.particles && environment.weather.rain + environment.weather.snow > 0;
    const auto& templates = m_document->scene().templates();
    return clouds || water || falls || (wind && std::ranges::any_of(templates, sways)) ||
           (renderSettings.particles && std::ranges::any_of(templates, burns));
}

double Editor::nextFrameIn() const
{
    if (m_quiet < kQuietAfter) return 0;
    if (m_document && m_renderer && m_renderer->stats().gathering) return 0; // the picture is still becoming smoother
    double next = m_toasts.nextChange();
    if (drifts()) next = std::min({next, 1 / m_host.frameRate(), kRest});
    if (m_controlsDialog.listening() || m_loading.busy() || m_groundDialogs.working() || m_plantsWork.busy()) next = std::min(next, kProgress);
    if (ImGui::GetIO().WantTextInput) next = std::min(next, kBlink);
    return next;
}

} // namespace editor
