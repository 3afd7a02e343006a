// The sky as its tables hold it.
#include "light.glsl"
#include "shared/atmosphere.h"

layout(binding = SKY_VIEW_UNIT) uniform sampler2D skyViewTable;
layout(binding = TRANSMITTANCE_UNIT) uniform sampler2D transmittanceTable;

// Per unit of sun irradiance.
vec3 skyView(vec3 direction)
{
    vec2 flat_ = direction.xz;
    float across = dot(flat_, flat_) * dot(light.towardSun.xz, light.towardSun.xz);
    float cosine = dot(flat_, light.towardSun.xz) * inversesqrt(max(across, 1e-12));
    float azimuth = acos(clamp(cosine, -1.0, 1.0));
    float elevation = asin(clamp(direction.y, -1.0, 1.0));
    return textureLod(skyViewTable, skyViewUv(light.atmosphere.horizon, elevation, azimuth), 0.0).rgb;
}

vec3 skyRadiance(vec3 direction)
{
    return skyView(direction) * light.sunAbove + light.skyFloor * smoothstep(-0.3, 0.3, direction.y);
}

vec3 transmittanceToSpace(float altitude, float mu)
{
    return textureLod(transmittanceTable, transmittanceUv(altitude, mu), 0.0).rgb;
}
