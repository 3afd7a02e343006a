// ImguiHost: Dear ImGui's context with its fonts, its drawing through OpenGL, and its input from a window or, without
// one, from whoever writes into ImGuiIO (a replay).
#pragma once

#include <glm/glm.hpp>

namespace app {

class Window;

class ImguiHost {
public:
    // Needs the GL context that it will draw with; `window` may be null.
    ImguiHost(Window* window, float scale);
    ~ImguiHost();
    ImguiHost(const ImguiHost&) = delete;
    ImguiHost& operator=(const ImguiHost&) = delete;

    void begin(glm::ivec2 size, double seconds); // the last two count only without a window
    void end();                                  // draws into the framebuffer that is bound then
    void finish();                               // the frame without drawing it
    void setScale(float scale);                  // of the screen: fonts are made anew when it changes

private:
    Window* m_window;
    float m_scale = 0;
};

} // namespace app
