// The share of light at places of the world, by the text that lights surfaces.
#include "shadows.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Places { vec4 place[]; }; // from the eye, m
layout(std430, binding = 1) readonly buffer Normals { vec4 normal[]; };
layout(std430, binding = 2) buffer Answers { float lit[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(lit.length())) lit[i] = sunVisibility(place[i].xyz, normal[i].xyz);
}
