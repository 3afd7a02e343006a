#include "app/window.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>

namespace app {
namespace {

int g_windows = 0;
std::string g_fault; // GLFW's last words

void keepFault(int, const char* text)
{
    g_fault = text;
}

void setHints(const Window::Options& options)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, options.visible);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "wold");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "wold");
}

} // namespace

io::Result<std::unique_ptr<Window>> Window::create(Options options)
{
    glfwSetErrorCallback(keepFault);
    if (g_windows == 0 && !glfwInit()) return io::Error{"display", fmt::format("cannot be opened: {}", g_fault)};
    setHints(options);
    GLFWwindow* handle = glfwCreateWindow(options.size.x, options.size.y, options.title.c_str(), nullptr, nullptr);
    if (!handle) {
        if (g_windows == 0) glfwTerminate();
        return io::Error{"OpenGL", fmt::format("a window with OpenGL 4.5 core is needed: {}; install the driver of the "
                                               "graphics card, or Mesa",
                                               g_fault)};
    }
    ++g_windows;
    std::unique_ptr<Window> window{new Window{handle}};
    glfwMakeContextCurrent(handle);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(handle, window.get());
    glfwSetDropCallback(handle, [](GLFWwindow* to, int count, const char** names) {
        Window& self = *static_cast<Window*>(glfwGetWindowUserPointer(to));
        self.m_dropped.insert(self.m_dropped.end(), names, names + count);
        ++self.m_events;
    });
    window->countEvents();
    return window;
}

// Those that come after these (Dear ImGui's) hand on to them; the pointer's one may not, so its place is asked for.
void Window::countEvents()
{
    constexpr auto kCount = [](GLFWwindow* of, auto...) { ++static_cast<Window*>(glfwGetWindowUserPointer(of))->m_events; };
    glfwSetKeyCallback(m_window, kCount);
    glfwSetCharCallback(m_window, kCount);
    glfwSetMouseButtonCallback(m_window, kCount);
    glfwSetScrollCallback(m_window, kCount);
    glfwSetCursorEnterCallback(m_window, kCount);
    glfwSetWindowFocusCallback(m_window, kCount);
    glfwSetWindowRefreshCallback(m_window, kCount);
    glfwSetWindowCloseCallback(m_window, kCount);
    glfwSetWindowIconifyCallback(m_window, kCount);
    glfwSetFramebufferSizeCallback(m_window, kCount);
    glfwSetWindowContentScaleCallback(m_window, kCount);
}

Window::~Window()
{
    glfwDestroyWindow(m_window);
    if (--g_windows == 0) glfwTerminate();
}

glm::ivec2 Window::pixels() const
{
    glm::ivec2 size;
    glfwGetFramebufferSize(m_window, &size.x, &size.y);
    return size;
}

float Window::scale() const
{
    float x = 1, y = 1;
    glfwGetWindowContentScale(m_window, &x, &y);
    return glm::clamp(x, 0.5f, 4.0f);
}

bool Window::closeAsked()
{
    const bool asked = glfwWindowShouldClose(m_window);
    glfwSetWindowShouldClose(m_window, GLFW_FALSE);
    return asked;
}

bool Window::shown() const
{
    const glm::ivec2 size = pixels();
    return size.x > 0 && size.y > 0 && !glfwGetWindowAttrib(m_window, GLFW_ICONIFIED);
}

std::vector<std::filesystem::path> Window::takeDropped()
{
    return std::exchange(m_dropped, {});
}

play::Held Window::held() const
{
    std::vector<PadState> pads;
    for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST && glfwGetWindowAttrib(m_window, GLFW_FOCUSED); ++id) {
        GLFWgamepadstate state;
        if (!glfwGetGamepadState(id, &state)) continue; // none there, or one of which it is not known what its axes are
        PadState& pad = pads.emplace_back();
        std::ranges::transform(state.buttons, pad.buttons.begin(), [](unsigned char button) { return button == GLFW_PRESS; });
        std::ranges::copy(state.axes, pad.axes.begin());
    }
    return heldOn(pads);
}

void Window::setTitle(const std::string& title)
{
    if (title == m_title) return;
    m_title = title;
    glfwSetWindowTitle(m_window, title.c_str());
}

void Window::setPointerHidden(bool hidden)
{
    if (hidden == m_pointerHidden) return;
    m_pointerHidden = hidden;
    glfwSetInputMode(m_window, GLFW_CURSOR, hidden ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
}

void Window::swap()
{
    glfwSwapBuffers(m_window);
}

bool Window::waitForEvents(double seconds)
{
    const std::uint64_t events = m_seenEvents;
    const glm::dvec2 pointer = m_seenPointer;
    glfwWaitEventsTimeout(seconds);
    noteSeen();
    return m_events != events || (glfwGetWindowAttrib(m_window, GLFW_HOVERED) && m_seenPointer != pointer);
}

void Window::takeEvents()
{
    glfwPollEvents();
    noteSeen();
}

void Window::noteSeen()
{
    m_seenEvents = m_events;
    glfwGetCursorPos(m_window, &m_seenPointer.x, &m_seenPointer.y);
}

} // namespace app
