// Clouds of one frame and what falls from them, and the arithmetic of their light. Both kinds of clouds, the flat layer and the volumes, stand where the
// same field of noise is above an edge, so that a world looks alike on every tier.
#ifndef SHARED_CLOUDS_H
#define SHARED_CLOUDS_H
#include "shared.h"
SHARED_BEGIN

#define CLOUD_MAP_SIZE 256       // texels
#define CLOUD_MAP_METRES 16000.0f
#define CLOUD_SHAPE_SIZE 128     // texels along x and y of the shape's noise, one repeat
#define CLOUD_SHAPE_DEPTH 32     // texels along z: a quarter of a repeat's width, so that texels are cubes
#define CLOUD_DETAIL_SIZE 32     // texels

// Octaves of the field where clouds stand: their share, and their repeats in a repeat of the whole.
#define CLOUD_BILLOWS_SHARE 0.5f
#define CLOUD_BROAD_SHARE 0.38f
#define CLOUD_BROAD 0.31f
#define CLOUD_FINE_SHARE 0.12f
#define CLOUD_FINE 9.0f

#define CLOUD_G 0.85f            // mean cosine of what droplets scatter (Hansen 1971: 0.83 to 0.87)

struct Clouds {
    vec2 origin;      float perMetre;  float cover;    // the eye in the field, in repeats; repeats in a metre; mean share of the sky
    vec3 phase;       float edge;      // where the octaves are in their change; value of the field where a cloud begins
    vec3 sun;         float width;     // irradiance at their height; range of the field over which they thicken
    float base;       float thickness; // m above the eye; m
    float density;    float shadow;    // extinction in the thick of one, per m; share of the sun that their shadow takes
    vec4 map;                          // middle of the map of shadows from the eye, m; uv of the eye's own shadow
    vec2 sunward;     float planet;    // m that light goes aside in a metre of height, never flatter than the map can show; m from
    float through;    float albedo;    // the planet's centre to the eye; share of light through a closed cover; of the ground
    float on;         float mapLod;    // 0..1, grown in from none; of the field in a texel of the map
    float wet;        float snow;      // 0..1, how much of the ground rain wets and snow covers
    float water;      float unused1;   float unused2; // m above the eye of the water that weather does not reach; far below: none
};
SHARED_STRUCT_END(Clouds, 128)

// Henyey and Greenstein (1941), per sr: its integral over the sphere is 1.
SHARED_FUNCTION float henyeyGreenstein(float g, float cosine)
{
    float base = max(1.0f + g * g - 2.0f * g * cosine, 1e-6f);
    return (1.0f - g * g) / (4.0f * 3.14159265f * base * sqrt(base));
}

// Two lobes: a strong one ahead, and a weak one back, for the glory's side of a cloud. Per sr.
SHARED_FUNCTION float cloudPhase(float cosine)
{
    return mix(henyeyGreenstein(-0.3f, cosine), henyeyGreenstein(0.8f, cosine), 0.75f);
}

// Share of light that comes through a cloud of optical depth `tau` after any number of scatterings, absorbing nothing:
// the two-stream solution, Bohren, "Multiple scattering of light and some of its observable consequences" (1987).
SHARED_FUNCTION float throughCloud(float tau)
{
    return 2.0f / (2.0f + (1.0f - CLOUD_G) * tau);
}

// What droplets send on of the sun, per unit of its irradiance and per sr, behind `tau` of cloud: once scattered light, darker where
// little cloud has gathered it (the powder of Schneider and Vos 2015), and the rest, which is spread evenly.
SHARED_FUNCTION float cloudSunlight(float tau, float powder, float cosine)
{
    float once = cloudPhase(cosine) * exp(-tau) * mix(1.0f, powder, 0.5f - 0.5f * cosine);
    float twice = mix(1.0f / (4.0f * 3.14159265f), cloudPhase(cosine), 0.35f) * exp(-0.2f * tau) * 0.4f;
    return once + twice + 0.2f * throughCloud(tau);
}

// Light scattered within a step and what is left behind it, integrated against the step's own extinction: transmittance to the
// step's far end, and the weight of its source.
SHARED_FUNCTION vec2 cloudStep(float extinction, float metres)
{
    float t = exp(-extinction * metres);
    return vec2(t, 1.0f - t);
}

// Where a ray meets the shell `height` m above the eye, for an eye `r` m from the planet's centre: near and far distance, m;
// both negative when it does not. Written so that nothing cancels.
SHARED_FUNCTION vec2 cloudShell(float r, float up, float height)
{
    float half_ = r * up;
    float inside = height * (2.0f * r + height); // of the shell's radius squared less the eye's
    float discriminant = half_ * half_ + inside;
    if (discriminant < 0.0f) return vec2(-1.0f);
    float root = sqrt(discriminant);
    float far = half_ > 0.0f ? inside / (half_ + root) : root - half_; // of two roots, whose product is -inside
    float near = half_ > 0.0f ? -half_ - root : -inside / (root - half_ == 0.0f ? 1e-6f : root - half_);
    return vec2(min(near, far), max(near, far));
}

SHARED_END
#endif
