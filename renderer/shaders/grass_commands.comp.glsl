// One draw for each shape of blades, of no more than there is room for.
#include "shared/bindings.h"
#include "shared/grass.h"

layout(local_size_x = GRASS_SHAPES) in;

struct Command {
    uint count, instances, first, baseInstance;
};

layout(std140, binding = GRASS_BINDING) uniform GrassBlock { GrassFrame grass; };
layout(std430, binding = GRASS_COUNTS_BINDING) readonly buffer Counts { GrassCounts counts; };
layout(std430, binding = GRASS_COMMANDS_BINDING) writeonly buffer Commands { Command commands[]; };

void main()
{
    const uint vertices[GRASS_SHAPES] = uint[](15u, 7u, 3u);
    uint shape = gl_LocalInvocationIndex;
    commands[shape] = Command(vertices[shape], min(counts.shape[shape], grass.room), 0u, shape * grass.room);
}
