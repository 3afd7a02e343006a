// Reflection of a surface: metallic-roughness with GGX (Walter 2007), height-correlated Smith (Heitz 2014) and
// Schlick's Fresnel, or a Blinn-Phong lobe of equal width.
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

// Share of the sky's light that is reflected, after Karis, "Physically Based Shading on Mobile" (2014).
SHARED_FUNCTION vec3 environmentBrdf(vec3 f0, float roughness, float nov)
{
    vec4 r = roughness * vec4(-1.0f, -0.0275f, -0.572f, 0.022f) + vec4(1.0f, 0.0425f, 1.04f, -0.04f);
    float a = min(r.x * r.x, exp2(-9.28f * nov)) * r.x + r.y;
    vec2 ab = vec2(-1.04f, 1.04f) * a + vec2(r.z, r.w);
    return f0 * ab.x + vec3(ab.y);
}

SHARED_END
#endif
