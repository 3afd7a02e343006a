// Player: feeds the steps of a replay to ImGuiIO, one frame at a time.
#pragma once

#include "app/replay.h"

#include <functional>
#include <imgui.h>

namespace app {

class Player {
public:
    // What the player cannot do by itself; called between frames, when the last one is complete.
    struct Stage {
        std::function<io::Status(const std::filesystem::path&)> shot; // empty: the next file of --shot
        std::function<io::Status(const std::filesystem::path&)> uiMap;
        std::function<void(glm::ivec2)> resize;
        std::function<void(const step::Pad&)> pad = {};
    };
    Player(std::vector<Step> steps, std::string name, Stage stage);

    // Writes the next frame's input; false when there is none left.
    io::Result<bool> feed(ImGuiIO& io);

private:
    enum class Progress { NextStep, FrameDone, Waiting };
    io::Result<Progress> play(const Step& step, ImGuiIO& io);
    io::Result<Progress> move(const step::Move& move, ImGuiIO& io);
    io::Error atLine(const Step& step, const io::Error& error) const;

    std::vector<Step> m_steps;
    std::string m_name;
    Stage m_stage;
    std::size_t m_next = 0;
    int m_waited = 0; // frames that the step at hand has taken
};

} // namespace app
