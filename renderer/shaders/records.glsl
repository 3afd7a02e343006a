// Instances and materials out of their buffer textures.
#include "shared/bindings.h"
#include "shared/instance.h"
#include "shared/material.h"

layout(binding = INSTANCES_UNIT) uniform usamplerBuffer instanceTexels;
layout(binding = INSTANCE_FLAGS_UNIT) uniform usamplerBuffer instanceFlags;
layout(binding = MATERIALS_UNIT) uniform usamplerBuffer materialTexels;

Instance instanceAt(uint index)
{
    int first = int(index) * INSTANCE_TEXELS;
    uvec4 high = texelFetch(instanceTexels, first);
    uvec4 low = texelFetch(instanceTexels, first + 1);
    Instance instance;
    instance.positionHigh = uintBitsToFloat(high.xyz);
    instance.objectId = high.w;
    instance.positionLow = uintBitsToFloat(low.xyz);
    instance.axisX = uintBitsToFloat(texelFetch(instanceTexels, first + 2));
    instance.axisY = uintBitsToFloat(texelFetch(instanceTexels, first + 3));
    instance.axisZ = uintBitsToFloat(texelFetch(instanceTexels, first + 4));
    return instance;
}

vec4 materialTexel(uint material, int texel)
{
    return uintBitsToFloat(texelFetch(materialTexels, int(material) * MATERIAL_TEXELS + texel));
}

uint materialFlags(uint material)
{
    return texelFetch(materialTexels, int(material) * MATERIAL_TEXELS + MATERIAL_FLAGS_TEXEL).x;
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
