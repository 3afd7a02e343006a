// Placed objects into the GBuffer.
#include "cutout.glsl"
#include "fade.glsl"
#include "gbuffer_out.glsl"
#include "material.glsl"
#include "shared/instance.h"

void main()
{
#ifdef FADE
    if (fadedAway(gl_FragCoord.xy)) discard;
#endif
    MaterialSample m = sampleMaterial(gl_FrontFacing);
#ifdef MASK
    if (m.baseColour.a < cutoutThreshold(uvBase, vec2(textureSize(baseColours, 0).xy), surface.z, ids.x)) discard;
#endif
    uint flags = ids.y >> 8;
    uint bits = (ids.y & INSTANCE_SELECTED) != 0u ? SURFACE_SELECTED : 0u;
    bits |= (flags & MATERIAL_LEAF) != 0u ? SURFACE_LEAF : 0u;
    bits |= (flags & MATERIAL_UNLIT) != 0u ? SURFACE_UNLIT : 0u;
    vec3 base = m.baseColour.rgb;
    float emission = 0.0;
#ifdef SURFACE_MAPS
    float strongest = max(m.emissive.r, max(m.emissive.g, m.emissive.b));
    if (strongest > 0.004) { // the glow takes over the hue
        emission = strongest;
        base = m.emissive / strongest;
    }
#endif
    writeSurface(base, m.occlusion, m.normal, m.roughness, m.metallic, bits, emission);
    outId = ids.x;
}
