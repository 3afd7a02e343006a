// Draws of no more than there is room for: one for each shape of blades and each part of models; or one of seeds.
#include "shared/bindings.h"
#include "shared/grass.h"

layout(local_size_x = 64) in;

struct Command {
    uint count, instances, first, baseInstance;
};

layout(std140, binding = GRASS_BINDING) uniform GrassBlock { GrassFrame grass; };
layout(std430, binding = GRASS_COUNTS_BINDING) readonly buffer Counts { GrassCounts counts; };
layout(std430, binding = GRASS_COMMANDS_BINDING) writeonly buffer Commands { Command commands[]; };
#ifdef PLANTS
layout(std430, binding = GRASS_PARTS_BINDING) readonly buffer Parts { GrassPart parts[]; };
layout(std430, binding = GRASS_PLANT_COMMANDS_BINDING) writeonly buffer PlantCommands { uint plantCommands[]; };
layout(location = 0) uniform uint partCount;
#endif

void main()
{
    uint i = gl_LocalInvocationIndex;
#ifdef SEEDS
    if (i == 0u) commands[0] = Command(min(counts.taken, min(grass.most, grass.room)), 1u, 0u, 0u);
#else
    const uint vertices[GRASS_SHAPES] = uint[](15u, 7u, 3u);
    if (i < GRASS_SHAPES) commands[i] = Command(vertices[i], min(counts.shape[i], grass.room), 0u, i * grass.room);
#endif
#ifdef PLANTS
    for (; i < partCount; i += 64u) {
        GrassPart part = parts[i];
        plantCommands[i * 5u] = part.indexCount;
        plantCommands[i * 5u + 1u] = min(counts.plants[part.plants], grass.plantRoom);
        plantCommands[i * 5u + 2u] = part.firstIndex;
        plantCommands[i * 5u + 3u] = 0u;
        plantCommands[i * 5u + 4u] = part.plants * grass.plantRoom;
    }
#endif
}
