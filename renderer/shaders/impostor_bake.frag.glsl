// A model into the frames of its impostor: each frame is a copy of it that objects.vert.glsl turned to where it is seen
// from. At twice the size that is kept.
#include "impostor.glsl"
#include "material.glsl"

layout(location = 0) out vec4 outColour;
layout(location = 1) out vec4 outSurface;

void main()
{
    MaterialSample m = sampleMaterial(gl_FrontFacing);
#ifdef MASK
    if (m.root.a < alphaCutoff()) discard;
#endif
    vec3 forward = frameDirection(floor(gl_FragCoord.xy / float(2 * IMPOSTOR_FRAME_TEXELS)));
    vec3 right = frameRight(forward);
    ImpostorTexel t;
    t.root = m.root.rgb;
    t.cover = 1.0;
    t.normal = right * m.normal.x + cross(forward, right) * m.normal.y + forward * m.normal.z;
    t.depth = (gl_FragCoord.z - 0.5) * (2.0 / IMPOSTOR_FILL);
    t.leaf = (materialFlags() & MATERIAL_LEAF) != 0u ? 1.0 : 0.0;
    ImpostorStore s = stored(t);
    outColour = s.colour;
    outSurface = s.surface;
}
