// Draws of no more than there is room for: one for each shape of blades and each part of models; or one of seeds.
#include "shared/bindings.h"
#include "shared/grass.h"

layout(local_size_x = 64) in;

struct Elements {
    uint count, instances, first;
    int baseVertex;
    uint baseInstance;
};
struct Arrays {
    uint count, instances, first, baseInstance;
};

layout(std140, binding = GRASS_BINDING) uniform GrassBlock { GrassFrame grass; };
layout(std430, binding = GRASS_COUNTS_BINDING) readonly buffer Counts { GrassCounts counts; };
#ifdef SEEDS
layout(std430, binding = GRASS_COMMANDS_BINDING) writeonly buffer Commands { Arrays commands[]; };
#else
layout(std430, binding = GRASS_COMMANDS_BINDING) writeonly buffer Commands { Elements commands[]; };
#endif
#ifdef PLANTS
layout(std430, binding = GRASS_PARTS_BINDING) readonly buffer Parts { GrassPart parts[]; };
layout(std430, binding = GRASS_PLANT_COMMANDS_BINDING) writeonly buffer PlantCommands { Elements plantCommands[]; };
layout(location = 0) uniform uint partCount;
#endif

void main()
{
    uint i = gl_LocalInvocationIndex;
#ifdef SEEDS
    if (i == 0u) commands[0] = Arrays(min(counts.taken, min(grass.most, grass.room)), 1u, 0u, 0u);
#else
    if (i < GRASS_SHAPES) {
        uint bundles = (min(counts.shape[i], grass.room) + GRASS_BUNDLE - 1u) / GRASS_BUNDLE;
        commands[i] = Elements(uint(grassIndices(int(i))), bundles, uint(grassFirstIndex(int(i))), 0, 0u);
    }
#endif
#ifdef PLANTS
    for (; i < partCount; i += 64u) {
        GrassPart part = parts[i];
        plantCommands[i] = Elements(part.indexCount, min(counts.plants[part.plants], grass.plantRoom), part.firstIndex, 0, part.plants * grass.plantRoom);
    }
#endif
}
