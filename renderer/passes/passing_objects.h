// Objects that are drawn but stand in no scene: ghosts of what is being placed, the model of a thumbnail.
#pragma once

#include "renderer/gpu_frame.h"
#include "renderer/world.h"

namespace renderer {

// What to draw of them.
std::vector<DrawList> drawsOf(GpuFrame& gpu, const World& world, std::span<const Ghost> objects);

} // namespace renderer
