// Blades of seven vertices out of seeds.
#include "view.glsl"
#include "grass_blade.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 7) out;

layout(location = 0) in vec3 root[];
layout(location = 1) flat in uint size[];
layout(location = 2) flat in uvec4 look[];

void main()
{
    for (int i = 0; i < 7; ++i) {
        bladeVertex(i, root[0], size[0], look[0]);
        EmitVertex();
    }
    EndPrimitive();
}
