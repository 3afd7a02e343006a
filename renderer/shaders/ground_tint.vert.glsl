// A part of the ground, seen from above: the colours that grass takes from it.
#include "terrain.glsl"

layout(location = 0) uniform vec4 part; // texels of the ground: low corner and extent

layout(location = 0) out vec3 place; // texel x, z; height, m: found for each pixel

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    place = vec3(part.xy + corner * part.zw, 0.0);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
