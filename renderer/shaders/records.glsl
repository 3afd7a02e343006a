// The instance that a vertex belongs to, from its attributes, and materials out of their buffer texture.
#include "shared/bindings.h"
#include "shared/drawn.h"
#include "shared/instance.h"
#include "shared/material.h"

layout(binding = MATERIALS_UNIT) uniform usamplerBuffer materialTexels;

layout(location = 7) in uvec4 inPositionHigh; // and object
layout(location = 8) in uvec4 inPositionLow;  // and what is drawn
layout(location = 9) in vec3 inAxisX;
layout(location = 10) in vec3 inAxisY;
layout(location = 11) in vec3 inAxisZ;
#ifdef WIND
layout(location = 12) in float inSwayX; // of the plant's top, m
layout(location = 13) in float inSwayZ;
layout(location = 14) in float inPerHeight; // 1 / the model's height
#endif

// From the eye, m; `high` and `low` are the eye's.
vec3 instancePlace(vec3 high, vec3 low)
{
    return (uintBitsToFloat(inPositionHigh.xyz) - high) + (uintBitsToFloat(inPositionLow.xyz) - low);
}

uint instanceObject()
{
    return inPositionHigh.w;
}

uint instanceFlags()
{
    return inPositionLow.w & DRAWN_FLAGS_MASK;
}

#ifdef LEVELS
layout(location = 1) flat out float level;
#endif
#ifdef FADE
layout(location = 13) flat out uint fade;
#endif

// What fragments know of the level of detail, where they ask.
void passOnLevel()
{
#ifdef LEVELS
    level = float((inPositionLow.w >> DRAWN_LEVEL_SHIFT) & DRAWN_LEVEL_MASK);
#endif
#ifdef FADE
    fade = inPositionLow.w >> DRAWN_FADE_SHIFT;
#endif
}

struct QuickMaterial {
    vec4 baseColour;
    uint layers; // of colour, and of normals in the upper half; 0xffff: none
    uint flags;
    uint rough, cut; // roughness, metallic; cutoff, normal scale: unorm16
};

QuickMaterial quickMaterial(uint material)
{
    uvec4 a = texelFetch(materialTexels, int(material) * MATERIAL_TEXELS + MATERIAL_QUICK_TEXEL);
    uvec4 b = texelFetch(materialTexels, int(material) * MATERIAL_TEXELS + MATERIAL_QUICK_TEXEL + 1);
    QuickMaterial m;
    m.baseColour = vec4(unpackUnorm2x16(a.x), unpackUnorm2x16(a.y));
    m.layers = a.z;
    m.flags = a.w;
    m.rough = b.x;
    m.cut = b.y;
    return m;
}

vec4 materialTexel(uint material, int texel)
{
    return uintBitsToFloat(texelFetch(materialTexels, int(material) * MATERIAL_TEXELS + texel));
}

MaterialTexture materialTexture(uint material, int unit)
{
    int first = int(material) * MATERIAL_TEXELS + MATERIAL_TEXTURE_TEXEL + 2 * unit;
    uvec4 place = texelFetch(materialTexels, first + 1);
    MaterialTexture use;
    use.matrix = uintBitsToFloat(texelFetch(materialTexels, first));
    use.offset = uintBitsToFloat(place.xy);
    use.layer = int(place.z);
    use.mode = place.w;
    return use;
}
