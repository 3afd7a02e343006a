// How a surface answers sun and sky.
#include "cloud_shadow.glsl"
#include "light.glsl"
#include "sky_light.glsl"
#include "shared/brdf.h"
#include "shared/gbuffer.h"
#include "view.glsl"

layout(binding = SHADOW_UNIT) uniform sampler2DArrayShadow shadowMaps;
layout(binding = GROUND_SHADOW_UNIT) uniform sampler2D groundShadow;

struct Surface {
    vec3 baseColour;
    vec3 normal;
    float roughness;
    float metallic;
    float occlusion;
    uint bits;
};

// The cascade that covers a distance; in the last tenth of each, noise leads some pixels to the next.
int cascadeAt(float viewDepth, float noise)
{
    int cascade = 0;
    float begin = 0.0;
    for (int i = 0; i < MAX_CASCADES - 1; ++i) {
        float end = light.cascadeEnd[i];
        float border = end - (end - begin) * 0.1 * noise;
        cascade += i < light.cascades - 1 && viewDepth > border ? 1 : 0;
        begin = end;
    }
    return cascade;
}

// Four bilinear taps that weigh 3 x 3 texels as a tent does (Castano, "Shadow Mapping Summary", 2013); softness
// pulls them apart. Nine taps and 5 x 5 texels where it is large.
float filteredShadow(vec3 place, int cascade)
{
    float size = 1.0 / light.shadowTexel;
    vec2 at = place.xy * size;
    vec2 base = floor(at + 0.5);
    vec2 s = at + 0.5 - base;
    base -= 0.5;
    vec2 own = at - base;
#ifdef WIDE_SHADOWS
    vec3 wx = vec3(4.0 - 3.0 * s.x, 7.0, 1.0 + 3.0 * s.x);
    vec3 wy = vec3(4.0 - 3.0 * s.y, 7.0, 1.0 + 3.0 * s.y);
    vec3 ux = vec3((3.0 - 2.0 * s.x) / wx.x - 2.0, (3.0 + s.x) / wx.y, s.x / wx.z + 2.0);
    vec3 uy = vec3((3.0 - 2.0 * s.y) / wy.x - 2.0, (3.0 + s.y) / wy.y, s.y / wy.z + 2.0);
    float sum = 0.0;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            vec2 offset = (vec2(ux[x], uy[y]) - own) * (light.shadowSoftness * 0.6);
            sum += wx[x] * wy[y] * texture(shadowMaps, vec4((at + offset) * light.shadowTexel, float(cascade), place.z));
        }
    return sum / 144.0;
#else
    vec2 wx = vec2(3.0 - 2.0 * s.x, 1.0 + 2.0 * s.x);
    vec2 wy = vec2(3.0 - 2.0 * s.y, 1.0 + 2.0 * s.y);
    vec2 ux = vec2((2.0 - s.x) / wx.x - 1.0, s.x / wx.y + 1.0);
    vec2 uy = vec2((2.0 - s.y) / wy.x - 1.0, s.y / wy.y + 1.0);
    float sum = 0.0;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            vec2 offset = (vec2(ux[x], uy[y]) - own) * light.shadowSoftness;
            sum += wx[x] * wy[y] * texture(shadowMaps, vec4((at + offset) * light.shadowTexel, float(cascade), place.z));
        }
    return sum / 16.0;
#endif
}

// Beyond the shadow maps: whether a mountain stands before the sun.
float sunOverGround(vec3 relative)
{
    vec2 place = relative.xz * light.groundShadow.xy + light.groundShadow.zw;
    float shadow = textureLod(groundShadow, place, 0.0).r - view.eyeHeight;
    float soft = 1.5 + length(relative) * 0.004;
    return smoothstep(-soft, soft, relative.y - shadow + soft);
}

// Share of the sun that reaches a place.
float sunVisibility(vec3 relative, vec3 normal, vec2 pixel)
{
#ifdef SHADOWS
    float viewDepth = dot(relative, view.forward);
    int cascade = cascadeAt(viewDepth, interleavedNoise(pixel));
    float cosine = clamp(dot(normal, light.towardSun), 0.0, 1.0);
    float lift = light.cascadeTexel[cascade] * (light.shadowBias * sqrt(1.0 - cosine * cosine) + 0.35 * light.shadowBias);
    vec3 place = (light.shadowFromRelative[cascade] * vec4(relative + normal * lift, 1.0)).xyz;
    float lit = filteredShadow(place, cascade);
    float beyond = light.cascadeEnd[light.cascades - 1];
    return mix(lit, sunOverGround(relative), smoothstep(beyond * 0.92, beyond, viewDepth));
#else
    return 1.0;
#endif
}

vec3 shade(Surface s, vec3 toEye, float sun)
{
    vec3 l = light.towardSun;
    float nol = dot(s.normal, l);
    float nov = clamp(dot(s.normal, toEye), 0.02, 1.0);
    vec3 h = normalize(l + toEye);
    float noh = clamp(dot(s.normal, h), 0.0, 1.0);
    float alpha = s.roughness * s.roughness;
    bool leaf = (s.bits & SURFACE_LEAF) != 0u;

    vec3 f0 = mix(vec3(0.04), s.baseColour, s.metallic);
    vec3 f = fresnel(f0, clamp(dot(h, l), 0.0, 1.0));
    float front = clamp(nol, 0.0, 1.0);
#ifdef BLINN_PHONG
    vec3 specular = f * blinnPhong(alpha, noh) * front;
#else
    vec3 specular = f * min(distributionGgx(alpha, noh) * visibilitySmith(alpha, front, nov), 64.0) * front;
#endif
    vec3 diffuseColour = s.baseColour * (1.0 - s.metallic);
    vec3 diffuse = diffuseColour * (vec3(1.0) - f) * (front / 3.14159265);

    // A leaf scatters light around its edge and lets a yellower part through.
    float wrapped = clamp((nol + 0.3) / 1.69, 0.0, 1.0);
    float through = clamp(-nol * 0.7 + 0.3, 0.0, 1.0) * (0.55 + 0.45 * pow(clamp(-dot(l, toEye), 0.0, 1.0), 4.0));
    vec3 leafLight = diffuseColour * (wrapped + through * 0.55 * vec3(1.12, 1.1, 0.55)) / 3.14159265;
    diffuse = leaf ? leafLight : diffuse;
    specular = leaf ? specular * 0.35 : specular;

    vec3 ambientNormal = leaf ? normalize(s.normal + vec3(0.0, 0.6, 0.0)) : s.normal;
    vec3 mirrored = reflect(-toEye, s.normal);
    vec3 sky = diffuseColour * skyIrradiance(ambientNormal);
    sky += skyIrradiance(mix(mirrored, s.normal, s.roughness)) * environmentBrdf(f0, s.roughness, nov) * (leaf ? 0.3 : 1.0);
    return (diffuse + specular) * light.sunIrradiance * sun + sky * light.ambient * s.occlusion;
}

const vec3 kViolet = vec3(0.36, 0.08, 0.85); // linear; what is selected leans towards it

vec3 tintSelected(vec3 radiance)
{
    float brightness = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
    return mix(radiance, kViolet * (brightness * 2.2 + 0.02 / view.exposure), 0.45);
}
