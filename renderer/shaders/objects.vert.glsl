// Vertices of placed objects. The instance comes by way of a list that culling wrote, one number a copy.
#include "octahedron.glsl"
#include "records.glsl"
#include "shared/drawn.h"
#include "view.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec2 inNormal;
layout(location = 2) in uint inTangent;
layout(location = 3) in vec4 inColour;
layout(location = 4) in vec2 inUv0;
layout(location = 5) in vec2 inUv1;
layout(location = 6) in uint inMaterial;
layout(location = 7) in uint inInstance;

invariant gl_Position; // passes that draw the same surface again compare depths for equality

#ifdef LEVELS
layout(location = 1) flat out float level;
#endif
#ifdef FADE
layout(location = 13) flat out uint fade;
#endif
#ifndef POSITION_ONLY
layout(location = 0) out vec2 uvBase;
#ifndef SHADOW
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 colour;
layout(location = 3) flat out uvec4 ids;     // object, flags of instance and material, layers (16 bits each) 0-1, 2-3
layout(location = 4) flat out vec4 surface;  // roughness, metallic, alpha cutoff, normal scale
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

uint layerBits(int layer)
{
    return uint(layer) & 0xffffu;
}

void main()
{
    uint slot = inInstance & DRAWN_SLOT_MASK;
    Instance instance = instanceAt(slot);
    vec3 axisX = instance.axisX.xyz;
    vec3 axisY = instance.axisY.xyz;
    vec3 axisZ = instance.axisZ.xyz;
    vec3 eyeToOrigin = (instance.positionHigh - view.eyeHigh) + (instance.positionLow - view.eyeLow);
    vec3 place = eyeToOrigin + axisX * inPosition.x + axisY * inPosition.y + axisZ * inPosition.z;
    gl_Position = view.clipFromRelative * vec4(place, 1.0);
#ifdef LEVELS
    level = float((inInstance >> DRAWN_LEVEL_SHIFT) & DRAWN_LEVEL_MASK);
#endif
#ifdef FADE
    fade = inInstance >> DRAWN_FADE_SHIFT;
#endif

#ifndef POSITION_ONLY
    MaterialTexture base = materialTexture(inMaterial, BASE_COLOUR_UNIT);
    uvBase = transformed(base);
#ifdef WRAP
    wrapModes = 0u;
    for (int i = 0; i < MATERIAL_TEXTURES; ++i)
        wrapModes |= ((materialTexture(inMaterial, i).mode >> TEXTURE_WRAP_U_SHIFT) & 15u) << (4 * i);
#endif
#ifdef SHADOW
    cutout = vec3(float(base.layer), materialTexel(inMaterial, MATERIAL_FACTORS_TEXEL).w,
                  materialTexel(inMaterial, MATERIAL_BASE_COLOUR_TEXEL).a * inColour.a);
#else
    // Cofactors turn normals rightly under any scale; a mirror image turns them once more.
    vec3 n = fromOctahedral(inNormal);
    vec3 cofactorX = cross(axisY, axisZ);
    float mirror = sign(dot(axisX, cofactorX));
    normal = (cofactorX * n.x + cross(axisZ, axisX) * n.y + cross(axisX, axisY) * n.z) * mirror;
    colour = materialTexel(inMaterial, MATERIAL_BASE_COLOUR_TEXEL) * inColour;
    vec4 factors = materialTexel(inMaterial, MATERIAL_FACTORS_TEXEL); // metallic, normal scale, occlusion, cutoff
    vec4 emission = materialTexel(inMaterial, MATERIAL_EMISSIVE_TEXEL); // and roughness
    int normalLayer = materialTexture(inMaterial, NORMAL_UNIT).layer;
    uint layers = layerBits(base.layer) | layerBits(normalLayer) << 16;
    uint layers2 = 0u;
    surface = vec4(emission.w, factors.x, factors.w, factors.y);
#ifdef NORMAL_MAP
    int bits = int(inTangent);
    vec2 packed_ = vec2(float(bitfieldExtract(bits, 0, 16)) / 32767.0, float(bitfieldExtract(bits, 16, 15)) / 16383.0);
    vec3 t = fromOctahedral(clamp(packed_, -1.0, 1.0));
    tangent = vec4(axisX * t.x + axisY * t.y + axisZ * t.z, inTangent >= 0x80000000u ? -mirror : mirror);
    uvNormal = transformed(materialTexture(inMaterial, NORMAL_UNIT));
#endif
#ifdef SURFACE_MAPS
    MaterialTexture surfaceUse = materialTexture(inMaterial, SURFACE_UNIT);
    MaterialTexture occlusionUse = materialTexture(inMaterial, OCCLUSION_UNIT);
    MaterialTexture emissiveUse = materialTexture(inMaterial, EMISSIVE_UNIT);
    uvSurfaceOcclusion = vec4(transformed(surfaceUse), transformed(occlusionUse));
    uvEmissive = transformed(emissiveUse);
    emissive = vec4(emission.rgb, factors.z);
    emissiveLayer = layerBits(emissiveUse.layer);
    layers2 = layerBits(surfaceUse.layer) | layerBits(occlusionUse.layer) << 16;
#endif
    uint flags = texelFetch(instanceFlags, int(slot)).x | materialFlags(inMaterial) << 8;
    ids = uvec4(instance.objectId, flags, layers, layers2);
#ifdef FORWARD
    relative = place;
#endif
#endif
#endif
}
