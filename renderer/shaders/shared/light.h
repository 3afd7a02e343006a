// Sun, sky, fog and clouds of one frame.
#ifndef SHARED_LIGHT_H
#define SHARED_LIGHT_H
#include "atmosphere.h"
#include "shared.h"

#define CLOUD_MAP_SIZE 256       // texels
#define CLOUD_MAP_METRES 12000.0f

SHARED_BEGIN

struct Light {
    vec3 towardSun;     float ambient;       // unit, or towards the moon where that lights; factor on the light of the sky
    vec3 sunIrradiance; float sunRadius;     // of either, at the eye, behind the atmosphere; radians
    vec3 sunAbove;      float sunSolidAngle; // irradiance above the atmosphere; sr
    vec3 skyFloor;      float cloudsOn;      // what night gives to surfaces, from all around
    vec3 fogTint;       float fogDensity;     // at the eye's height, per m; 0: no fog
    float fogHeight;    float cloudAltitude;  // scale height, m; m above the eye
    float cloudEdge;    float cloudWidth;     // value of the field where clouds begin, and range over which they thicken
    vec2 cloudOrigin;   vec2 cloudWind;       // eye in the tiling cloud field, m; unit
    vec3 sunAtClouds;   float unused;         // irradiance at the height of the clouds
    vec4 groundShadow;                        // to the texture: uv = relative.xz * xy + zw
    vec4 cloudMap;                            // middle of the map of cloud shadows in the field, m; uv of the eye's shadow
    Atmosphere atmosphere;
};
SHARED_STRUCT_END(Light, 224)

// What the sky gives to surfaces, integrated on the GPU when the sky changes.
struct SkyLight {
    vec4 irradiance[9]; // spherical harmonics of irradiance / pi, per unit of sun irradiance
    vec4 haze;          // what haze near the eye scatters, likewise
};
SHARED_STRUCT_END(SkyLight, 160)

SHARED_END
#endif
