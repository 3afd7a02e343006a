// A window with its OpenGL 4.5 core context (GLFW), and what the desktop tells about it.
#pragma once

#include "app/pads.h"
#include "io/base/result.h"

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace app {

class Window : public Pads {
public:
    struct Options {
        std::string title = "Wold";
        glm::ivec2 size{1280, 720};
        bool visible = true;
    };
    static io::Result<std::unique_ptr<Window>> create(Options options);
    ~Window() override;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return m_window; }
    glm::ivec2 pixels() const;                        // of the framebuffer; 0 while minimised
    float scale() const;                              // of the screen it is on: 1 at 96 dpi
    bool closeAsked();                                // true once for each time the person asks to close it
    bool shown() const;                               // neither minimised nor without area
    std::vector<std::filesystem::path> takeDropped(); // files dropped on it since the last call

    play::Held held() const override; // of pads, while the window has the keyboard

    void setTitle(const std::string& title);
    void setPointerHidden(bool hidden); // hidden, it moves without bound; the position is kept
    void swap();                        // shows what was drawn, waits for the screen
    bool waitForEvents(double seconds); // true when one came: something may look different now
    void takeEvents();

private:
    explicit Window(GLFWwindow* window) : m_window{window} {}
    void countEvents();
    void noteSeen();
    GLFWwindow* m_window;
    std::string m_title;
    bool m_pointerHidden = false;
    std::uint64_t m_events = 0, m_seenEvents = 0; // all but the pointer moving
    glm::dvec2 m_seenPointer{0};
    std::vector<std::filesystem::path> m_dropped;
};

} // namespace app
