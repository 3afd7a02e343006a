// A blade into the GBuffer. Whoever asks whose it is gets the ground.
#include "gbuffer_out.glsl"

layout(location = 0) in vec4 surface;
#if SEGMENTS == 1
layout(location = 1) flat in vec2 octahedralNormal;
#else
layout(location = 1) in vec3 normal;
#endif

const float kRoughness = 0.62;

void main()
{
#if SEGMENTS == 1
    vec2 turned = octahedralNormal;
#else
    vec2 turned = octahedral(normalize(normal));
#endif
    writePacked(surface, turned, kRoughness, 0.0, SURFACE_LEAF, 0.0);
    outId = 0xffffffffu;
}
