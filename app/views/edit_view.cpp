#include "app/views/edit_view.h"

#include "app/drawing_settings.h"
#include "app/opened.h"
#include "app/translator.h"
#include "io/base/log.h"
#include "io/base/paths.h"

#include <algorithm>
#include <utility>

namespace app {
namespace fs = std::filesystem;
namespace {

constexpr double kSlow = 0.1; // s a frame
constexpr int kSlowInARow = 8;

std::optional<Quality> lowerThan(Quality quality)
{
    if (quality == Quality::Auto || quality == Quality::Low) return {};
    return Quality(int(quality) - 1);
}

} // namespace

EditView::EditView(const Options& options, renderer::Renderer& renderer, Settings& settings, const Pads& pads,
                   std::unique_ptr<editor::Document> document)
    : m_options{options}, m_renderer{renderer}, m_settings{settings}, m_pads{pads}, m_given{std::move(document)}
{
}

EditView::~EditView() = default;

io::Status EditView::init()
{
    if (io::Status chosen = chooseLanguage(); !chosen) return chosen;
    editor::Host& host = *this;
    m_editor = std::make_unique<editor::Editor>(m_renderer, host);
    chooseQuality();
    applyToDrawing(m_options, m_editor->renderSettings); // its words were checked before
    m_editor->animateByDefault = !drawsInSoftware(m_renderer.deviceName());
    openProject();
    lookAsAsked();
    return {};
}

// "auto" is measured, but for a replay, whose pictures are the same each time.
void EditView::chooseQuality()
{
    Quality quality = m_options.quality.value_or(m_settings.quality());
    if (quality == Quality::Auto && !repeatable()) {
        const renderer::DeviceSpeed speed = renderer::measureDevice();
        quality = qualityFor(speed);
        io::log::info("quality {}: {:.3g} million triangles, {:.3g} million texture taps, {:.3g} thousand million "
                      "operations a second",
                      nameOf(quality), speed.triangles / 1e6, speed.taps / 1e6, speed.arithmetic / 1e9);
        m_lower = lowerThan(quality);
    }
    applyQuality(quality, m_renderer.deviceName(), m_editor->renderSettings);
}

// --lang holds for this run; a language of the settings that is gone falls back to English.
io::Status EditView::chooseLanguage()
{
    m_language = m_options.language.empty() ? m_settings.language() : m_options.language;
    io::Status chosen = useLanguage(m_language);
    if (chosen || !m_options.language.empty()) return chosen;
    io::log::warning("{}; the window speaks English", chosen.error().text());
    m_language = "en";
    return useLanguage(m_language);
}

void EditView::openProject()
{
    if (m_given) return m_editor->adopt(std::move(m_given));
    const auto recent = m_settings.recentProjects();
    std::error_code ignored;
    const bool changed = m_options.time || !m_options.sets.empty() || m_options.view || !m_options.camera.empty();
    if (!m_options.project.empty() && changed) {
        if (m_editor->open(m_options.project, m_options.scene)) applyToWorld(m_options, *m_editor->document());
    } else if (!m_options.project.empty()) {
        m_editor->openLater(m_options.project, m_options.scene); // the window is there at once
    } else if (!recent.empty() && fs::exists(recent.front(), ignored)) {
        m_editor->openLater(recent.front());
    }
}

void EditView::lookAsAsked()
{
    if (!m_editor->document() || (!m_options.view && m_options.camera.empty())) return;
    const auto camera = cameraFor(m_options, *m_editor->document());
    if (camera)
        m_editor->viewport().camera.setCamera(*camera);
    else
        io::log::warning("{}", camera.error().text());
}

void EditView::frameTook(double seconds)
{
    if (!m_lower || !m_editor->document()) return;
    m_slowFrames = seconds > kSlow ? m_slowFrames + 1 : 0;
    if (m_slowFrames < kSlowInARow) return;
    m_slowFrames = 0;
    io::log::info("a frame takes {:.0f} ms here: quality {}", seconds * 1e3, nameOf(*m_lower));
    applyQuality(*m_lower, m_renderer.deviceName(), m_editor->renderSettings);
    applyToDrawing(m_options, m_editor->renderSettings); // what was asked for by name stays
    m_lower = lowerThan(*m_lower);
}

void EditView::runImGui()
{
    m_editor->frame(m_seconds);
    hear();
}

void EditView::hear()
{
    if (!repeatable()) m_sound.update(*m_editor);
}

std::optional<PlayBegin> EditView::takePlay()
{
    const std::optional<bool> asked = std::exchange(m_play, std::nullopt);
    if (!asked || !m_editor->document()) return {};
    m_editor->follow(); // the renderer shows what is played, also where the editor has drawn nothing yet
    m_editor->cameras().look(editor::kEditCamera, m_editor->viewport().camera.camera()); // the same
    return PlayBegin{m_editor->document(), &m_editor->picker(), &m_editor->cameras(), *asked, repeatable(), m_alone, m_editor->renderSettings, m_editor->sound};
}

void EditView::playAtOnce()
{
    m_alone = true;
    m_play = !m_options.view && m_options.camera.empty();
}

void EditView::stop()
{
    m_sound.end();
    m_editor->saveLayout();
    m_settings.save();
}

void EditView::burn()
{
    m_sound.end();
    m_editor.reset();
}

void EditView::openDropped(const std::vector<fs::path>& files)
{
    const auto project = std::ranges::find_if(files, [](const fs::path& file) {
        std::error_code ignored;
        return file.filename() == "project.json" || fs::exists(file / "project.json", ignored);
    });
    if (project == files.end()) {
        if (!files.empty()) io::log::warning("{}: only projects can be dropped here", files.front().string());
    } else if (m_editor->modified()) {
        io::log::warning("{}: save or close the open project first", project->string());
    } else {
        m_editor->openLater(*project);
    }
}

std::vector<editor::Language> EditView::languages() const
{
    return app::languages();
}

void EditView::setLanguage(const std::string& code)
{
    const io::Status chosen = useLanguage(code);
    if (!chosen) return io::log::error("{}", chosen.error().text());
    m_language = code;
    m_settings.setLanguage(code);
    m_settings.save();
}

void EditView::setUiScale(float scale)
{
    m_settings.setUiScale(scale);
    m_settings.save();
}

void EditView::setFrameRate(double rate)
{
    m_settings.setFrameRate(rate);
    m_settings.save();
}

std::vector<fs::path> EditView::recentProjects() const
{
    return m_settings.recentProjects();
}

void EditView::addRecentProject(const fs::path& project)
{
    m_settings.addRecentProject(project);
    m_settings.save();
}

std::vector<fs::path> EditView::shippedWorlds() const
{
    std::vector<fs::path> worlds;
    std::error_code ignored;
    for (const char* name : {"valley", "forest-1", "forest-2", "forest-3"})
        if (const fs::path folder = io::resource(std::string{"projects/"} + name);
            fs::exists(folder / "project.json", ignored))
            worlds.push_back(folder);
    return worlds;
}

void EditView::saveSettings(const io::Value& settings)
{
    m_settings.setEditor(settings);
    m_settings.save();
}

} // namespace app
