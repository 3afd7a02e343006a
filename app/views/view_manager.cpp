#include "app/views/view_manager.h"

#include "io/base/log.h"

#include <chrono>
#include <initializer_list>
#include <utility>

namespace app {
namespace {

void timed(const char* what, const std::function<void()>& done)
{
    const auto start = std::chrono::steady_clock::now();
    done();
    io::log::debug("{} took {:.1f} ms", what, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
}

} // namespace

io::Status ViewManager::init()
{
    for (View* view : std::initializer_list<View*>{&m_edit, &m_start, &m_play})
        if (io::Status ready = view->init(); !ready) return ready;
    show(home());
    return {};
}

View& ViewManager::home() const
{
    if (m_edit.editor().document()) return m_edit;
    return m_start;
}

void ViewManager::show(View& view)
{
    if (m_now == &view) return;
    if (m_now) m_now->stop();
    const bool played = playing();
    m_now = &view;
    view.wake();
    if (played) m_edit.editor().offerPlayChanges(m_play.takeLeft());
}

void ViewManager::frame(double seconds, const std::function<void()>& beginImGui)
{
    if (!playing()) show(home());
    else if (m_play.wantsBack()) timed("leaving play", [&] { show(home()); });
    if (const std::optional<PlayBegin> begin = playing() ? std::nullopt : m_edit.takePlay())
        timed("entering play", [&] {
            m_play.begin(*begin);
            show(m_play);
        });
    m_now->run(seconds);
    beginImGui();
    m_now->runImGui();
}

void ViewManager::endPlay()
{
    if (playing()) show(m_edit);
}

void ViewManager::stop()
{
    if (m_now) std::exchange(m_now, nullptr)->stop();
}

void ViewManager::burn()
{
    m_play.burn();
    m_start.burn();
    m_edit.burn();
}

} // namespace app
