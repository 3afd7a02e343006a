// One buffer of the frame in place of the finished picture.
#include "gbuffer_in.glsl"
#include "lighting.glsl"
#ifdef OCCLUSION
#include "occlusion.glsl"
#endif
#include "shared/tone_map.h"

layout(binding = GBUFFER_ID_UNIT) uniform usampler2D gbufferId;
layout(binding = IMAGE_UNIT) uniform sampler2D image;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 ray;
layout(location = 0) out vec4 colour;

vec3 idColour(uint id)
{
    uint h = id * 0x9e3779b1u;
    h ^= h >> 15;
    h *= 0x85ebca77u;
    h ^= h >> 13;
    return vec3(h & 0xffu, (h >> 8) & 0xffu, (h >> 16) & 0xffu) / 255.0 * 0.8 + 0.2;
}

vec3 heat(float x) // black, blue, green, yellow, red, white
{
    x = clamp(x, 0.0, 1.0) * 5.0;
    vec3 steps[6] = vec3[6](vec3(0.0), vec3(0.1, 0.2, 0.9), vec3(0.1, 0.8, 0.3), vec3(1.0, 0.9, 0.1), vec3(1.0, 0.2, 0.1), vec3(1.0));
    int i = min(int(x), 4);
    return mix(steps[i], steps[i + 1], x - float(i));
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 base = texelFetch(gbufferColour, pixel, 0);
    vec4 stored = texelFetch(gbufferSurface, pixel, 0);
    vec3 normal = fromOctahedral(texelFetch(gbufferNormal, pixel, 0).xy);
    uint id = texelFetch(gbufferId, pixel, 0).r;
    float depth = texelFetch(gbufferDepth, pixel, 0).r;
    vec4 lit = texelFetch(image, pixel, 0);
    bool sky = depth <= 0.0;
    float distance_ = view.near / max(depth, 1e-9);
    vec3 relative = ray * distance_;

    vec3 shown = vec3(0.0);
#if MODE == 1 // albedo
    shown = sky ? vec3(0.0) : encodeSrgb(decodeColour(base.rgb));
#elif MODE == 2 // normal
    shown = sky ? vec3(0.0) : normal * 0.5 + 0.5;
#elif MODE == 3 // roughness
    shown = sky ? vec3(0.0) : vec3(stored.x);
#elif MODE == 4 // depth: logarithmic, white at the near plane, black at 20 km
    shown = sky ? vec3(0.0) : vec3(1.0 - clamp(log2(distance_ / view.near) / log2(20000.0 / view.near), 0.0, 1.0));
#elif MODE == 5 // position: metres of the world, one repeat each 16 m
    shown = sky ? vec3(0.0) : fract(relative / 16.0 + fract(view.eyeHigh / 16.0) + view.eyeLow / 16.0);
#elif MODE == 6 // id
    shown = id == 0u ? vec3(0.0) : id == 0xffffffffu ? vec3(0.25) : idColour(id);
#elif MODE == 7 // ao
#ifdef OCCLUSION
    base.a *= sky ? 1.0 : occlusionAt(pixel, depth);
#endif
    shown = sky ? vec3(1.0) : vec3(base.a);
#elif MODE == 8 // shadow
    shown = sky ? vec3(1.0) : vec3(sunVisibility(relative, normal, gl_FragCoord.xy));
#elif MODE == 9 // cascade
    vec3 tints[4] = vec3[4](vec3(1.0, 0.35, 0.3), vec3(0.4, 1.0, 0.35), vec3(0.35, 0.5, 1.0), vec3(1.0, 0.9, 0.3));
    float viewDepth = dot(relative, view.forward);
    vec3 grey = vec3(luminance(encodeSrgb(toneMap(TONE_AGX, lit.rgb * view.exposure))));
    bool beyond = sky || viewDepth > light.cascadeEnd[light.cascades - 1];
    shown = beyond ? grey : grey * tints[cascadeAt(viewDepth, 0.0)];
#elif MODE == 10 // luminance: heat over 16 stops around middle grey
    shown = heat((log2(max(luminance(lit.rgb) * view.exposure, 1e-9) / 0.18) + 8.0) / 16.0);
#elif MODE == 11 // backdrop of wireframe, lod and nodes
    shown = encodeSrgb(toneMap(TONE_AGX, lit.rgb * view.exposure)) * 0.45;
#elif MODE == 13 // overdraw: surfaces a pixel, white from 20
    shown = heat(lit.r / 20.0);
#endif
    colour = vec4(shown, 1.0);
}
