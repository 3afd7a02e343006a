// Vertices of placed objects.
#include "octahedron.glsl"
#include "records.glsl"
#include "shared/wind.h"
#include "view.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec2 inNormal;
layout(location = 2) in uint inTangent;
layout(location = 3) in vec4 inColour;
layout(location = 4) in vec2 inUv0;
layout(location = 5) in vec2 inUv1;
layout(location = 6) in uint inMaterial;

invariant gl_Position; // passes that draw the same surface again compare depths for equality

#ifndef POSITION_ONLY
layout(location = 0) out vec2 uvBase;
#ifndef SHADOW
layout(location = 1) out vec3 normal;
#ifdef SMOOTH_COLOURS
layout(location = 2) out vec4 rootColour;
#endif
layout(location = 3) flat out uvec4 words0;  // as material.glsl reads them
layout(location = 4) flat out uvec4 words1;
#ifdef NORMAL_MAP
layout(location = 5) out vec4 tangent;
layout(location = 6) out vec2 uvNormal;
#endif
#ifdef SURFACE_MAPS
layout(location = 7) out vec4 uvSurfaceOcclusion;
layout(location = 8) out vec2 uvEmissive;
layout(location = 9) flat out vec4 emissive; // and occlusion strength
layout(location = 10) flat out uint emissiveLayer;
#endif
#ifdef FORWARD
layout(location = 11) out vec3 relative;
#endif
#else
layout(location = 2) flat out vec3 cutout; // layer, cutoff, alpha factor
#endif
#ifdef WRAP
layout(location = 12) flat out uint wrapModes; // five bits a texture
#endif
#endif

vec2 transformed(MaterialTexture use)
{
    vec2 uv = (use.mode & TEXTURE_UV1) != 0u ? inUv1 : inUv0;
    return use.matrix.xy * uv.x + use.matrix.zw * uv.y + use.offset;
}

vec2 textureUv(int unit)
{
#ifdef UV_TRANSFORM
    return transformed(materialTexture(inMaterial, unit));
#else
    return inUv0;
#endif
}

#ifdef WIND
// From the instance's origin, m. Normals stay: a lean of a few degrees is not to be seen in the light. Leaves are cut
// out, so that nothing else fetches its material for them.
vec3 swayed(vec3 point)
{
    float share = inPosition.y * inPerHeight;
    vec3 moved = windBent(point, vec2(inSwayX, inSwayZ), share);
#ifdef MASK
    if ((quickMaterial(inMaterial).flags & MATERIAL_LEAF) != 0u) {
        float phase = float((inPositionLow.w >> DRAWN_PHASE_SHIFT) & 255u) / 256.0;
        float flutter = float((inPositionLow.w >> DRAWN_FLUTTER_SHIFT) & 255u) * (WIND_MOST_FLUTTER / 255.0);
        moved += windLeaf(inPosition, share, view.time, phase) * flutter;
    }
#endif
    return moved;
}
#endif

void main()
{
    vec3 origin = instancePlace(view.eyeHigh, view.eyeLow);
#ifdef WIND
    vec3 place = origin + swayed(inAxisX * inPosition.x + inAxisY * inPosition.y + inAxisZ * inPosition.z);
#else
    vec3 place = origin + inAxisX * inPosition.x + inAxisY * inPosition.y + inAxisZ * inPosition.z;
#endif
    gl_Position = view.clipFromRelative * vec4(place, 1.0);
    passOnLevel();

#ifndef POSITION_ONLY
    QuickMaterial material = quickMaterial(inMaterial);
    uvBase = textureUv(BASE_COLOUR_UNIT);
#ifdef WRAP
    wrapModes = 0u;
    for (int i = 0; i < MATERIAL_TEXTURES; ++i)
        wrapModes |= ((materialTexture(inMaterial, i).mode >> TEXTURE_WRAP_U_SHIFT) & 15u) << (4 * i);
#endif
#ifdef SHADOW
    uint layer = material.layers & 0xffffu;
    cutout = vec3(layer == 0xffffu ? -1.0 : float(layer), unpackUnorm2x16(material.cut).x, material.baseColour.a * inColour.a);
#else
    // Cofactors turn normals rightly under any scale; a mirror image turns them once more.
    vec3 n = fromOctahedral(inNormal);
    vec3 cofactorX = cross(inAxisY, inAxisZ);
    float mirror = sign(dot(inAxisX, cofactorX));
    normal = (cofactorX * n.x + cross(inAxisZ, inAxisX) * n.y + cross(inAxisX, inAxisY) * n.z) * mirror;
    vec4 root = vec4(sqrt(material.baseColour.rgb * inColour.rgb), material.baseColour.a * inColour.a);
#ifdef SMOOTH_COLOURS
    rootColour = root;
#endif
    uint otherLayers = 0u;
#ifdef NORMAL_MAP
    int bits = int(inTangent);
    vec2 packed_ = vec2(float(bitfieldExtract(bits, 0, 16)) / 32767.0, float(bitfieldExtract(bits, 16, 15)) / 16383.0);
    vec3 t = fromOctahedral(clamp(packed_, -1.0, 1.0));
    tangent = vec4(inAxisX * t.x + inAxisY * t.y + inAxisZ * t.z, inTangent >= 0x80000000u ? -mirror : mirror);
    uvNormal = textureUv(NORMAL_UNIT);
#endif
#ifdef SURFACE_MAPS
    MaterialTexture surfaceUse = materialTexture(inMaterial, SURFACE_UNIT);
    MaterialTexture occlusionUse = materialTexture(inMaterial, OCCLUSION_UNIT);
    MaterialTexture emissiveUse = materialTexture(inMaterial, EMISSIVE_UNIT);
    uvSurfaceOcclusion = vec4(transformed(surfaceUse), transformed(occlusionUse));
    uvEmissive = transformed(emissiveUse);
    emissive = vec4(materialTexel(inMaterial, MATERIAL_EMISSIVE_TEXEL).rgb,
                    materialTexel(inMaterial, MATERIAL_FACTORS_TEXEL).z); // and occlusion strength
    emissiveLayer = uint(emissiveUse.layer) & 0xffffu;
    otherLayers = (uint(surfaceUse.layer) & 0xffffu) | uint(occlusionUse.layer) << 16;
#endif
    words0 = uvec4(instanceObject(), instanceFlags() | material.flags << 8, material.layers, material.rough);
    words1 = uvec4(material.cut, packUnorm2x16(root.xy), packUnorm2x16(root.zw), otherLayers);
#ifdef FORWARD
    relative = place;
#endif
#endif
#endif
}
