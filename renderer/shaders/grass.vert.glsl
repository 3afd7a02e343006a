// Blades as instanced strips.
#include "view.glsl"
#include "grass_blade.glsl"

layout(location = 0) in vec3 inRoot;
layout(location = 1) in uint inSize;
layout(location = 2) in uvec4 inLook; // bend, look, ground, slope: GrassBlade

void main()
{
    bladeVertex(gl_VertexID, inRoot, inSize, inLook);
}
