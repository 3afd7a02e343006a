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

vec3 tintAt(float away) // of the cascades whose shadows are seen there
{
    int cascade = cascadeAt(away);
    float next = shareOfNext(away, cascade);
    vec3 tint = mix(cascadeTint(cascade), cascadeTint(cascade + 1), next);
    bool beyond = shadows.cascades == 0 || away > shadows.fadeFrom + 1.0 / shadows.fadeScale;
    return beyond ? vec3(1.0) : tint;
}

#if MODE == 15 && defined(SHADOWS)
layout(binding = SHADOW_DEPTH_UNIT) uniform sampler2DArray mapDepths;

const float kGap = 4.0, kFrame = 2.0; // pixels

// A map as its window lies in the light's plane: brighter towards the light, with relief as if lit from the upper left, for
// most of a landscape lies within little of the depth.
vec3 shadowMapTexel(int cascade, vec2 at, float pixel)
{
    ShadowCascade c = shadows.cascade[cascade];
    float texels = shadows.resolution;
    float depth = texture(mapDepths, vec3(c.low + at, float(cascade))).r;
    if (depth >= 1.0) return vec3(0.03, 0.04, 0.07); // nothing there
    float left = texture(mapDepths, vec3(c.low + at - vec2(pixel, 0.0), float(cascade))).r;
    float above = texture(mapDepths, vec3(c.low + at + vec2(0.0, pixel), float(cascade))).r;
    float toWidth = c.depthRange / (c.texel * texels);
    vec2 slope = (vec2(left, above) - depth) * (toWidth / pixel);
    float relief = (slope.x + slope.y) / sqrt(1.0 + dot(slope, slope));
    return vec3(clamp(0.2 + 0.15 * (1.0 - depth) * min(toWidth, 3.0) + 0.25 * relief, 0.06, 1.0));
}

// All maps in rows, as large as fits, each framed in its cascade's colour.
vec3 shadowMapAt(vec2 pixel, vec2 picture)
{
    int columns = 1;
    float side = 0.0;
    for (int tried = 1; tried <= shadows.cascades; ++tried) {
        int rows = (shadows.cascades + tried - 1) / tried;
        float fits = floor(min(picture.x / float(tried), picture.y / float(rows)));
        columns = fits > side ? tried : columns;
        side = max(side, fits);
    }
    int rows = (shadows.cascades + columns - 1) / columns;
    vec2 corner = floor((picture - side * vec2(columns, rows)) * 0.5);
    ivec2 tile = ivec2(floor((pixel - corner) / side));
    int cascade = (rows - 1 - tile.y) * columns + tile.x; // from the top left
    if (any(lessThan(tile, ivec2(0))) || tile.x >= columns || tile.y >= rows || cascade >= shadows.cascades) return vec3(0.0);
    vec2 inside = pixel - corner - vec2(tile) * side - kGap;
    float across = side - 2.0 * kGap;
    vec2 toEdge = min(inside, across - inside);
    float edge = min(toEdge.x, toEdge.y);
    if (edge < 0.0) return vec3(0.0);
    return edge < kFrame ? cascadeTint(cascade) : shadowMapTexel(cascade, inside / across, 1.0 / across);
}
#endif

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
    shown = sky ? vec3(1.0) : vec3(sunVisibility(relative, normal));
#elif MODE == 9 || MODE == 16 // cascade; backdrop of their boxes
    vec3 grey = vec3(luminance(encodeSrgb(toneMap(TONE_AGX, lit.rgb * view.exposure))));
    shown = sky ? grey : grey * tintAt(length(relative));
    shown *= MODE == 16 ? 0.45 : 1.0;
#elif MODE == 10 // luminance: heat over 16 stops around middle grey
    shown = heat((log2(max(luminance(lit.rgb) * view.exposure, 1e-9) / 0.18) + 8.0) / 16.0);
#elif MODE == 11 // backdrop of wireframe, lod and nodes
    shown = encodeSrgb(toneMap(TONE_AGX, lit.rgb * view.exposure)) * 0.45;
#elif MODE == 13 // overdraw: surfaces a pixel, white from 20
    shown = heat(lit.r / 20.0);
#endif
#if MODE == 15 && defined(SHADOWS)
    shown = shadowMapAt(gl_FragCoord.xy, vec2(textureSize(gbufferDepth, 0)));
#endif
    colour = vec4(shown, 1.0);
}
