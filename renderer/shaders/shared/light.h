// Sun, sky, fog and clouds of one frame.
#ifndef SHARED_LIGHT_H
#define SHARED_LIGHT_H
#include "atmosphere.h"
#include "shared.h"

SHARED_BEGIN

struct Light {
    vec3 towardSun;     float ambient;       // unit, or towards the moon where that lights; factor on the light of the sky
    vec3 sunIrradiance; float sunRadius;     // of either, at the eye, behind the atmosphere; radians
    vec3 sunAbove;      float sunSolidAngle; // irradiance above the atmosphere; sr
    vec3 skyFloor;      float cloudsOn;      // what night gives to surfaces, from all around
    vec3 fogTint;       float fogDensity;     // at the eye's height, per m; 0: no fog
    vec3 sunAtClouds;   float fogHeight;      // irradiance at the height of the clouds; scale height, m
    vec4 groundShadow;                        // to the texture: uv = relative.xz * xy + zw
    Atmosphere atmosphere;
};
SHARED_STRUCT_END(Light, 176)

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
