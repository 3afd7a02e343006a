// Objects that are drawn but stand in no scene: ghosts of what is being placed, the model of a thumbnail.
#pragma once

#include "renderer/gpu_frame.h"
#include "renderer/object_records.h"
#include "renderer/world.h"

namespace renderer {

class PassingObjects {
public:
    // Their records are bound in place of the world's; what to draw of them.
    DrawList bind(GpuFrame& gpu, const World& world, std::span<const Ghost> objects);

private:
    ObjectRecords m_records;
};

} // namespace renderer
