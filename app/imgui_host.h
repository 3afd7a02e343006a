// ImguiHost: Dear ImGui's context with its fonts, its drawing through OpenGL, and its input from a window or, without
// one, from whoever writes into ImGuiIO (a replay).
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace app {

class Window;

class ImguiHost {
public:
    // Needs the GL context that it will draw with; `window` may be null.
    ImguiHost(Window* window, float scale);
    ~ImguiHost();
    ImguiHost(const ImguiHost&) = delete;
    ImguiHost& operator=(const ImguiHost&) = delete;

    void begin(glm::ivec2 size, double seconds); // pixels; both count only without a window
    void end();                                  // draws into the framebuffer that is bound then
    void setScale(float scale);                  // pixels of a point: fonts are made anew when it changes

private:
    void keepShortTaps();
    void onKey(int key, int scancode, int action, int mods);
    void onButton(int button, int action, int mods);
    void pointerWhereItActed();

    struct Release {
        int key, scancode, mods;
    };
    Window* m_window;
    float m_scale = 0;
    int m_unseenFrames = 0;          // until all that was pressed and clicked has been looked at
    std::vector<Release> m_releases; // of keys, that wait for that
    std::optional<glm::vec2> m_pointer;                 // as its last event said
    std::vector<glm::dvec2> m_way;                      // its events since the last frame
    std::optional<glm::vec2> m_pressedAt, m_releasedAt; // the pointer, where a button did so since the last frame
};

} // namespace app
