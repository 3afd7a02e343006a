#include "app/imgui_host.h"

#include "app/fonts.h"
#include "app/window.h"
#include "editor/pointer_way.h"
#include "editor/theme.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace app {
namespace {

// The same numbers as the window's backend uses, so that the editor sees one keyboard.
void mapKeys(ImGuiIO& io)
{
    constexpr std::pair<ImGuiKey, int> kKeys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                                  {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                                  {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                                  {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                                  {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                                  {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                                  {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                                  {ImGuiKey_Home, GLFW_KEY_HOME},
                                                  {ImGuiKey_End, GLFW_KEY_END},
                                                  {ImGuiKey_Insert, GLFW_KEY_INSERT},
                                                  {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                                  {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                                  {ImGuiKey_Space, GLFW_KEY_SPACE},
                                                  {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                                  {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                                  {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                                                  {ImGuiKey_A, GLFW_KEY_A},
                                                  {ImGuiKey_C, GLFW_KEY_C},
                                                  {ImGuiKey_V, GLFW_KEY_V},
                                                  {ImGuiKey_X, GLFW_KEY_X},
                                                  {ImGuiKey_Y, GLFW_KEY_Y},
                                                  {ImGuiKey_Z, GLFW_KEY_Z}};
    for (const auto& [key, code] : kKeys)
        io.KeyMap[key] = code;
}

ImguiHost* g_host = nullptr; // whose window has the key callback; there is one window

} // namespace

ImguiHost::ImguiHost(Window* window, float scale) : m_window{window}
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // the workspace remembers the layout
    io.LogFilename = nullptr;
    if (m_window) {
        ImGui_ImplGlfw_InitForOpenGL(m_window->handle(), true);
        keepShortTaps();
    } else {
        mapKeys(io);
    }
    setScale(scale);
    ImGui_ImplOpenGL3_Init("#version 450");
}

ImguiHost::~ImguiHost()
{
    ImGui_ImplOpenGL3_Shutdown();
    g_host = nullptr;
    if (m_window) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

// ImGui 1.86 looks at keys once a frame, so one that goes down and up within a frame (slow drawing, a quick hand) would
// be lost, and with it a chord or a click whose Ctrl was let go in the same frame: releases wait while what came before
// them is unseen.
void ImguiHost::keepShortTaps()
{
    g_host = this;
    glfwSetKeyCallback(m_window->handle(), [](GLFWwindow*, int key, int scancode, int action, int mods) {
        if (g_host) g_host->onKey(key, scancode, action, mods);
    });
    glfwSetCursorPosCallback(m_window->handle(), [](GLFWwindow*, double x, double y) {
        if (!g_host) return;
        g_host->m_pointer = {x, y};
        g_host->m_way.emplace_back(x, y);
    });
    glfwSetMouseButtonCallback(m_window->handle(), [](GLFWwindow*, int button, int action, int mods) {
        if (g_host) g_host->onButton(button, action, mods);
    });
}

void ImguiHost::onKey(int key, int scancode, int action, int mods)
{
    if (action == GLFW_RELEASE && m_unseenFrames > 0) return m_releases.push_back({key, scancode, mods});
    if (action == GLFW_PRESS) {
        m_unseenFrames = std::max(m_unseenFrames, 1);
        std::erase_if(m_releases, [key](const Release& release) { return release.key == key; });
    }
    ImGui_ImplGlfw_KeyCallback(m_window->handle(), key, scancode, action, mods);
}

void ImguiHost::onButton(int button, int action, int mods)
{
    // By the events so far: glfwGetCursorPos would ask where the pointer is by now.
    m_unseenFrames = std::max(m_unseenFrames, action == GLFW_RELEASE && m_pressedAt ? 2 : 1);
    if (action == GLFW_PRESS) m_pressedAt = m_pointer, m_releasedAt.reset();
    if (action == GLFW_RELEASE) m_releasedAt = m_pointer;
    ImGui_ImplGlfw_MouseButtonCallback(m_window->handle(), button, action, mods);
}

// The pointer may have gone on within a slow frame: a click counts where it was made. A click that began and ended within
// one frame is held down for that frame, and let go in the next.
void ImguiHost::pointerWhereItActed()
{
    std::optional<glm::vec2>& at = m_pressedAt ? m_pressedAt : m_releasedAt;
    if (at) ImGui::GetIO().MousePos = {at->x, at->y};
    at.reset();
}

void ImguiHost::setScale(float scale)
{
    if (std::abs(scale - m_scale) < 0.01f) return;
    const bool again = m_scale > 0;
    m_scale = scale;
    editor::applyTheme();
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    editor::addFonts(*io.Fonts, findFonts(), scale);
    if (again) ImGui_ImplOpenGL3_DestroyFontsTexture();
    if (again) ImGui_ImplOpenGL3_CreateFontsTexture();
}

void ImguiHost::begin(glm::ivec2 size, double seconds)
{
    ImGui_ImplOpenGL3_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    if (m_window) {
        ImGui_ImplGlfw_NewFrame(); // in the system's units, which are pixels on X11 and may be more on Wayland
        pointerWhereItActed();
        const float toPoints = io.DisplayFramebufferScale.x / m_scale;
        if (ImGui::IsMousePosValid(&io.MousePos)) io.MousePos = {io.MousePos.x * toPoints, io.MousePos.y * toPoints};
        std::vector<glm::dvec2> way = std::exchange(m_way, {});
        for (glm::dvec2& point : way)
            point *= double(toPoints);
        editor::setPointerWay(std::move(way));
        size = m_window->pixels();
    } else {
        io.DeltaTime = float(seconds);
    }
    // The window's content is laid out in points and drawn as so many pixels each: all of it keeps its proportions.
    io.DisplaySize = {float(size.x) / m_scale, float(size.y) / m_scale};
    io.DisplayFramebufferScale = {m_scale, m_scale};
    ImGui::NewFrame();
}

void ImguiHost::end()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (m_unseenFrames > 0 && --m_unseenFrames > 0) return;
    for (const Release& late : std::exchange(m_releases, {}))
        ImGui_ImplGlfw_KeyCallback(m_window->handle(), late.key, late.scancode, GLFW_RELEASE, late.mods);
}

} // namespace app
