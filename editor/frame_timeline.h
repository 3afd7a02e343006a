// The frame timeline: a bar for each of the last frames, made of its passes.
#pragma once

#include "editor/frame_history.h"

#include <imgui.h>
#include <string_view>

namespace editor {

enum class Clock { Cpu, Gpu };

ImU32 colourOfPass(const std::vector<renderer::PassTime>& passes, std::string_view name); // the same while `passes` are
// Draws into `min`..`max`, the newest frame at the right, with what one full height means.
void frameTimeline(ImDrawList& draw, const FrameHistory& frames, Clock clock, ImVec2 min, ImVec2 max);

} // namespace editor
