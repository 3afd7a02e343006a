// Reflection of a surface: metallic-roughness with GGX (Walter 2007), height-correlated Smith (Heitz 2014) and
// Schlick's Fresnel, or a Blinn-Phong lobe of equal width; over a Lambert base that gets what the lobe leaves.
#ifndef SHARED_BRDF_H
#define SHARED_BRDF_H
#include "shared.h"
SHARED_BEGIN

SHARED_FUNCTION vec3 fresnel(vec3 f0, float cosine)
{
    float c = clamp(1.0f - cosine, 0.0f, 1.0f);
    float c2 = c * c;
    return f0 + (vec3(1.0f) - f0) * (c2 * c2 * c);
}

SHARED_FUNCTION float distributionGgx(float alpha, float noh)
{
    float a2 = alpha * alpha;
    float d = noh * noh * (a2 - 1.0f) + 1.0f;
    return a2 / (3.14159265f * d * d);
}

// G / (4 nol nov)
SHARED_FUNCTION float visibilitySmith(float alpha, float nol, float nov)
{
    float a2 = alpha * alpha;
    float l = nov * sqrt(nol * nol * (1.0f - a2) + a2);
    float v = nol * sqrt(nov * nov * (1.0f - a2) + a2);
    return 0.5f / max(l + v, 1e-5f);
}

// The normalised lobe (n + 8) / (8 pi) with n = 2 / alpha^2 - 2, so that the roughness slider means the same.
SHARED_FUNCTION float blinnPhong(float alpha, float noh)
{
    float n = 2.0f / (alpha * alpha) - 2.0f;
    return (n + 8.0f) / (8.0f * 3.14159265f) * pow(max(noh, 1e-4f), n);
}

// What a surface does with light, as one eye sees it.
struct Reflector {
    vec3 diffuse;  float alpha; // base colour of the Lambert part; roughness squared
    vec3 f0;       float nov;   // reflection at right angles; cosine of the eye
    vec3 mirrored; // share of an even light from all around that the lobe reflects, with later bounces
    vec3 gain;     // factor on the lobe for light that bounces more than once on its facets
};

// The lobe's two integrals over the hemisphere, of f0 = 1 and of the Fresnel term's power alone ("split sum"), as fits to
// 600 x 600 samples: the first within 0.05 for a roughness of 0.3 and more, the second never below what it is and at most
// 0.09 above, so that a white surface reflects between 0.91 and 1.001 of a white sky. What the facets hand on to each other
// comes back as in Turquin, "Practical multiple scattering compensation for microfacet models" (2019); the Lambert part
// gets what is left.
SHARED_FUNCTION Reflector reflectorOf(vec3 baseColour, float metallic, float roughness, float nov)
{
    float x = sqrt(nov);
    float r2 = roughness * roughness;
    float lost = r2 * (1.925f + 0.130f * x - 3.253f * nov + roughness * (-5.110f + 4.787f * x + 4.578f * nov) +
                       r2 * (3.115f - 3.774f * x - 1.702f * nov));
    float whole = 1.0f - clamp(lost, 0.0f, 0.75f);
    float power = 5.302f + roughness * (10.593f * roughness - 10.858f);
    float spread = 1.0f + roughness * (-0.171f + roughness * (8.423f + roughness * (22.920f - 9.125f * roughness)));
    float edge = min(exp2(power * log2(max(1.0f - nov, 1e-4f))) / spread + 0.004f, whole);

    Reflector r;
    r.alpha = r2;
    r.nov = nov;
    r.f0 = vec3(0.04f) + (baseColour - vec3(0.04f)) * metallic;
    r.gain = vec3(1.0f) + r.f0 * (1.0f / whole - 1.0f);
    r.mirrored = (vec3(edge) + r.f0 * (whole - edge)) * r.gain;
    r.diffuse = baseColour * (1.0f - metallic) * (vec3(1.0f) - r.mirrored);
    return r;
}

// Radiance of the lobe towards the eye for each unit of irradiance at right angles to the light. `most`: a lamp's image
// can be no brighter than the lamp, which is 1 / its solid angle.
SHARED_FUNCTION vec3 lobeOf(Reflector r, float nol, float noh, float loh, float most)
{
#ifdef BLINN_PHONG
    float lobe = blinnPhong(r.alpha, noh) * nol;
#else
    float lobe = distributionGgx(r.alpha, noh) * visibilitySmith(r.alpha, nol, r.nov) * nol;
#endif
    return fresnel(r.f0, loh) * r.gain * min(lobe, most);
}

SHARED_END
#endif
