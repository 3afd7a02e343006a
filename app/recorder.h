// Recorder: what mouse and keys do in the window, written as a replay.
#pragma once

#include <filesystem>
#include <fstream>
#include <imgui.h>
#include <vector>

namespace app {

class Recorder {
public:
    explicit Recorder(const std::filesystem::path& file) : m_file{file} {}
    bool open() const { return m_file.is_open(); }
    void frame(const ImGuiIO& io); // after ImGui::NewFrame()

private:
    void keys(const ImGuiIO& io, bool down, bool modifiers);
    void write(const std::string& line); // after the frames in which nothing happened

    std::ofstream m_file;
    ImVec2 m_mouse{-1, -1};
    bool m_buttons[3] = {};
    bool m_keys[512] = {};
    int m_idle = 0; // frames
};

} // namespace app
