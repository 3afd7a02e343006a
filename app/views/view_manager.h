// ViewManager: which view fills the window. Only it changes that, between two frames.
#pragma once

#include "app/views/edit_view.h"
#include "app/views/play_view.h"
#include "app/views/start_view.h"

#include <functional>

namespace app {

class ViewManager {
public:
    ViewManager(StartView& start, EditView& edit, PlayView& play) : m_start{start}, m_edit{edit}, m_play{play} {}

    io::Status init();
    void frame(double seconds, const std::function<void()>& beginImGui); // run, then what begins ImGui's frame, then its widgets
    void stop();
    void burn();

    bool playing() const { return m_now == &m_play; }
    void endPlay(); // the editor comes to the front, if it is not there

private:
    void show(View& view);
    View& home() const; // where one works: the editor, or the start page while nothing is open

    StartView& m_start;
    EditView& m_edit;
    PlayView& m_play;
    View* m_now = nullptr;
};

} // namespace app
