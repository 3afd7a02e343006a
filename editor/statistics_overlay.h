// The statistics over the picture: where a frame's time goes, and what of the world was drawn in it.
#pragma once

#include "editor/frame_history.h"
#include "editor/memory.h"

#include <imgui.h>
#include <string>

namespace editor {

// `top` is its upper left corner; it is narrower where `room` asks for it, and in two columns where that is too low for one.
void statisticsOverlay(const FrameHistory& frames, const renderer::FrameStats& stats, const WorldMemory& world, ImVec2 top,
                       ImVec2 room);

std::string grassText(const renderer::FrameStats& stats, bool why); // drawn, and of how many where that is not all; and why

} // namespace editor
