// Impostors into the GBuffer, to be lit like what they stand for: three frames around the direction they are seen from,
// each moved by the depth it shows there.
#include "fade.glsl"
#include "gbuffer_out.glsl"
#include "impostor.glsl"
#include "shared/bindings.h"
#include "shared/instance.h"

layout(binding = BASE_COLOUR_UNIT) uniform sampler2DArray colours;
layout(binding = NORMAL_UNIT) uniform sampler2DArray surfaces;
layout(location = 0) in vec4 places01;
layout(location = 1) in vec2 place2;
layout(location = 2) flat in vec4 frames01;
layout(location = 3) flat in vec4 frame2;
layout(location = 4) flat in vec4 shifts01;
layout(location = 5) flat in vec2 shift2;
layout(location = 6) flat in vec3 weights;
layout(location = 7) flat in vec3 normalX;
layout(location = 8) flat in vec3 normalY;
layout(location = 9) flat in vec3 normalZ;
layout(location = 10) flat in uvec2 ids;
layout(location = 11) flat in vec4 misc;

const float kEdge = 1.0 / float(IMPOSTOR_FRAME_TEXELS);
const float kSpread = 0.3; // of the covers that pass: 0 keeps those above a half, 1 keeps the mean and is all grain

vec4 colour = vec4(0.0);
vec4 surface = vec4(0.0);

void add(vec2 place, vec2 frame, vec2 shift, float weight)
{
    place = clamp(place, kEdge, 1.0 - kEdge);
    int mip = min(int(frame2.w) + 2, IMPOSTOR_MIPS - 1); // depth around, also where nothing is
    vec2 texels = vec2((IMPOSTOR_FRAME_TEXELS * IMPOSTOR_FRAMES) >> mip);
    vec4 there = texelFetch(surfaces, ivec3((frame + place) * (texels / float(IMPOSTOR_FRAMES)), frame2.z), mip);
    place = clamp(place + shift * storedDepth(there), kEdge, 1.0 - kEdge);
    vec3 at = vec3((frame + place) / float(IMPOSTOR_FRAMES), frame2.z);
    colour += textureLod(colours, at, frame2.w) * weight;
    surface += textureLod(surfaces, at, frame2.w) * weight;
}

// Grain that moves along with what it is on.
float grain(vec2 pixel)
{
    uvec2 p = uvec2(ivec2(pixel) - ivec2(misc.zw));
    uint h = p.x * 0x9e3779b1u ^ p.y * 0x85ebca77u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    return float(h >> 8 & 0xffffu) / 65536.0;
}

void main()
{
#ifdef FADE
    if (fadedAway(gl_FragCoord.xy)) discard;
#endif
    add(places01.xy, frames01.xy, shifts01.xy, weights.x);
    add(places01.zw, frames01.zw, shifts01.zw, weights.y);
    add(place2, frame2.xy, shift2, weights.z);
    if (colour.a < 0.5 + (grain(gl_FragCoord.xy) - 0.5) * kSpread) discard;

    ImpostorTexel t = loaded(colour, surface);
    vec3 normal = normalize(normalX * t.normal.x + normalY * t.normal.y + normalZ * t.normal.z);
    uint bits = (ids.y & INSTANCE_SELECTED) != 0u ? SURFACE_SELECTED : 0u;
    bits |= t.leaf > 0.5 ? SURFACE_LEAF : 0u;
    writeSurface(t.light, 1.0, normal, mix(misc.y, misc.x, t.leaf), 0.0, bits, 0.0);
    outId = ids.x;
}
