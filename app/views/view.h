// View: what fills the window. One is shown at a time; the loop of app/commands/edit.cpp calls them in this order.
#pragma once

#include "io/base/result.h"

namespace app {

class View {
public:
    virtual ~View() = default;
    virtual io::Status init() = 0;        // once, with the GL and ImGui contexts there
    virtual void wake() {}                // it comes to the front
    virtual void run(double seconds) = 0; // before each frame
    virtual void runImGui() = 0;          // inside each frame of ImGui
    virtual void stop() {}                // another comes to the front, or the program ends
    virtual void burn() {}                // once, at the end: gives back what init took
};

} // namespace app
