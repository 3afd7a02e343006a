// Unit vectors as points of an octahedron: Meyer et al., "On Floating-Point Normal Vectors" (2010). The GBuffer keeps them
// as two signed 16-bit numbers, which is 0.004 degrees at the worst and exact along the axes.
#ifndef SHARED_OCTAHEDRON_H
#define SHARED_OCTAHEDRON_H
#include "shared.h"
SHARED_BEGIN

SHARED_FUNCTION vec2 octahedral(vec3 n)
{
    vec2 p = vec2(n.x, n.y) / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 folded = vec2((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f), (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f));
    return n.z >= 0.0f ? p : folded;
}

SHARED_FUNCTION vec3 fromOctahedral(vec2 p)
{
    vec3 v = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
    float fold = max(-v.z, 0.0f);
    v.x += v.x >= 0.0f ? -fold : fold;
    v.y += v.y >= 0.0f ? -fold : fold;
    return normalize(v);
}

SHARED_END
#endif
