// A placed object's surface at a pixel, from its material and its textures. For fragments of objects.vert.glsl.
#include "shared/bindings.h"
#include "shared/material.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray baseColours;
layout(location = 0) in vec2 uvBase;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
layout(location = 3) flat in uvec4 ids;
layout(location = 4) flat in vec4 surface;
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

struct MaterialSample {
    vec4 baseColour;
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
    vec4 base = fetch(baseColours, uvBase, ids.z & 0xffffu, BASE_COLOUR_UNIT);
    m.baseColour = colour * vec4(base.rgb * base.rgb, base.a);
    uint flags = ids.y >> 8;
    vec3 n = normalize(normal);
#ifdef NORMAL_MAP
    vec3 detail = fetch(normalMaps, uvNormal, ids.z >> 16, NORMAL_UNIT).xyz * 2.0 - 1.0;
    detail = (ids.z >> 16) == 0xffffu ? vec3(0.0, 0.0, 1.0) : detail;
    vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
    t *= inversesqrt(max(dot(t, t), 1e-20));
    vec3 b = cross(n, t) * tangent.w;
    n = normalize(t * (detail.x * surface.w) + b * (detail.y * surface.w) + n * detail.z);
#endif
    m.normal = front || (flags & MATERIAL_KEEP_NORMAL) != 0u ? n : -n;
    m.roughness = surface.x;
    m.metallic = surface.y;
    m.occlusion = 1.0;
    m.emissive = vec3(0.0);
#ifdef SURFACE_MAPS
    vec4 roughMetal = fetch(surfaceMaps, uvSurfaceOcclusion.xy, ids.w & 0xffffu, SURFACE_UNIT);
    m.roughness *= roughMetal.g;
    m.metallic *= roughMetal.b;
    float occlusion = fetch(occlusionMaps, uvSurfaceOcclusion.zw, ids.w >> 16, OCCLUSION_UNIT).r;
    m.occlusion = 1.0 + (occlusion - 1.0) * emissive.w;
    vec3 glow = fetch(emissiveMaps, uvEmissive, emissiveLayer, EMISSIVE_UNIT).rgb;
    m.emissive = emissive.rgb * glow * glow;
#endif
    m.roughness = clamp(m.roughness, 0.045, 1.0);
    return m;
}
