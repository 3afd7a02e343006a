// Gives each bin its place among the view's instances, and each mesh part its draw command. One work group.
#include "shared/bindings.h"
#include "shared/culling.h"

layout(local_size_x = 256) in;
layout(std430, binding = CULL_BINS_BINDING) buffer Bins { CullBin bins[]; };
layout(std430, binding = CULL_PARTS_BINDING) readonly buffer Parts { CullPart parts[]; };
layout(std430, binding = CULL_COMMANDS_BINDING) writeonly buffer Commands { uint commands[]; };
layout(std430, binding = CULL_COUNTS_BINDING) buffer Counts { CullCounts counts; };
layout(location = 0) uniform uvec3 sizes; // bins, parts, instances that there is room for

shared uint sums[256];

void main()
{
    uint thread = gl_LocalInvocationID.x;
    uint share = (sizes.x + 255u) / 256u;
    uint begin = min(thread * share, sizes.x), end = min(begin + share, sizes.x);
    uint sum = 0u;
    for (uint i = begin; i < end; ++i)
        sum += bins[i].count;
    sums[thread] = sum;
    barrier();
    if (thread == 0u) {
        uint total = 0u;
        for (uint i = 0u; i < 256u; ++i) {
            uint own = sums[i];
            sums[i] = total;
            total += own;
        }
        counts.copies = max(counts.copies, total); // of both lists of a frame
    }
    barrier();
    uint place = sums[thread];
    for (uint i = begin; i < end; ++i) {
        bins[i].first = min(place, sizes.z);
        bins[i].next = bins[i].first;
        place += bins[i].count;
        bins[i].end = min(place, sizes.z);
    }
    memoryBarrierBuffer();
    barrier();
    for (uint i = thread; i < sizes.y; i += 256u) {
        CullPart part = parts[i];
        uint first = bins[part.bin].first;
        uint instances = bins[part.bin].end - first;
        if (instances > 0u) atomicAdd(counts.triangles[part.level], instances * (part.indexCount / 3u));
        commands[i * 5u] = part.indexCount;
        commands[i * 5u + 1u] = instances;
        commands[i * 5u + 2u] = part.firstIndex;
        commands[i * 5u + 3u] = 0u;
        commands[i * 5u + 4u] = first;
    }
}
