// A placed object's surface at a pixel, from its material and its textures. For fragments of objects.vert.glsl.
#include "shared/bindings.h"
#include "shared/instance.h"
#include "shared/material.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray baseColours;
layout(location = 0) in vec2 uvBase;
layout(location = 1) in vec3 normal;
#ifdef SMOOTH_COLOURS
layout(location = 2) in vec4 rootColour; // square roots of the base colour's factors; alpha as it is
#endif
// Whole words, as software GL pays for each number that a triangle hands on: object; flags of instance and material;
// layers of colour and normals (16 bits each); roughness and metallic (unorm16)
layout(location = 3) flat in uvec4 words0;
// cutoff and normal scale (unorm16); root colour; layers of surface and occlusion
layout(location = 4) flat in uvec4 words1;
#ifdef NORMAL_MAP
layout(binding = NORMAL_UNIT) uniform sampler2DArray normalMaps;
layout(location = 5) in vec4 tangent;
layout(location = 6) in vec2 uvNormal;
#endif
#ifdef SURFACE_MAPS
layout(binding = SURFACE_UNIT) uniform sampler2DArray surfaceMaps;
layout(binding = OCCLUSION_UNIT) uniform sampler2DArray occlusionMaps;
layout(binding = EMISSIVE_UNIT) uniform sampler2DArray emissiveMaps;
layout(location = 7) in vec4 uvSurfaceOcclusion;
layout(location = 8) in vec2 uvEmissive;
layout(location = 9) flat in vec4 emissive;
layout(location = 10) flat in uint emissiveLayer;
#endif
#ifdef WRAP
layout(location = 12) flat in uint wrapModes;
#endif

uint objectHere()
{
    return words0.x;
}

bool isSelected()
{
    return (words0.y & INSTANCE_SELECTED) != 0u;
}

uint materialFlags()
{
    return words0.y >> 8;
}

float alphaCutoff()
{
    return unpackUnorm2x16(words1.x).x;
}

struct MaterialSample {
    vec4 root; // square roots of the base colour; alpha as it is
    vec3 normal;
    float roughness;
    float metallic;
    float occlusion;
    vec3 emissive;
};

#ifdef WRAP
float wrapped(float u, uint mode, float halfTexel)
{
    float mirrored = 1.0 - abs(fract(u * 0.5) * 2.0 - 1.0);
    return mode == 1u ? clamp(u, halfTexel, 1.0 - halfTexel) : mode == 2u ? mirrored : u;
}
#endif

// White where the material has no such texture. Colours are square roots of light: the caller squares them.
vec4 fetch(sampler2DArray maps, vec2 uv, uint layer, int slot)
{
    bool none = layer == 0xffffu;
    float index = none ? 0.0 : float(layer);
#ifdef WRAP
    uint modes = wrapModes >> (4 * slot);
    vec2 halfTexel = 0.5 / vec2(textureSize(maps, 0).xy);
    vec2 place = vec2(wrapped(uv.x, modes & 3u, halfTexel.x), wrapped(uv.y, (modes >> 2) & 3u, halfTexel.y));
    vec4 texel = textureGrad(maps, vec3(place, index), dFdx(uv), dFdy(uv));
#else
    vec4 texel = texture(maps, vec3(uv, index));
#endif
    return none ? vec4(1.0) : texel;
}

MaterialSample sampleMaterial(bool front)
{
    MaterialSample m;
#ifdef SMOOTH_COLOURS
    vec4 factor = rootColour;
#else
    vec4 factor = vec4(unpackUnorm2x16(words1.y), unpackUnorm2x16(words1.z));
#endif
    m.root = factor * fetch(baseColours, uvBase, words0.z & 0xffffu, BASE_COLOUR_UNIT);
    vec3 n = normalize(normal);
#ifdef NORMAL_MAP
    vec3 detail = fetch(normalMaps, uvNormal, words0.z >> 16, NORMAL_UNIT).xyz * 2.0 - 1.0;
    detail = (words0.z >> 16) == 0xffffu ? vec3(0.0, 0.0, 1.0) : detail;
    float scale = unpackUnorm2x16(words1.x).y * MATERIAL_MOST_SCALE;
    vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
    t *= inversesqrt(max(dot(t, t), 1e-20));
    vec3 b = cross(n, t) * tangent.w;
    n = normalize(t * (detail.x * scale) + b * (detail.y * scale) + n * detail.z);
#endif
    m.normal = front || (materialFlags() & MATERIAL_KEEP_NORMAL) != 0u ? n : -n;
    vec2 rough = unpackUnorm2x16(words0.w);
    m.roughness = rough.x;
    m.metallic = rough.y;
    m.occlusion = 1.0;
    m.emissive = vec3(0.0);
#ifdef SURFACE_MAPS
    vec4 roughMetal = fetch(surfaceMaps, uvSurfaceOcclusion.xy, words1.w & 0xffffu, SURFACE_UNIT);
    m.roughness *= roughMetal.g;
    m.metallic *= roughMetal.b;
    float occlusion = fetch(occlusionMaps, uvSurfaceOcclusion.zw, words1.w >> 16, OCCLUSION_UNIT).r;
    m.occlusion = 1.0 + (occlusion - 1.0) * emissive.w;
    vec3 glow = fetch(emissiveMaps, uvEmissive, emissiveLayer, EMISSIVE_UNIT).rgb;
    m.emissive = emissive.rgb * glow * glow;
#endif
    m.roughness = clamp(m.roughness, 0.045, 1.0);
    return m;
}
