// Which lamps reach which part of the view: tiles on the screen, cut into slices by depth that grow with it.
#pragma once

#include "renderer/lamps.h"
#include "renderer/shaders/shared/lamps.h"

namespace renderer {

struct LampClusters {
    float sliceScale = 1, sliceBias = 0;
    std::vector<std::uint32_t> lists; // of each cluster: first, count; then numbers of lamps
};

// Every lamp is in all clusters that its light can reach, and in few others.
LampClusters clustersOf(std::span<const Lamp> lamps, const Eye& eye);

} // namespace renderer
