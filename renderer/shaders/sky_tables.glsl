// The sky as its tables hold it.
#include "heavens.glsl"
#include "light.glsl"
#include "shared/atmosphere.h"
#include "sun_through_air.glsl"

layout(binding = SKY_VIEW_UNIT) uniform sampler2D skyViewTable;

float azimuthFromSun(vec3 direction)
{
    float across = dot(direction.xz, direction.xz) * dot(heavens.towardSun.xz, heavens.towardSun.xz);
    float cosine = dot(direction.xz, heavens.towardSun.xz) * inversesqrt(max(across, 1e-12));
    return acos(clamp(cosine, -1.0, 1.0));
}

// Per unit of sun irradiance.
vec3 skyView(float azimuth, float elevation)
{
    return textureLod(skyViewTable, skyViewUv(light.atmosphere.horizon, elevation, azimuth), 0.0).rgb;
}

vec3 skyView(vec3 direction)
{
    return skyView(azimuthFromSun(direction), asin(clamp(direction.y, -1.0, 1.0)));
}

// Airglow and scattered starlight and moonlight: more of it towards the horizon, where the layer is seen from its side.
vec3 nightSky(float height)
{
    float down = 1.0 - clamp(abs(height), 0.0, 1.0);
    return mix(heavens.glowOverhead, heavens.glow, down * down) * smoothstep(-0.3, 0.05, height);
}

vec3 skyRadiance(vec3 direction)
{
    return skyView(direction) * light.sunAbove + nightSky(direction.y);
}
