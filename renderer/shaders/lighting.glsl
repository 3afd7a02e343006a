// How a surface answers sun and sky.
#include "cloud_shadow.glsl"
#include "light.glsl"
#include "shadows.glsl"
#include "sky_light.glsl"
#include "sky_mirror.glsl"
#include "sun_at.glsl"
#include "shared/brdf.h"
#include "shared/gbuffer.h"
#include "view.glsl"

struct Surface {
    vec3 baseColour;
    vec3 normal;
    float roughness;
    float metallic;
    float occlusion;
    uint bits;
};

// Radiance for each unit of irradiance from towards `l`. A leaf scatters light around its edge and lets a yellower part
// through. `most` as lobeOf() has it.
vec3 surfaceLight(Surface s, Reflector r, vec3 toEye, vec3 l, float most)
{
    float nol = dot(s.normal, l);
    float front = clamp(nol, 0.0, 1.0);
    vec3 h = normalize(l + toEye);
    vec3 lobe = lobeOf(r, front, clamp(dot(s.normal, h), 0.0, 1.0), clamp(dot(h, l), 0.0, 1.0), most);

    float wrapped = clamp((nol + 0.3) / 1.69, 0.0, 1.0);
    float through = clamp(-nol * 0.7 + 0.3, 0.0, 1.0) * (0.55 + 0.45 * pow(clamp(-dot(l, toEye), 0.0, 1.0), 4.0));
    bool leaf = (s.bits & SURFACE_LEAF) != 0u;
    vec3 spread = leaf ? wrapped + through * 0.55 * vec3(1.12, 1.1, 0.55) : vec3(front);
    return r.diffuse * spread / 3.14159265 + lobe * (leaf ? 0.35 : 1.0);
}

Reflector reflectorAt(Surface s, vec3 toEye)
{
    return reflectorOf(s.baseColour, s.metallic, s.roughness, clamp(dot(s.normal, toEye), 0.02, 1.0));
}

// What hides the sky is lit too, and the brighter the surface, the more: the fit of Jimenez et al., "Practical Realtime
// Strategies for Accurate Indirect Occlusion" (2016).
vec3 skySeen(float seen, vec3 colour)
{
    vec3 bounced = ((seen * (2.0404 * colour - 0.3324) + (0.6417 - 4.7951 * colour)) * seen + (2.7552 * colour + 0.6903)) * seen;
    return max(vec3(seen), bounced);
}

// Share of the sky that a lobe sees: Lagarde and de Rousiers, "Moving Frostbite to Physically Based Rendering" (2014).
float lobeSeen(float seen, float nov, float roughness)
{
    return clamp(pow(nov + seen, exp2(-16.0 * roughness - 1.0)) - 1.0 + seen, 0.0, 1.0);
}

// `sun` is the irradiance that comes to the place, across to it.
vec3 shade(Surface s, Reflector r, vec3 toEye, vec3 sun)
{
    bool leaf = (s.bits & SURFACE_LEAF) != 0u;
    vec3 ambientNormal = leaf ? normalize(s.normal + vec3(0.0, 0.6, 0.0)) : s.normal;
    vec3 mirrored = reflect(-toEye, s.normal);
    vec3 sky = r.diffuse * skyIrradiance(ambientNormal) * skySeen(s.occlusion, r.diffuse);
    sky += skyMirrored(mirrored, s.normal, s.roughness) * r.mirrored *
           (lobeSeen(s.occlusion, r.nov, s.roughness) * (leaf ? 0.3 : 1.0));
    return surfaceLight(s, r, toEye, light.towardSun, 1.0 / light.sunSolidAngle) * sun + sky * light.ambient;
}

const vec3 kViolet = vec3(0.36, 0.08, 0.85); // linear; what is selected leans towards it

vec3 tintSelected(vec3 radiance)
{
    float brightness = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
    return mix(radiance, kViolet * (brightness * 2.2 + 0.02 / view.exposure), 0.45);
}
