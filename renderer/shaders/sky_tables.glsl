// The sky as its tables hold it.
#include "light.glsl"
#include "shared/atmosphere.h"

layout(binding = SKY_VIEW_UNIT) uniform sampler2D skyViewTable;
layout(binding = TRANSMITTANCE_UNIT) uniform sampler2D transmittanceTable;

float azimuthFromSun(vec3 direction)
{
    float across = dot(direction.xz, direction.xz) * dot(light.towardSun.xz, light.towardSun.xz);
    float cosine = dot(direction.xz, light.towardSun.xz) * inversesqrt(max(across, 1e-12));
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

vec3 nightSky(float height)
{
    return light.skyFloor * smoothstep(-0.3, 0.3, height);
}

vec3 skyRadiance(vec3 direction)
{
    return skyView(direction) * light.sunAbove + nightSky(direction.y);
}

vec3 transmittanceToSpace(float altitude, float mu)
{
    return textureLod(transmittanceTable, transmittanceUv(altitude, mu), 0.0).rgb;
}
