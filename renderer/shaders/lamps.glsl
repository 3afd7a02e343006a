// Light of lamps on a surface. Needs lighting.glsl before it.
#include "shared/lamps.h"

layout(std140, binding = LAMPS_BINDING) uniform LampsBlock { LampGrid lampGrid; };
layout(binding = LAMPS_UNIT) uniform samplerBuffer lampTexels;
layout(binding = LAMP_LISTS_UNIT) uniform usamplerBuffer lampLists; // of each cluster: first, count; then numbers of lamps
layout(binding = LAMP_SHADOW_UNIT) uniform sampler2DShadow lampShadows;

const float kGlass = LAMP_RADIUS * LAMP_RADIUS;

int lampCluster(vec3 relative, vec2 pixel)
{
    ivec2 tile = min(ivec2(pixel * view.texel * vec2(LAMP_TILES_X, LAMP_TILES_Y)), ivec2(LAMP_TILES_X - 1, LAMP_TILES_Y - 1));
    float depth = max(dot(relative, view.forward), view.near);
    int slice = clamp(int(log2(depth) * lampGrid.sliceScale + lampGrid.sliceBias), 0, LAMP_SLICES - 1);
    return (slice * LAMP_TILES_Y + tile.y) * LAMP_TILES_X + tile.x;
}

// Faces of a cube: +X, -X, +Y, -Y, +Z, -Z.
int cubeFace(vec3 d)
{
    vec3 a = abs(d);
    int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return axis * 2 + (d[axis] < 0.0 ? 1 : 0);
}

// Share of a lamp's light that comes through: four taps that weigh 3 x 3 texels as a tent does.
float lampShadow(int firstFace, int faces, float texelAngle, vec3 fromLamp, vec3 normal, float nol)
{
    float lift = texelAngle * length(fromLamp) * (0.6 + 1.4 * sqrt(1.0 - nol * nol));
    vec3 at = fromLamp + normal * lift;
    int texel = firstFace + LAMP_TEXELS * (faces > 1 ? cubeFace(at) : 0);
    mat4 atlas = mat4(texelFetch(lampTexels, texel), texelFetch(lampTexels, texel + 1), texelFetch(lampTexels, texel + 2),
                      texelFetch(lampTexels, texel + 3));
    vec4 clip = atlas * vec4(at, 1.0);
    vec3 place = clip.xyz / max(clip.w, 1e-6);
    vec2 texels = place.xy / lampGrid.shadowTexel;
    vec2 base = floor(texels + 0.5);
    vec2 s = texels + 0.5 - base;
    base -= 0.5;
    vec2 wx = vec2(3.0 - 2.0 * s.x, 1.0 + 2.0 * s.x);
    vec2 wy = vec2(3.0 - 2.0 * s.y, 1.0 + 2.0 * s.y);
    vec2 ux = vec2((2.0 - s.x) / wx.x - 1.0, s.x / wx.y + 1.0);
    vec2 uy = vec2((2.0 - s.y) / wy.x - 1.0, s.y / wy.y + 1.0);
    float sum = 0.0;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x)
            sum += wx[x] * wy[y] * textureLod(lampShadows, vec3((base + vec2(ux[x], uy[y])) * lampGrid.shadowTexel, place.z), 0.0);
    return sum / 16.0;
}

// What of a lamp reaches a place: its irradiance across the way, black where none does.
struct LampRay {
    vec3 light;
    vec3 toward;     // unit
    float distance2; // m2
};

// `normal` of the surface there, which its shadow goes by; 0 where there is none. `nearest`: what is so wide itself, m, has no place nearer.
LampRay lampRay(int number, vec3 relative, vec3 normal, float nearest)
{
    int texel = number * LAMP_TEXELS;
    vec4 place = texelFetch(lampTexels, texel);
    LampRay ray = LampRay(vec3(0.0), vec3(0.0, 1.0, 0.0), 1.0);
    vec3 to = place.xyz - relative;
    ray.distance2 = dot(to, to);
    if (ray.distance2 >= place.w * place.w) return ray;
    ray.toward = to * inversesqrt(max(ray.distance2, 1e-8));
    vec4 colour = texelFetch(lampTexels, texel + 1);
    vec4 axis = texelFetch(lampTexels, texel + 2);
    float strength = lampFalloff(max(ray.distance2, nearest * nearest), place.w) * lampCone(-dot(axis.xyz, ray.toward), colour.w, axis.w);
    if (strength <= 0.0) return ray;
    vec4 faces = texelFetch(lampTexels, texel + 3);
    if (faces.y > 0.0) {
        vec3 n = normal == vec3(0.0) ? ray.toward : normal;
        strength *= lampShadow(int(faces.x), int(faces.y), faces.z, -to, n, clamp(dot(n, ray.toward), 0.0, 1.0));
    }
    ray.light = colour.rgb * strength;
    return ray;
}

vec3 lampLight(Surface s, Reflector r, vec3 relative, vec3 toEye, vec2 pixel)
{
    int cluster = lampCluster(relative, pixel);
    int first = int(texelFetch(lampLists, 2 * cluster).r);
    int count = int(texelFetch(lampLists, 2 * cluster + 1).r);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) {
        LampRay ray = lampRay(int(texelFetch(lampLists, first + i).r), relative, s.normal, 0.0);
        if (ray.light == vec3(0.0)) continue;
        sum += ray.light * surfaceLight(s, r, toEye, ray.toward, max(ray.distance2, kGlass) / (3.14159265 * kGlass));
    }
    return sum;
}

// Irradiance that reaches a puff of that radius from all lamps around it.
vec3 lampsAround(vec3 relative, vec2 pixel, float radius)
{
    int cluster = lampCluster(relative, pixel);
    int first = int(texelFetch(lampLists, 2 * cluster).r);
    int count = int(texelFetch(lampLists, 2 * cluster + 1).r);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i)
        sum += lampRay(int(texelFetch(lampLists, first + i).r), relative, vec3(0.0), radius).light;
    return sum;
}
