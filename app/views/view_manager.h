// ViewManager: which view fills the window. Only it changes that, between two frames.
#pragma once

#include "app/views/edit_view.h"
#include "app/views/play_view.h"

#include <functional>

namespace app {

class ViewManager {
public:
    ViewManager(EditView& edit, PlayView& play) : m_edit{edit}, m_play{play} {}

    io::Status init();
    void frame(double seconds, const std::function<void()>& beginImGui); // run, then what begins ImGui's frame, then its widgets
    void stop();
    void burn();

    bool playing() const { return m_now == &m_play; }
    void endPlay(); // the editor comes to the front, if it is not there

private:
    void show(View& view);

    EditView& m_edit;
    PlayView& m_play;
    View* m_now = nullptr;
};

} // namespace app
