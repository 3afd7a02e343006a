// Placed objects into the GBuffer.
#include "cutout.glsl"
#include "fade.glsl"
#include "gbuffer_out.glsl"
#include "material.glsl"

void main()
{
#ifdef FADE
    if (fadedAway(gl_FragCoord.xy)) discard;
#endif
    MaterialSample m = sampleMaterial(gl_FrontFacing);
#ifdef MASK
    if (m.root.a < cutoutThreshold(uvBase, vec2(textureSize(baseColours, 0).xy), alphaCutoff(), objectHere())) discard;
#endif
    uint bits = isSelected() ? SURFACE_SELECTED : 0u;
    bits |= (materialFlags() & MATERIAL_LEAF) != 0u ? SURFACE_LEAF : 0u;
    bits |= (materialFlags() & MATERIAL_UNLIT) != 0u ? SURFACE_UNLIT : 0u;
    vec3 root = m.root.rgb;
    float emission = 0.0;
#ifdef SURFACE_MAPS
    float strongest = max(m.emissive.r, max(m.emissive.g, m.emissive.b));
    if (strongest > 0.004) { // the glow takes over the hue
        emission = strongest;
        root = sqrt(m.emissive / strongest);
    }
#endif
    writeSurface(root, m.occlusion, m.normal, m.roughness, m.metallic, bits, emission);
    outId = objectHere();
}
