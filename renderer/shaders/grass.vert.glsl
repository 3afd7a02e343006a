// Blades in bundles: what an instance costs is shared by GRASS_BUNDLE of them. SHAPE says which list they lie in, SEGMENTS how long they are.
#include "view.glsl"
#include "grass_blade.glsl"

layout(std430, binding = GRASS_BLADES_BINDING) readonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = GRASS_COUNTS_BINDING) readonly buffer Counts { GrassCounts counts; };

const int kVertices = SEGMENTS * 2 + 1;

void main()
{
    uint i = uint(gl_InstanceID * GRASS_BUNDLE + gl_VertexID / kVertices);
    bool there = i < min(counts.shape[SHAPE], grass.room); // the last bundle is not full
    GrassBlade blade = blades[uint(SHAPE) * grass.room + (there ? i : 0u)];
    bladeVertex(gl_VertexID % kVertices, blade.root, blade.size, uvec4(blade.bend, blade.look, blade.ground, blade.slope));
    if (!there) gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // all its triangles are this point
}
