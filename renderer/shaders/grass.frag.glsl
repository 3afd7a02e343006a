// A blade into the GBuffer. Whoever asks whose it is gets the ground.
#include "octahedron.glsl"
#include "shared/gbuffer.h"

layout(location = 0) in vec4 surface;
#if SEGMENTS == 1
layout(location = 1) flat in vec2 octahedralNormal;
#else
layout(location = 1) in vec3 normal;
#endif

layout(location = 0) out vec4 outColour;
layout(location = 1) out vec2 outNormal;
layout(location = 2) out vec4 outSurface;
layout(location = 3) out uint outId;

const float kRoughness = 0.62;

void main()
{
    outColour = surface;
#if SEGMENTS == 1
    outNormal = octahedralNormal;
#else
    outNormal = octahedral(normalize(normal));
#endif
    outSurface = vec4(kRoughness, 0.0, float(SURFACE_LEAF) / 255.0, 0.0);
    outId = 0xffffffffu;
}
