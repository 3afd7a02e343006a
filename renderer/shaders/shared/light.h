// Sun, sky, shadows, fog and clouds of one frame.
#ifndef SHARED_LIGHT_H
#define SHARED_LIGHT_H
#include "atmosphere.h"
#include "shared.h"

#define MAX_CASCADES 4

SHARED_BEGIN

struct Light {
    vec3 towardSun;     float ambient;       // unit; factor on the light of the sky
    vec3 sunIrradiance; float sunRadius;     // at the eye, behind the atmosphere; radians
    vec3 sunAbove;      float sunSolidAngle; // irradiance above the atmosphere; sr
    vec3 skyFloor;      float cloudsOn;      // radiance that the sky never falls below: stars and airglow
    mat4 shadowFromRelative[MAX_CASCADES];   // to [0, 1] on x and y, and depth
    vec4 cascadeEnd;                         // view depth, m
    vec4 cascadeTexel;                       // m
    int cascades;       float shadowSoftness; // texels
    float shadowBias;   float shadowTexel;    // texels; 1 / resolution
    vec3 fogTint;       float fogDensity;     // at the eye's height, per m; 0: no fog
    vec3 sunAtClouds;   float fogHeight;      // irradiance at the height of the clouds; scale height, m
    vec4 groundShadow;                        // to the texture: uv = relative.xz * xy + zw
    Atmosphere atmosphere;
};
SHARED_STRUCT_END(Light, 480)

// What the sky gives to surfaces, integrated on the GPU when the sky changes.
struct SkyLight {
    vec4 irradiance[9]; // spherical harmonics of irradiance / pi, per unit of sun irradiance
    vec4 haze;          // what haze near the eye scatters, likewise
    vec4 clear;         // irradiance / pi of the sky without clouds, on level ground, likewise
    vec4 overcast;      // and under a closed cover of clouds, all light together
};
SHARED_STRUCT_END(SkyLight, 192)

SHARED_END
#endif
