// Sun, sky, fog and clouds of one frame.
#ifndef SHARED_LIGHT_H
#define SHARED_LIGHT_H
#include "atmosphere.h"
#include "shared.h"

#define SUN_HEIGHTS 12          // at which the sun's light is known
#define SUN_HIGHEST 8000.0f     // m above the sea

SHARED_BEGIN

struct Light {
    vec3 towardSun;     float ambient;       // unit, or towards the moon where that lights; factor on the light of the sky
    vec3 sunIrradiance; float sunRadius;     // of either, at the eye's height, behind the atmosphere; radians
    vec3 sunAbove;      float sunSolidAngle; // irradiance above the atmosphere; sr
    vec3 skyFloor;      float cloudsOn;      // what night gives to surfaces, from all around
    vec3 fogTint;       float fogDensity;     // at the eye's height, per m; 0: no fog
    vec3 sunAtClouds;   float fogHeight;      // irradiance at the height of the clouds; scale height, m
    vec4 groundShadow;                        // to the texture: uv = relative.xz * xy + zw
    vec4 sunAt[SUN_HEIGHTS];                  // irradiance on surfaces at heights, which lie as sunPlaceOf() says
    Atmosphere atmosphere;
};
SHARED_STRUCT_END(Light, 368)

// Where among them a height lies, m. The horizon sinks with the root of the height, and so they are spread.
SHARED_FUNCTION float sunPlaceOf(float height)
{
    return sqrt(clamp(height / SUN_HIGHEST, 0.0f, 1.0f)) * float(SUN_HEIGHTS - 1);
}

SHARED_FUNCTION float sunHeightOf(int place)
{
    float share = float(place) / float(SUN_HEIGHTS - 1);
    return SUN_HIGHEST * share * share;
}

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
