// A blade into the GBuffer. Whoever asks whose it is gets the ground.
#include "gbuffer_out.glsl"

layout(location = 0) in vec3 colour;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open;

void main()
{
    writeSurface(sqrt(colour), open, normalize(normal), 0.62, 0.0, SURFACE_LEAF, 0.0);
    outId = 0xffffffffu;
}
