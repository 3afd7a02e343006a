// How a surface answers sun and sky.
#include "light.glsl"
#include "shadows.glsl"
#include "sky_light.glsl"
#include "shared/brdf.h"
#include "shared/gbuffer.h"
#include "view.glsl"

layout(binding = CLOUD_MAP_UNIT) uniform sampler2D cloudMap;

struct Surface {
    vec3 baseColour;
    vec3 normal;
    float roughness;
    float metallic;
    float occlusion;
    uint bits;
};

// Share of the sun that reaches a place under the clouds.
float cloudShadow(vec3 relative)
{
    vec2 shift = light.towardSun.xz * (relative.y / max(light.towardSun.y, 0.12));
    float through = textureLod(cloudMap, (relative.xz - shift) * (1.0 / CLOUD_MAP_METRES) + light.cloudMap.zw, 0.0).r;
    return relative.y < light.cloudAltitude ? through : 1.0;
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
