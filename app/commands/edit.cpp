// wold edit: the editor in a window, or, with --replay, the same editor fed from a file and drawn into pictures. And wold play in a
// window, which is the same one with the editor behind it that nobody comes back to.
#include "app/commands/commands.h"
#include "app/folder_watch.h"
#include "app/imgui_host.h"
#include "app/opened.h"
#include "app/player.h"
#include "app/recorder.h"
#include "app/report.h"
#include "app/studio.h"
#include "app/views/view_manager.h"
#include "app/window.h"
#include "editor/ui_map.h"
#include "io/base/log.h"
#include "io/base/paths.h"
#include "io/files/atomic_file.h"
#include "io/files/image_file.h"
#include "io/files/json.h"
#include "renderer/canvas.h"

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace app {
namespace {

constexpr double kStep = 1.0 / 60;     // s, of a replayed frame
constexpr double kLook = 0.5;          // s between looks at shader files while nothing happens
constexpr double kHear = 0.1;          // s between moments in which what is heard goes on, though nothing is drawn
constexpr int kSettle = 3;             // frames after a replay, so that its last event is seen

Settings settingsFor(const Options& options)
{
    if (!options.config.empty()) return Settings::load(options.config);
    // A replay is the same on every machine: it knows nothing of the person.
    return options.replay.empty() ? Settings::load(Settings::defaultFile()) : Settings{};
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// ---- the replay

class Stage {
public:
    Stage(const Options& options, ViewManager& views, ImguiHost& host, const Settings& settings, ReplayedPads& pads)
        : m_options{options}, m_views{views}, m_host{host}, m_settings{settings}, m_pads{pads}, m_canvas{std::make_unique<renderer::Canvas>(options.size)}
    {
    }

    void draw()
    {
        m_host.setScale(m_settings.uiScale());
        m_views.frame(kStep, [&] { m_host.begin(m_canvas->size(), kStep); });
        m_canvas->begin();
        m_host.end();
        ++m_frames;
    }
    int frames() const { return m_frames; }

    Player::Stage hooks()
    {
        return {.shot = [this](const std::filesystem::path& file) { return shot(file.empty() ? nextShot() : file); },
                .uiMap = [](const std::filesystem::path& file) { return writeMap(file); },
                .resize = [this](glm::ivec2 size) { m_canvas = std::make_unique<renderer::Canvas>(size); },
                .pad = [this](const step::Pad& pad) { m_pads.set(pad.name, pad.share); }};
    }

    // The pictures and the map that the command line asks for and no event has taken.
    io::Status finish()
    {
        while (m_shots < m_options.shots.size())
            if (io::Status taken = shot(nextShot()); !taken) return taken;
        return m_options.uiMap.empty() ? io::Status{} : writeMap(m_options.uiMap);
    }

private:
    std::filesystem::path nextShot()
    {
        return m_shots < m_options.shots.size() ? m_options.shots[m_shots++] : std::filesystem::path{};
    }
    io::Status shot(const std::filesystem::path& file)
    {
        if (file.empty()) return io::Error{"", "more shots than --shot names files"};
        return io::writeImage(file, m_canvas->read());
    }
    static io::Status writeMap(const std::filesystem::path& file)
    {
        return io::writeFile(file, io::writeJson(editor::uiMap(), 1) + "\n");
    }

    const Options& m_options;
    ViewManager& m_views;
    ImguiHost& m_host;
    const Settings& m_settings;
    ReplayedPads& m_pads;
    std::unique_ptr<renderer::Canvas> m_canvas;
    std::size_t m_shots = 0;
    int m_frames = 0;
};

io::Status play(const Options& options, std::vector<Step> steps, ViewManager& views, EditView& view, ImguiHost& host,
                const Settings& settings, ReplayedPads& pads)
{
    const auto start = std::chrono::steady_clock::now();
    Stage stage{options, views, host, settings, pads};
    Player player{std::move(steps), options.replay.string(), stage.hooks()};
    stage.draw(); // widgets have a place only once they were drawn
    for (;;) {
        const auto more = player.feed(ImGui::GetIO());
        if (!more) return more.error();
        if (!*more || view.editor().wantsClose()) break;
        stage.draw();
    }
    for (int i = 0; i < kSettle && !view.editor().wantsClose(); ++i)
        stage.draw();
    if (io::Status finished = stage.finish(); !finished) return finished;
    return writeFigures(options.json, io::Value::Object{{"frames", stage.frames()}, {"seconds", secondsSince(start)}});
}

int replay(const Options& options)
{
    auto steps = readReplay(options.replay);
    if (!steps) return fault(steps.error());
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    auto studio = Studio::create(options.headless);
    if (!studio) return fault(studio.error());

    Settings settings = settingsFor(options);
    ImguiHost host{nullptr, settings.uiScale()};
    ReplayedPads pads;
    EditView view{options, (*studio)->renderer(), settings, pads, std::move(std::get<Opened>(opened).document)};
    StartView start{view};
    PlayView walk{(*studio)->renderer(), pads};
    ViewManager views{start, view, walk};
    if (const io::Status ready = views.init(); !ready) return fault(ready.error());
    const io::Status played = play(options, *std::move(steps), views, view, host, settings, pads);
    views.stop();
    views.burn();
    return played ? 0 : fault(played.error());
}

// ---- the window

class Loop {
public:
    Loop(Window& window, ImguiHost& host, ViewManager& views, EditView& view, const Settings& settings, Recorder* recorder)
        : m_window{window}, m_host{host}, m_views{views}, m_view{view}, m_settings{settings}, m_recorder{recorder}
    {
    }

    void play() // until the person has had enough
    {
        m_view.playAtOnce();
        for (bool played = false; !m_window.closeAsked() && (m_views.playing() || !played); played = played || m_views.playing()) {
            m_window.takeEvents();
            frame();
        }
    }

    void run()
    {
        while (!m_view.editor().wantsClose()) {
            const bool due = waitForSomething();
            if (m_window.closeAsked()) {
                m_views.endPlay();
                m_view.editor().requestClose();
            }
            m_view.openDropped(m_window.takeDropped());
            if (due && m_window.shown()) frame();
        }
    }

private:
    // True when a frame would show something else than the last one: no change, no frame.
    bool waitForSomething()
    {
        const double passed = std::chrono::duration<double>(Clock::now() - m_last).count();
        const double wait = !m_window.shown() ? kLook : m_views.playing() ? 0 : m_view.editor().nextFrameIn() - passed;
        if (wait <= 0) {
            m_window.takeEvents();
            return true;
        }
        sayRest(wait);
        const bool happened = m_window.waitForEvents(std::min(wait, m_view.hears() ? kHear : kLook)) || m_shaders.changed();
        m_view.hear();
        if (happened) m_view.editor().wake();
        return happened;
    }

    void sayRest(double wait)
    {
        if (wait < kLook || m_frames == m_framesAtRest) return;
        m_framesAtRest = m_frames;
        io::log::debug("the window rests after {} frames", m_frames);
    }

    void frame()
    {
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - m_last).count();
        m_last = now;
        m_host.setScale(m_window.scale() * m_settings.uiScale());
        m_views.frame(std::max(seconds, 1e-4), [&] {
            m_host.begin({}, 0);
            if (m_recorder) m_recorder->frame(ImGui::GetIO());
        });
        renderer::beginWindow(m_window.pixels());
        m_host.end();
        m_window.setTitle(m_view.editor().title());
        m_window.setPointerHidden(m_views.playing() || m_view.editor().pointerHidden());
        m_window.swap();
        ++m_frames;
        if (!m_views.playing()) m_view.frameTook(std::chrono::duration<double>(Clock::now() - now).count());
    }

    using Clock = std::chrono::steady_clock;
    Window& m_window;
    ImguiHost& m_host;
    ViewManager& m_views;
    EditView& m_view;
    const Settings& m_settings;
    Recorder* m_recorder;
    Clock::time_point m_last = Clock::now();
    FolderWatch m_shaders{io::resource("renderer/shaders")};
    std::uint64_t m_frames = 0, m_framesAtRest = 0;
};

enum class Purpose { Edit, Play };

int openWindow(const Options& options, Purpose purpose)
{
    renderer::Settings drawing; // the words of --set are checked before a window appears
    if (const int code = applyToDrawing(options, drawing)) return code;
    std::optional<Recorder> recorder;
    if (!options.record.empty()) recorder.emplace(options.record);
    if (recorder && !recorder->open())
        return fault({options.record.string(), "cannot be written; name a file in a folder that exists"});
    std::unique_ptr<editor::Document> document; // of an editor the window opens it, where a fault is a message
    if (purpose == Purpose::Play) {
        auto opened = openAsAsked(options);
        if (const int* code = std::get_if<int>(&opened)) return *code;
        document = std::move(std::get<Opened>(opened).document);
    }
    Settings settings = settingsFor(options);
    auto window = Window::create({.size = options.sizeGiven ? options.size : glm::ivec2{1600, 900}});
    if (!window) return fault(window.error());
    auto renderer = makeRenderer();
    if (!renderer) return fault(renderer.error());
    ImguiHost host{window->get(), (*window)->scale() * settings.uiScale()};
    EditView view{options, **renderer, settings, **window, std::move(document)};
    StartView start{view};
    PlayView walk{**renderer, **window};
    ViewManager views{start, view, walk};
    if (const io::Status ready = views.init(); !ready) return fault(ready.error());
    Loop loop{**window, host, views, view, settings, recorder ? &*recorder : nullptr};
    if (purpose == Purpose::Play) loop.play();
    else loop.run();
    views.stop();
    views.burn();
    return 0;
}

} // namespace

int edit(const Options& options)
{
    if (!options.replay.empty()) return replay(options);
    if (options.headless)
        return misuse("edit --headless needs --replay FILE: without a display nobody could use the window");
    if (!hasDisplay())
        return fault(
            {"display", "there is none (DISPLAY, WAYLAND_DISPLAY); use --replay FILE, or wold render for pictures"});
    return openWindow(options, Purpose::Edit);
}

int playInWindow(const Options& options)
{
    if (options.headless || !hasDisplay())
        return fault({"display", options.headless ? "--headless shows nothing to play in; name what is pressed with --input FILE"
                                                  : "there is none (DISPLAY, WAYLAND_DISPLAY); name what is pressed with --input FILE"});
    return openWindow(options, Purpose::Play);
}

} // namespace app
