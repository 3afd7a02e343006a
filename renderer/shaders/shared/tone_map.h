// Scene-linear colour, already exposed, to display-linear colour in [0, 1].
#ifndef SHARED_TONE_MAP_H
#define SHARED_TONE_MAP_H
#include "shared.h"

#define TONE_AGX 0
#define TONE_NEUTRAL 1
#define TONE_ACES 2
#define TONE_REINHARD 3

SHARED_BEGIN

SHARED_FUNCTION float luminance(vec3 c)
{
    return dot(c, vec3(0.2126f, 0.7152f, 0.0722f));
}

SHARED_FUNCTION float agxCurve(float x)
{
    // Sobotka's AgX sigmoid: slope 2 at middle grey, powers 3 (toe) and 3.25 (shoulder), as one smooth
    // polynomial (Wrensch, "Minimal AgX Implementation", 2023).
    float x2 = x * x;
    float x4 = x2 * x2;
    return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 + 0.1191f * x - 0.00232f;
}

// For a display with a gamma of 2.2.
SHARED_FUNCTION vec3 agxForGamma22(vec3 c)
{
    // Columns.
    const mat3 inset = mat3(0.842479062253094f, 0.0423282422610123f, 0.0423756549057051f, 0.0784335999999992f,
                            0.878468636469772f, 0.0784336f, 0.0792237451477643f, 0.0791661274605434f, 0.879142973793104f);
    const mat3 outset = mat3(1.19687900512017f, -0.0528968517574562f, -0.0529716355144438f, -0.0980208811401368f,
                             1.15190312990417f, -0.0980434501171241f, -0.0990297440797205f, -0.0989611768448433f,
                             1.15107367264116f);
    const float darkest = -12.47393f; // log2: ten stops under middle grey, and six and a half above it
    const float brightest = 4.026069f;
    vec3 v = inset * max(c, vec3(0.0f));
    v = clamp((log2(max(v, vec3(1e-10f))) - darkest) / (brightest - darkest), vec3(0.0f), vec3(1.0f));
    v = vec3(agxCurve(v.x), agxCurve(v.y), agxCurve(v.z));
    // "Punchy" look, eased: the plain curve is made for grading afterwards.
    float grey = luminance(v);
    v = pow(max(v, vec3(0.0f)), vec3(1.18f));
    v = max(vec3(grey) + (v - vec3(grey)) * 1.38f, vec3(0.0f));
    return clamp(outset * v, vec3(0.0f), vec3(1.0f));
}

SHARED_FUNCTION vec3 toneMapAgx(vec3 c)
{
    return pow(agxForGamma22(c), vec3(2.2f));
}

// Khronos PBR Neutral (2024).
SHARED_FUNCTION vec3 toneMapNeutral(vec3 c)
{
    const float start = 0.8f - 0.04f;
    float lowest = min(c.x, min(c.y, c.z));
    float offset = lowest < 0.08f ? lowest - 6.25f * lowest * lowest : 0.04f;
    vec3 v = c - vec3(offset);
    float peak = max(v.x, max(v.y, v.z));
    if (peak < start) return v;
    float d = 1.0f - start;
    float newPeak = 1.0f - d * d / (peak + d - start);
    v = v * (newPeak / peak);
    float g = 1.0f - 1.0f / (0.15f * (peak - newPeak) + 1.0f);
    return v + (vec3(newPeak) - v) * g;
}

// Hill's fit of the ACES reference and output transforms.
SHARED_FUNCTION vec3 toneMapAces(vec3 c)
{
    const mat3 input_ = mat3(0.59719f, 0.07600f, 0.02840f, 0.35458f, 0.90834f, 0.13383f, 0.04823f, 0.01566f, 0.83777f);
    const mat3 output_ = mat3(1.60475f, -0.10208f, -0.00327f, -0.53108f, 1.10813f, -0.07276f, -0.07367f, -0.00605f,
                              1.07602f);
    vec3 v = input_ * c;
    vec3 a = v * (v + 0.0245786f) - 0.000090537f;
    vec3 b = v * (0.983729f * v + 0.4329510f) + 0.238081f;
    return clamp(output_ * (a / b), vec3(0.0f), vec3(1.0f));
}

// Of luminance, so that hues stay; white at 4.
SHARED_FUNCTION vec3 toneMapReinhard(vec3 c)
{
    float l = luminance(c);
    float mapped = l * (1.0f + l / 16.0f) / (1.0f + l);
    return clamp(c * (mapped / max(l, 1e-6f)), vec3(0.0f), vec3(1.0f));
}

SHARED_FUNCTION vec3 toneMap(int curve, vec3 c)
{
    if (curve == TONE_NEUTRAL) return clamp(toneMapNeutral(c), vec3(0.0f), vec3(1.0f));
    if (curve == TONE_ACES) return toneMapAces(c);
    if (curve == TONE_REINHARD) return toneMapReinhard(c);
    return toneMapAgx(c);
}

SHARED_FUNCTION vec3 encodeSrgb(vec3 c)
{
    vec3 low = c * 12.92f;
    vec3 high = pow(max(c, vec3(1e-5f)), vec3(1.0f / 2.4f)) * 1.055f - vec3(0.055f);
    return vec3(c.x <= 0.0031308f ? low.x : high.x, c.y <= 0.0031308f ? low.y : high.y,
                c.z <= 0.0031308f ? low.z : high.z);
}

// encodeSrgb(toneMap(c)); in two steps fewer where the curve ends in a power of its own.
SHARED_FUNCTION vec3 toneMapToSrgb(int curve, vec3 c)
{
    if (curve != TONE_AGX) return encodeSrgb(toneMap(curve, c));
    vec3 v = agxForGamma22(c);
    vec3 low = v * v * (12.92f * 0.5918f); // for v to the power of 2.2: within a third of 1 / 255 down there
    vec3 high = pow(max(v, vec3(1e-3f)), vec3(2.2f / 2.4f)) * 1.055f - vec3(0.055f);
    const float knee = 0.0726f; // 0.0031308 to the power of 1 / 2.2
    return vec3(v.x <= knee ? low.x : high.x, v.y <= knee ? low.y : high.y, v.z <= knee ? low.z : high.z);
}

SHARED_FUNCTION vec3 decodeSrgb(vec3 c)
{
    vec3 high = pow((c + vec3(0.055f)) / 1.055f, vec3(2.4f));
    return vec3(c.x <= 0.04045f ? c.x / 12.92f : high.x, c.y <= 0.04045f ? c.y / 12.92f : high.y,
                c.z <= 0.04045f ? c.z / 12.92f : high.z);
}

SHARED_END
#endif
